// Burning paper loses mass: the ledger, and that it does not know the tick.
#include <gtest/gtest.h>

#include <vector>

#include "rig.h"
#include "sim/burning.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

TEST(Burning, ANodeLosesMassAtTheBurnRateUntilTheResidueIsLeft) {
    Params p = plain(2, 2);
    Rig rig(p);
    std::vector<Index> out;
    rig.sheet.temperature[4] = p.burning.ignition;  // the inner node, one cell of area
    const double start = rig.sheet.mass[4], dt = 1.0 / 60, area = 1e-4;
    double gone = update_phases(p, dt, dt, nullptr, rig.sheet, out, rig.counters);
    EXPECT_EQ(rig.sheet.phase[4], Phase::Burning);
    EXPECT_EQ(rig.sheet.ignition_time[4], dt);
    EXPECT_EQ(gone, 0.0);
    gone = update_phases(p, 2 * dt, dt, nullptr, rig.sheet, out, rig.counters);
    EXPECT_NEAR(gone, p.burning.burn_rate * area * dt, 1e-18);
    EXPECT_NEAR(start - rig.sheet.mass[4], gone, 1e-18);
    int ticks = 2;
    for (; rig.sheet.phase[4] == Phase::Burning; ++ticks) {
        gone += update_phases(p, (ticks + 1) * dt, dt, nullptr, rig.sheet, out, rig.counters);
    }
    EXPECT_NEAR(rig.sheet.mass[4], 0.2 * start, 1e-20);
    EXPECT_NEAR(gone, 0.8 * start, 1e-17);  // the ledger
    EXPECT_EQ(out, std::vector<Index>{4});
    // 0.8 G / burn_rate = 1.067 s, to a tick
    EXPECT_NEAR(rig.sheet.burnout_time[4] - rig.sheet.ignition_time[4], 0.8 * 0.080 / 0.060,
                1.5 * dt);
    for (std::size_t n = 0; n < 9; ++n) {
        EXPECT_EQ(rig.sheet.phase[n] == Phase::Unburnt, n != 4);
    }
}

TEST(Burning, LossesDoNotDependOnTheTick) {
    Params p = plain(2, 2);
    const auto gone_after = [&](double dt, int ticks) {
        Rig rig(p);
        rig.sheet.phase[4] = Phase::Burning;
        std::vector<Index> out;
        double gone = 0;
        for (int i = 0; i < ticks; ++i)
            gone += update_phases(p, (i + 1) * dt, dt, nullptr, rig.sheet, out, rig.counters);
        return gone;
    };
    const double expected = p.burning.burn_rate * 1e-4 * 0.5;  // a cell, for half a second
    EXPECT_NEAR(gone_after(1.0 / 30, 15) / expected, 1.0, 1e-9);
    EXPECT_NEAR(gone_after(1.0 / 240, 120) / expected, 1.0, 1e-9);
}

TEST(Burning, HeldNodesDoNotBurn) {
    Params p = plain(2, 2);
    p.sheet.held = HeldEdge::MainStart;
    Rig rig(p);
    rig.sheet.temperature.assign(9, 2000.0);
    std::vector<Index> out;
    update_phases(p, 0, 0.01, nullptr, rig.sheet, out, rig.counters);
    EXPECT_EQ(rig.sheet.phase[rig.site(1, 0)], Phase::Unburnt);
    EXPECT_EQ(rig.sheet.phase[rig.site(1, 1)], Phase::Burning);
}

}  // namespace
}  // namespace ember
