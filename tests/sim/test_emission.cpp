// Where the particles of burning paper are born.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "rig.h"
#include "sim/fire.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

// Where particles of one burning node start, from the node [m].
std::vector<Vector3> starts(const Params& params, int row, int column) {
    Rig rig(params);
    const auto n = static_cast<std::size_t>(rig.site(row, column));
    rig.sheet.phase[n] = Phase::Burning;
    rig.sheet.ignition_time[n] = 0;
    FireState fire;
    advance_fire(params, {}, 1, 0, 0.4, {rig.sheet}, {&rig.lattice}, {nullptr}, fire, rig.counters);
    std::vector<Vector3> offsets;
    for (std::size_t i = 0; i < fire.size(); ++i)
        offsets.push_back(fire.position.at(i) - rig.sheet.position.at(n));
    return offsets;
}

Params still_fire() {
    Params p = plain(4, 4);
    p.fire.lateral_speed = p.fire.buoyancy = 0;
    p.fire.emission = 1e9;
    return p;
}

TEST(Fire, AFlameStandsOffItsNode) {
    Params p = still_fire();
    p.fire.standoff = 0.003;
    for (const Vector3& offset : starts(p, 2, 2))
        EXPECT_NEAR((offset - Vector3(0, 0.003, 0)).norm(), 0, 1e-15);
}

// The hat function of a node of cells h wide has the mean 0 and the variance h^2/6 along each axis.
TEST(Fire, AreaEmissionStartsWhereTheNodeStandsForTheSheet) {
    Params p = still_fire();
    p.fire.area_emission = true;
    const double h = 0.01;
    Vector3 mean = Vector3::Zero(), square = Vector3::Zero();
    const auto inner = starts(p, 2, 2);
    ASSERT_GT(inner.size(), 10000u);
    for (const Vector3& offset : inner) {
        EXPECT_LE(offset.cwiseAbs().maxCoeff(), h);
        mean += offset / static_cast<double>(inner.size());
        square += offset.cwiseAbs2() / static_cast<double>(inner.size());
    }
    EXPECT_LT(mean.norm(), 0.02 * h);
    EXPECT_NEAR(square.x(), h * h / 6, 0.03 * h * h / 6);
    EXPECT_NEAR(square.z(), h * h / 6, 0.03 * h * h / 6);
    EXPECT_EQ(square.y(), 0);
    for (const Vector3& offset : starts(p, 0, 0)) {  // never beyond the border
        EXPECT_GE(offset.x(), 0);
        EXPECT_GE(offset.z(), 0);
    }
}

TEST(Fire, AnotherSeedIsAnotherFireOfTheSameRate) {
    Params p = still_fire();
    p.fire.emission = 1e8;
    const Rig rig(p);
    LighterParams lighter;
    lighter.rate = 2000;
    const auto fire_of = [&](std::uint64_t seed) {
        FireState fire;
        StepCounters counters;
        advance_fire(p, {lighter}, seed, 0, 0.4, {rig.sheet}, {&rig.lattice}, {nullptr}, fire,
                     counters);
        return fire;
    };
    const FireState one = fire_of(1), again = fire_of(1), other = fire_of(2);
    EXPECT_EQ(one.birth, again.birth);
    EXPECT_EQ(one.position.x, again.position.x);
    ASSERT_GT(one.size(), 100u);
    EXPECT_NEAR(static_cast<double>(other.size()), static_cast<double>(one.size()),
                6 * std::sqrt(static_cast<double>(one.size())));
    std::vector<double> shared;
    std::ranges::set_intersection(one.birth, other.birth, std::back_inserter(shared));
    EXPECT_TRUE(shared.empty()) << "another seed has the same " << shared.size() << " births";
}

}  // namespace
}  // namespace ember
