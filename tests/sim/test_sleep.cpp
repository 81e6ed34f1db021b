// Rows at rest are not moved, and wake when something reaches them.
#include <gtest/gtest.h>

#include <algorithm>

#include "sim/world.h"

namespace ember {
namespace {

// A sheet that hangs still, until a lighter is lit beneath it.
Params at_rest(double sleep_speed) {
    Params p;
    p.sheet.rows = 10;
    p.sheet.columns = 14;
    p.sheet.width = 0.06;
    p.sheet.height = 0.09;
    p.numerics.sleep_speed = sleep_speed;
    p.world.air_drag = 3.0;
    p.lighter.start = 3.0;
    p.lighter.x = -0.03;
    p.lighter.y = 0.34;
    return p;
}

StepReport advance(World& world, int ticks) {
    StepReport report;
    for (int i = 0; i < ticks; ++i) {
        report = world.step();
        EXPECT_TRUE(report.ok()) << report.reason;
    }
    return report;
}

TEST(Sleep, ASheetAtRestIsNotMovedUntilTheFireReachesIt) {
    World world = make_world(at_rest(1e-4));
    const StepReport resting = advance(world, 170);
    EXPECT_EQ(resting.counters.right_hand_sides, 0);
    EXPECT_EQ(resting.counters.rows_asleep, 11);
    EXPECT_EQ(world.state().energy.kinetic, 0);
    EXPECT_GT(world.state().energy.loss_sleep, 0);
    const StepReport lit = advance(world, 60);
    EXPECT_LT(lit.counters.rows_asleep, 11);
    EXPECT_GT(lit.counters.right_hand_sides, 0);
}

TEST(Sleep, ASleeperIsNoFurtherOffThanItsSpeedAllows) {
    constexpr double kSpeed = 1e-4;
    World sleeping = make_world(at_rest(kSpeed)), awake = make_world(at_rest(0));
    for (int tick = 0; tick < 170; ++tick) {
        advance(sleeping, 1);
        advance(awake, 1);
    }
    double furthest = 0;
    for (std::size_t n = 0; n < awake.state().sheets[0].mass.size(); ++n) {
        furthest = std::max(furthest, (awake.state().sheets[0].position.at(n) -
                                       sleeping.state().sheets[0].position.at(n))
                                          .norm());
    }
    EXPECT_GT(furthest, 0);
    EXPECT_LT(furthest, kSpeed * 170 / 60.0);
}

TEST(Sleep, WithoutASpeedNothingSleeps) {
    World world = make_world(at_rest(0));
    const StepReport report = advance(world, 170);
    EXPECT_EQ(report.counters.rows_asleep, 0);
    EXPECT_GT(report.counters.right_hand_sides, 0);
}

TEST(Sleep, AChangedParameterWakes) {
    Params p = at_rest(1e-4);
    World world = make_world(p);
    ASSERT_EQ(advance(world, 170).counters.right_hand_sides, 0);
    p.world.gravity *= 2;
    ASSERT_TRUE(world.apply(p));
    EXPECT_GT(advance(world, 1).counters.right_hand_sides, 0);
}

}  // namespace
}  // namespace ember
