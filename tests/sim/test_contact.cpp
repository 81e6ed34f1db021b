// Contact: where things come to rest, how far they slide, and that nothing passes through.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "crossing.h"
#include "rig.h"
#include "sim/contact.h"
#include "sim/world.h"

namespace ember {
namespace {

constexpr double kGravity = 9.81;

Params falling() {
    Params p = test::plain(6, 8);
    p.world.gravity = kGravity;
    p.world.ground = true;
    p.springs.stiffness_scale = 40;
    return p;
}

// A horizontal sheet of `params` with its first corner at `origin`.
SheetPlan plan_at(const Params& params, const Vector3& origin) {
    SheetPlan plan = make_scene(params).sheets[0];
    plan.origin = origin;
    return plan;
}

World world_of(const Params& params, const std::vector<Vector3>& origins, int threads = 1) {
    Scene scene;
    for (const Vector3& origin : origins)
        scene.sheets.push_back(plan_at(params, origin));
    return World(scene, params, threads);
}

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

StepCounters run(World& world, double seconds) {
    StepCounters sum;
    for (double t = 0; t < seconds; t += world.tick_duration()) {
        const StepReport report = world.step();
        EXPECT_TRUE(report.ok()) << cause_text(report);
        sum.contacts += report.counters.contacts;
        sum.contact_visited += report.counters.contact_visited;
        sum.contact_pairs += report.counters.contact_pairs;
    }
    return sum;
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

std::vector<Vector3> four_places() {
    return {Vector3(0, 0.020, 0), Vector3(0.004, 0.040, -0.003), Vector3(-0.003, 0.060, 0.006),
            Vector3(0.007, 0.080, 0.002)};
}

// Least height of a node of one sheet over the quad of another that lies below or above it.
double least_gap(const SheetState& upper, const SheetState& lower) {
    double least = 1;
    for (std::size_t n = 0; n < upper.mass.size(); ++n) {
        const Vector3 p = upper.position.at(n);
        for (const Quad& quad : lower.quads) {
            const auto corner = [&](std::size_t k) {
                return lower.position.at(static_cast<std::size_t>(quad[k]));
            };
            for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
                const Vector3 a = corner(0), u = corner(k) - a, v = corner(k + 1) - a, w = p - a;
                const double area = u.x() * v.z() - u.z() * v.x();
                const double s = (w.x() * v.z() - w.z() * v.x()) / area;
                const double t = (u.x() * w.z() - u.z() * w.x()) / area;
                if (s < 0 || t < 0 || s + t > 1) continue;
                least = std::min(least, w.y() - s * u.y() - t * v.y());
            }
        }
    }
    return least;
}

TEST(Contact, AStackOfFallenSheetsLiesInOrderAndNothingHasPassedThrough) {
    Params p = falling();
    p.sheet.imperfection = 0.001;
    World world = world_of(p, four_places());
    while (world.state().time < 1.5) {
        run(world, 0.5 * world.tick_duration());
        ASSERT_EQ(test::count_crossings(world.state()), 0);
    }
    const double thickness = contact_thickness(p);
    for (std::size_t s = 1; s < 4; ++s)
        EXPECT_GT(least_gap(world.state().sheets[s], world.state().sheets[s - 1]), 0.9 * thickness);
    EXPECT_LT(world.state().energy.kinetic, 1e-9);
}

TEST(Contact, WithoutItTheSameSheetsPassThrough) {
    Params p = falling();
    p.sheet.imperfection = 0.001;
    p.contact.sheets = false;
    p.numerics.tick_rate = 240;  // a sheet of 0.1 mm passes another in a moment
    World world = world_of(p, four_places());
    int crossings = 0;
    while (world.state().time < 0.3) {
        run(world, 0.5 * world.tick_duration());
        crossings += test::count_crossings(world.state());
    }
    EXPECT_GT(crossings, 10);
    for (std::size_t s = 1; s < 4; ++s)
        EXPECT_LT(least_gap(world.state().sheets[s], world.state().sheets[s - 1]),
                  0.1 * contact_thickness(p));
}

// Bends a sheet into a U that lies on its side: columns run along two flat arms and half a circle.
void fold(World& world, double radius) {
    WorldState state = world.snapshot();
    SheetState& sheet = state.sheets[0];
    const int columns = world.scene().sheets[0].columns;
    const double spacing = world.scene().sheets[0].height / columns;
    const double arm = 0.5 * (columns * spacing - 3.14159265 * radius);
    const double bottom = 0.5 * contact_thickness(world.params());
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        const double s = spacing * (sheet.site[n] % (columns + 1));
        const double turn = std::clamp((s - arm) / radius, 0.0, 3.14159265);
        const double back = std::max(0.0, s - arm - 3.14159265 * radius);
        const double x = std::min(s, arm) + radius * std::sin(turn) - back;
        const double y = bottom + radius * (1 - std::cos(turn));
        sheet.position.set(n, Vector3(x, y, sheet.position.z[n]));
    }
    world.restore(std::move(state));
    static_cast<void>(world.apply(world.params()));
}

int most_crossings_of_a_fold(bool self) {
    Params p = test::plain(8, 30);
    p.world.gravity = kGravity;
    p.world.ground = true;
    p.springs.stiffness_scale = 40;
    p.contact.self = self;
    World world = world_of(p, {Vector3(0, 0.1, 0)});
    fold(world, 0.03);
    int most = 0;
    while (world.state().time < 1.0) {
        run(world, 0.5 * world.tick_duration());
        most = std::max(most, test::count_crossings(world.state()));
    }
    return most;
}

TEST(Contact, ASheetFoldedOntoItselfDoesNotPassThrough) {
    EXPECT_EQ(most_crossings_of_a_fold(true), 0);
}

TEST(Contact, WithoutSelfContactItDoes) {
    EXPECT_GT(most_crossings_of_a_fold(false), 0);
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
