// Leaving out cold parts of a sheet changes the work and not one bit of the result.
#include <gtest/gtest.h>

#include "heat_rig.h"

namespace ember {
namespace {

using test::HeatRig;
using test::kAmbient;
using test::kHeatSolvers;
using test::plain;
using test::tube;

struct Outcome {
    std::vector<double> temperature;
    HeatLedger ledger;
    StepCounters counters;
};

Outcome burn(const Params& params, HeatSolverKind solver, bool skip, double limits) {
    HeatRig rig(params, solver);
    rig.params.numerics.skip = skip;
    rig.cut_at_random(0.05);
    rig.sheet.temperature[rig.site(5, 9)] = 1000.0;
    std::vector<double> source(rig.sheet.temperature.size(), 0.0);
    source[rig.site(20, 30)] = 9000.0;
    rig.sheet.phase[rig.site(5, 9)] = Phase::Burning;
    const double dt = limits * rig.limit();
    HeatLedger ledger;
    for (int i = 0; i < 6; ++i) {
        rig.conduct(dt);
        exchange_heat(rig.sheet, rig.params, source, dt, ledger, rig.counters);
        ledger.stored = stored_heat(rig.sheet, rig.params.paper, kAmbient);
    }
    return {rig.sheet.temperature, ledger, rig.counters};
}

void expect_same(const Params& params, HeatSolverKind solver, double limits) {
    const Outcome some = burn(params, solver, true, limits);
    const Outcome all = burn(params, solver, false, limits);
    EXPECT_EQ(some.temperature, all.temperature) << static_cast<int>(solver) << ' ' << limits;
    EXPECT_EQ(some.ledger.lost_air, all.ledger.lost_air);
    EXPECT_EQ(some.ledger.given_burning, all.ledger.given_burning);
    EXPECT_EQ(some.ledger.given_fire, all.ledger.given_fire);
    EXPECT_EQ(some.ledger.stored, all.ledger.stored);
    EXPECT_LT(some.counters.heat_nodes, all.counters.heat_nodes);
    EXPECT_EQ(some.counters.heat_guarded, all.counters.heat_guarded);
}

TEST(HeatSkip, GivesTheSameBitsUnderEverySolver) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        for (const double limits : {0.9, 2.5, 12.0}) {
            expect_same(plain(100, 200), solver, limits);
            expect_same(tube(99, 200), solver, limits);
        }
    }
}

TEST(HeatSkip, HeatCrossesASeamNextToAPartialTile) {
    // 33 rows: the last tile before the seam is one row high
    for (const HeatSolverKind solver : kHeatSolvers) {
        for (const bool skip : {true, false}) {
            HeatRig rig(tube(33, 40), solver);
            rig.params.numerics.skip = skip;
            rig.sheet.temperature[rig.site(0, 20)] = 1200.0;
            rig.conduct(7.5 * rig.limit());
            for (Index k = 1; k <= 6; ++k) {
                const double before = rig.sheet.temperature[rig.site(33 - k, 20)];
                const double after = rig.sheet.temperature[rig.site(k, 20)];
                EXPECT_GT(before, kAmbient) << k;
                EXPECT_NEAR(before, after, 1e-9) << k;
            }
        }
    }
}

TEST(HeatSkip, AColdSheetOfAnySolverCountsNoWork) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        HeatRig rig(plain(30, 40), solver);
        EXPECT_EQ(rig.conduct(1.0), HeatSolverKind::Auto);
        EXPECT_EQ(rig.counters.heat_nodes + rig.counters.heat_substeps, 0);
    }
}

TEST(HeatSkip, FollowsAChangeOfAmbient) {
    HeatRig rig(plain(60, 90), HeatSolverKind::Ftcs);
    rig.sheet.temperature[rig.site(30, 40)] = 1000.0;
    rig.conduct(3 * rig.limit());
    rig.params.heat.ambient = 280.0;  // now all of the sheet is warm
    const double before = rig.stored();
    for (int i = 0; i < 20; ++i)
        rig.conduct(3 * rig.limit());
    EXPECT_NEAR(rig.stored() / before, 1.0, 1e-12);
    for (const double t : rig.sheet.temperature)
        EXPECT_GE(t, kAmbient - 1e-10);
}

}  // namespace
}  // namespace ember
