// Contact: where things come to rest, how far they slide, and what it costs.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "crossing.h"
#include "falling_sheets.h"
#include "sim/contact.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::falling;
using test::four_places;
using test::kGravity;
using test::run;
using test::world_of;

// Lets all sheets move; the ledger takes it as an edit.
void set_velocities(World& world, const std::vector<Vector3>& velocities) {
    WorldState state = world.snapshot();
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        for (std::size_t n = 0; n < state.sheets[s].mass.size(); ++n)
            state.sheets[s].velocity.set(n, velocities[s]);
    }
    world.restore(std::move(state));
    static_cast<void>(world.apply(world.params()));
}

struct Momentum {
    Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
};

Momentum momentum_of(const WorldState& state) {
    Momentum sum;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            const Vector3 p = sheet.mass[n] * sheet.velocity.at(n);
            sum.linear += p;
            sum.angular += sheet.position.at(n).cross(p);
        }
    }
    return sum;
}

Vector3 centre_of(const SheetState& sheet) {
    Vector3 sum = Vector3::Zero();
    double mass = 0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        sum += sheet.mass[n] * sheet.position.at(n);
        mass += sheet.mass[n];
    }
    return sum / mass;
}

TEST(Contact, AFlakeFallsAtRestToHalfItsThicknessAboveTheGround) {
    const Params p = falling();
    World world = world_of(p, {Vector3(0, 0.05, 0)});
    const double half = 0.5 * contact_thickness(p);
    double highest_after = 0, lowest = 1;
    const double landing = std::sqrt(2 * 0.05 / kGravity);
    while (world.state().time < 1.0) {
        run(world, 0.5 * world.tick_duration());
        for (const double y : world.state().sheets[0].position.y) {
            lowest = std::min(lowest, y);
            if (world.state().time > landing + 0.02) highest_after = std::max(highest_after, y);
        }
    }
    EXPECT_NEAR(lowest, half, 0.02 * half);
    EXPECT_NEAR(highest_after, half, 0.10 * half);
    const SheetState& flake = world.state().sheets[0];
    double mass = 0, kinetic = 0;
    for (std::size_t n = 0; n < flake.mass.size(); ++n) {
        EXPECT_NEAR(flake.position.y[n], half, 1e-3 * half);
        mass += flake.mass[n];
        kinetic += 0.5 * flake.mass[n] * flake.velocity.at(n).squaredNorm();
    }
    EXPECT_LT(kinetic, 1e-12);
    // all that it had when it fell went into the ground
    const double fallen = mass * kGravity * (0.05 - half);
    EXPECT_NEAR(world.state().energy.work_contact, -fallen, 1e-3 * fallen);
}

TEST(Contact, AFlakeThatSlidesStopsWhereCoulombSaysSo) {
    const Params p = falling();
    const double half = 0.5 * contact_thickness(p), speed = 0.5;
    World world = world_of(p, {Vector3(0, half, 0)});
    set_velocities(world, {Vector3(speed, 0, 0)});
    const double from = centre_of(world.state().sheets[0]).x();
    run(world, 0.5);
    const double way = centre_of(world.state().sheets[0]).x() - from;
    const double expected = speed * speed / (2 * p.contact.ground_friction * kGravity);
    EXPECT_NEAR(way, expected, 0.02 * expected);
    EXPECT_LT(world.state().energy.kinetic, 1e-15);
}

TEST(Contact, WithoutFrictionItSlidesOn) {
    Params p = falling();
    p.contact.ground_friction = 0;
    World world = world_of(p, {Vector3(0, 0.5 * contact_thickness(p), 0)});
    set_velocities(world, {Vector3(0.5, 0, 0)});
    const double from = centre_of(world.state().sheets[0]).x();
    run(world, 0.5);
    const double way = centre_of(world.state().sheets[0]).x() - from;
    EXPECT_NEAR(way, 0.5 * world.state().time, 1e-12);
}

TEST(Contact, SheetsThatCollideKeepTheirMomentum) {
    // friction acts on two surfaces that are a thickness apart, so it turns the pair a little
    for (const double friction : {0.0, 0.4}) {
        Params p = test::plain(6, 8);
        p.springs.stiffness_scale = 40;
        p.contact.friction = friction;
        World world = world_of(p, {Vector3(0, 0.0, 0), Vector3(0.011, 0.010, 0.017)});
        set_velocities(world, {Vector3(0.1, 0.4, 0), Vector3(0, -0.3, 0.2)});
        const Momentum before = momentum_of(world.state());
        const double energy = world.state().energy.kinetic;
        EXPECT_GT(run(world, 0.5).contacts, 0);
        const Momentum after = momentum_of(world.state());
        EXPECT_LT((after.linear - before.linear).norm(), 1e-13 * before.linear.norm());
        EXPECT_LT((after.angular - before.angular).norm(),
                  (friction > 0 ? 2e-2 : 5e-3) * before.angular.norm());
        EXPECT_LT(world.state().energy.kinetic, 0.9 * energy);
        EXPECT_EQ(test::count_crossings(world.state()), 0);
    }
}

TEST(Contact, EvaluatesTheSpringsOnceForEachSubStepAndOnceMoreForEachTick) {
    World world = world_of(falling(), {Vector3(0, 0.01, 0)});
    std::int64_t contacts = 0;
    for (int tick = 0; tick < 12; ++tick) {
        const StepReport report = world.step();
        ASSERT_TRUE(report.ok()) << cause_text(report);
        EXPECT_EQ(report.counters.right_hand_sides, report.counters.substeps + 1);
        contacts += report.counters.contacts;
    }
    EXPECT_GT(contacts, 0);
}

TEST(Contact, EveryIntegratorStopsAFallingFlake) {
    for (const IntegratorKind integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet, IntegratorKind::Rk4,
          IntegratorKind::Dopri5, IntegratorKind::Rkf78, IntegratorKind::AdamsBashforthMoulton,
          IntegratorKind::Rosenbrock}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        Params p = falling();
        p.numerics.integrator = integrator;
        World world = world_of(p, {Vector3(0, 0.02, 0), Vector3(0.003, 0.03, 0.004)});
        run(world, 0.4);
        EXPECT_NEAR(centre_of(world.state().sheets[0]).y(), 0.5 * contact_thickness(p), 2e-5);
        EXPECT_NEAR(centre_of(world.state().sheets[1]).y(), 1.5 * contact_thickness(p), 5e-5);
    }
}

TEST(Contact, SheetsFarApartOrWithContactOffAreTheSameBitForBitAndCostNothing) {
    const std::vector<Vector3> far = {Vector3(0, 0.3, 0), Vector3(0, 0.6, 0)};
    std::uint64_t hash[2];
    for (const bool on : {true, false}) {
        Params p = falling();
        p.world.ground = p.contact.sheets = on;
        World world = world_of(p, far);
        const StepCounters work = run(world, 0.1);
        EXPECT_EQ(work.contacts, 0);
        EXPECT_EQ(work.contact_visited, 0);
        EXPECT_EQ(work.contact_pairs, 0);
        hash[on ? 1 : 0] = world.hash();
    }
    EXPECT_EQ(hash[0], hash[1]);
}

TEST(Contact, IsTheSameBitForBitOnAnyNumberOfThreadsAndWithoutSkipping) {
    std::uint64_t hashes[4];
    for (int i = 0; i < 4; ++i) {
        Params p = falling();
        p.sheet.rows = 9, p.sheet.columns = 12;
        p.sheet.imperfection = 0.001;
        p.contact.self = true;
        p.numerics.skip = i < 3;
        World world = world_of(p, four_places(), i < 3 ? i + 1 : 1);
        EXPECT_GT(run(world, 0.25).contacts, 0);
        hashes[i] = world.hash();
    }
    for (const std::uint64_t hash : hashes)
        EXPECT_EQ(hash, hashes[0]);
}

TEST(Contact, WhatRestsFallsAsleepAndWakesWhenSomethingFallsOnIt) {
    Params p = falling();
    p.numerics.sleep_speed = 1e-3;
    World world = world_of(p, {Vector3(0, 0.01, 0), Vector3(0.003, 0.8, 0.004)});
    bool lower_slept = false, woke = false;
    StepReport report;
    while (world.state().time < 2.0) {
        report = world.step();
        ASSERT_TRUE(report.ok()) << cause_text(report);
        const bool asleep = report.counters.rows_asleep >= 7;
        woke = woke || (lower_slept && !asleep);
        lower_slept = lower_slept || asleep;
    }
    EXPECT_TRUE(lower_slept);
    EXPECT_TRUE(woke);
    EXPECT_EQ(report.counters.rows_asleep, 14) << "both rest in the end";
    EXPECT_LT(world.state().energy.kinetic, 1e-15);
    EXPECT_GT(centre_of(world.state().sheets[1]).y(), 1.4 * contact_thickness(p));
}

}  // namespace
}  // namespace ember
