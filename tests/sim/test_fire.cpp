// Particles of fire: rates, lives, and paths that refine with the tick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "rig.h"
#include "sim/fire.h"
#include "sim/lighter.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

// Fire of the lighter and one moving, burning node after `time` [s] in ticks of `dt`.
FireState burn_for(double time, double dt) {
    Params p = plain(2, 2);
    p.lighter.on = true;
    Rig rig(p);
    rig.sheet.phase[4] = Phase::Burning;
    rig.sheet.ignition_time[4] = 0;
    const Vector3 velocity(0.3, 0.1, 0);
    FireState fire;
    const auto ticks = static_cast<int>(std::lround(time / dt));
    const Vector3 start = rig.sheet.position.at(4);
    for (int i = 0; i < ticks; ++i) {
        rig.sheet.position.set(4, start + velocity * (i * dt));
        rig.sheet.velocity.set(4, velocity);
        std::vector<SheetState> sheets{rig.sheet};
        advance_fire(p, {p.lighter}, 1, i * dt, dt, sheets, {&rig.lattice}, {nullptr}, fire,
                     rig.counters);
    }
    return fire;
}

TEST(Fire, HalvingTheTickRefinesTheSameFire) {
    const FireState whole = burn_for(0.4, 1.0 / 60), half = burn_for(0.4, 1.0 / 120);
    const std::set<std::uint64_t> a(whole.id.begin(), whole.id.end()),
        b(half.id.begin(), half.id.end());
    EXPECT_GT(a.size(), 100u);
    EXPECT_EQ(a.size(), whole.size());
    EXPECT_EQ(a, b);  // the same particles
    double worst = 0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const auto j = static_cast<std::size_t>(
            std::find(half.id.begin(), half.id.end(), whole.id[i]) - half.id.begin());
        EXPECT_NEAR(whole.birth[i], half.birth[j], 1e-12);
        EXPECT_NEAR(whole.temperature[i], half.temperature[j], 1e-9);
        worst = std::max(worst, (whole.position.at(i) - half.position.at(j)).norm());
    }
    EXPECT_LT(worst, 1e-4);  // places: second order in the tick, through the frozen lift
}

TEST(Fire, RatesAndLivesAreWhatTheParametersSay) {
    Params p = plain(2, 2);
    p.lighter.on = true;
    FireState fire;
    StepCounters counters;
    const std::vector<SheetState> none;
    for (int i = 0; i < 180; ++i)
        advance_fire(p, {p.lighter}, 1, i / 60.0, 1 / 60.0, none, {}, {}, fire, counters);
    // 250/s for 1.5 s, to one particle
    EXPECT_NEAR(static_cast<double>(counters.particles_born), 375.0, 1.0);
    EXPECT_EQ(fire.size(), 0u);  // all dead by 1.5 + 0.7 s
    EXPECT_FALSE(lighter_lit(p.lighter, 2.0, 1 / 60.0));
    EXPECT_TRUE(lighter_lit(p.lighter, 1.0, 1 / 60.0));
}

}  // namespace
}  // namespace ember
