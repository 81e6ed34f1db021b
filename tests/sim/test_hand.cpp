// A hand that pulls: its closed form, its reach, and its place in the ledger.
#include <gtest/gtest.h>

#include <cmath>

#include "rig.h"
#include "sim/hand.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

// Holds the middle of a sheet of 8 x 8 cells of 10 mm.
HandParams middle() {
    HandParams hand;
    hand.on = true;
    hand.row = hand.column = 4;
    hand.radius = 0.025;
    return hand;
}

TEST(Hand, PullsAllThatItHoldsAlikeAndNothingBeyond) {
    Rig rig(plain(8, 8));
    gather_loads(rig.params, rig.sheet, {}, rig.loads);
    HandParams hand = middle();
    const std::size_t held = 4 * 9 + 4;
    hand.x = rig.sheet.position.x[held] + 0.1;
    hand.y = rig.sheet.position.y[held];
    hand.z = rig.sheet.position.z[held];
    pull_by_hand(hand, rig.lattice, rig.sheet, rig.loads);
    const double acceleration = 0.1 / (hand.response * hand.response);
    const auto accelerated = [&](std::size_t n) {
        return rig.loads.force.x[n] / rig.sheet.mass[n];
    };
    EXPECT_NEAR(accelerated(held), acceleration, 1e-9);
    const double at_ring = std::pow(1.0 - 0.01 * 0.01 / (0.025 * 0.025), 2);
    EXPECT_NEAR(accelerated(held + 1), acceleration * at_ring, 1e-9);
    EXPECT_NEAR(accelerated(held + 9), acceleration * at_ring, 1e-9);
    EXPECT_EQ(accelerated(held + 3), 0.0) << "30 mm away";
    EXPECT_NEAR(rig.loads.force.y[held], 0.0, 1e-15);
}

TEST(Hand, AFreeSheetFollowsAsACriticallyDampedSpringDoes) {
    Params p = plain(2, 2);
    p.numerics.tick_rate = 2000;
    p.springs.stiffness_scale = 100;
    p.hand = middle();
    p.hand.row = p.hand.column = 1;
    p.hand.radius = 1000;  // all of it alike
    World world = make_world(p);
    const double start = world.state().sheets[0].position.x[4];
    p.hand.x = start + 0.1;
    p.hand.y = world.state().sheets[0].position.y[4];
    p.hand.z = world.state().sheets[0].position.z[4];
    ASSERT_TRUE(world.apply(p));
    for (int i = 0; i < 400; ++i)
        ASSERT_TRUE(world.step().ok());
    // x(t) = p - (p - x0) (1 + t/T) exp(-t/T), T the response
    const double t = 0.2 / p.hand.response;
    const double expected = start + 0.1 * (1 - (1 + t) * std::exp(-t));
    EXPECT_NEAR(world.state().sheets[0].position.x[4], expected, 1e-3);
    EXPECT_NEAR(world.state().energy.work_fire, world.state().energy.kinetic, 1e-9)
        << "all work has become motion, and the ledger knows it";
}

TEST(Hand, WhatIsNotOnTheSheetIsNotHeld) {
    Rig rig(plain(8, 8));
    gather_loads(rig.params, rig.sheet, {}, rig.loads);
    HandParams hand = middle();
    hand.row = 9;
    hand.x = 1;
    pull_by_hand(hand, rig.lattice, rig.sheet, rig.loads);
    for (const double force : rig.loads.force.x)
        EXPECT_EQ(force, 0.0);
}

}  // namespace
}  // namespace ember
