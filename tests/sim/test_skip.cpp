// Leaving out work changes no bit; and where there is nothing to do, nothing is done.
#include <gtest/gtest.h>

#include "rig.h"
#include "sim/world.h"
#include "tests/sim/small_sheet.h"

namespace ember {
namespace {

Params burning_sheet(bool skip) {
    Params p = test::small_sheet();
    p.numerics.skip = skip;
    return p;
}

struct Outcome {
    std::uint64_t hash = 0;
    StepCounters work;  // in all ticks
    Totals totals;
};

Outcome run(const Params& p, int ticks) {
    World world = make_world(p);
    Outcome outcome;
    for (int i = 0; i < ticks; ++i) {
        const StepReport report = world.step();
        EXPECT_TRUE(report.ok()) << report.reason;
        std::vector<std::int64_t> counts;
        for_each_counter(report.counters,
                         [&](const char*, std::int64_t c) { counts.push_back(c); });
        std::size_t at = 0;
        for_each_counter(outcome.work,
                         [&](const char*, std::int64_t& sum) { sum += counts[at++]; });
    }
    outcome.hash = world.hash();
    outcome.totals = world.state().totals;
    return outcome;
}

void expect_same_burn(Params p, int ticks) {
    p.numerics.skip = true;
    const Outcome skipping = run(p, ticks);
    p.numerics.skip = false;
    const Outcome whole = run(p, ticks);
    EXPECT_EQ(skipping.hash, whole.hash);
    EXPECT_LT(skipping.work.heat_nodes, whole.work.heat_nodes);
    EXPECT_LE(skipping.work.coupling_pairs, whole.work.coupling_pairs);
}

TEST(Skip, ABurnWithCracksIsTheSameBitForBit) {
    Params p = burning_sheet(true);
    ASSERT_GT(run(p, 240).totals.cuts, 0);
    expect_same_burn(p, 240);
}

TEST(Skip, EveryHeatSolverIsTheSameBitForBit) {
    for (const auto solver : {HeatSolverKind::Ftcs, HeatSolverKind::Rkl2, HeatSolverKind::Adi}) {
        Params p = burning_sheet(true);
        p.numerics.heat_solver = solver;
        expect_same_burn(p, 60);
    }
}

TEST(Skip, TwoSheetsAndATubeAreTheSameBitForBit) {
    Params p = burning_sheet(true);
    p.sheet.count = 2;
    expect_same_burn(p, 120);
    p.sheet.count = 1;
    p.sheet.shape = SheetShape::Cylinder;
    expect_same_burn(p, 120);
}

TEST(Skip, WithoutFireNothingIsDoneForIt) {
    Params p = burning_sheet(true);
    p.lighter.on = false;
    const Outcome idle = run(p, 30);
    EXPECT_EQ(idle.work.particles_moved, 0);
    EXPECT_EQ(idle.work.coupling_pairs, 0);
    EXPECT_EQ(idle.work.heat_nodes, 0);
    EXPECT_EQ(idle.work.heat_substeps, 0);
    EXPECT_EQ(idle.work.nodes_burning, 0);
    EXPECT_EQ(idle.work.springs_shrunk, 0);
    EXPECT_EQ(idle.work.cuts, 0);
    EXPECT_GT(idle.work.right_hand_sides, 0);
    p.numerics.skip = false;
    EXPECT_EQ(run(p, 30).hash, idle.hash);
}

}  // namespace
}  // namespace ember
