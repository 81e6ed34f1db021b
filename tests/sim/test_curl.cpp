// Sheets whose faces differ curl, by as much as theory says; what chars keeps
// its curvature.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "rig.h"
#include "sim/curl.h"
#include "sim/world.h"
#include "small_sheet.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

constexpr double kCaliper = 1e-4;  // [m]

// A strip of real paper, free in space, whose air stops it.
Params strip() {
    Params p = plain(2, 40);
    p.sheet.width = 0.004, p.sheet.height = 0.080;
    p.paper.density = p.paper.grammage / kCaliper;
    p.springs.stiffness_scale = 1e3;
    p.springs.bending = 0;
    p.plate.youngs_main = 5e9, p.plate.youngs_cross = 2.5e9;
    p.curl.heat = 3e-5;
    p.curl.cross_ratio = 1.0;
    p.world.air_drag = 2.0;
    p.world.air_drag_tangential = 1.0;
    return p;
}

// What a fire does that heats every node at `rate` [K/s] from one side, +1 or
// -1 along the normal.
NodeFire fire_from(const Rig& rig, double rate, double side) {
    const std::size_t n = rig.sheet.mass.size();
    NodeFire fire;
    fire.heating.assign(n, rate);
    fire.direction.resize(n);
    Vector3Array normal;
    node_normals(rig.sheet, normal);
    for (std::size_t i = 0; i < n; ++i)
        fire.direction.set(i, side * normal.at(i));
    return fire;
}

bool curl(Rig& rig, const NodeFire& fire, double dt) {
    CurlScratch scratch;
    return advance_curl(rig.lattice, rig.plate, rig.params, fire, dt, rig.sheet, scratch,
                        rig.counters);
}

// Curvature of the middle line by three of its points, towards the normal.
double curvature_of(const Rig& rig) {
    const Index row = rig.lattice.row_count / 2, last = rig.lattice.column_count - 1;
    const Vector3 a = rig.sheet.position.at(rig.site(row, last / 4)),
                  b = rig.sheet.position.at(rig.site(row, last / 2)),
                  c = rig.sheet.position.at(rig.site(row, last - last / 4));
    const Vector3 cross = (b - a).cross(c - b);
    return 2 * cross.norm() / ((b - a).norm() * (c - b).norm() * (c - a).norm());
}

void settle_down(Rig& rig) {
    for (int tick = 0; tick < 40; ++tick) {
        const TickWork work = rig.run({.integrator = IntegratorKind::Rosenbrock,
                                       .dt = 1.0 / 60,
                                       .substeps = 1,
                                       .tolerance = 1e-5});
        ASSERT_EQ(work.failure, nullptr);
    }
}

// Timoshenko 1925: a strip of two layers whose strains differ by ε.
double timoshenko(double strain, double thickness, double layers, double moduli) {
    const double m = layers, n = moduli;
    return 6 * strain * (1 + m) * (1 + m) /
           (thickness * (3 * (1 + m) * (1 + m) + (1 + m * n) * (m * m + 1 / (m * n))));
}

TEST(Curl, AHeatedStripHasTheRadiusOfTimoshenkosBilayer) {
    for (const double side : {1.0, -1.0}) {
        Rig rig(strip());
        // long enough for the faces to come to their difference 2 S τ = 80 K
        const double tau = face_relaxation_time(rig.params.paper);
        (void)curl(rig, fire_from(rig, 40.0 / tau, side), 40 * tau);
        for (const double heat : rig.sheet.faces.heat)
            ASSERT_NEAR(heat, side * 80, 1e-9);
        settle_down(rig);
        const double exact = timoshenko(3e-5 * 80, kCaliper, 1, 1);  // 28 mm
        EXPECT_NEAR(curvature_of(rig), exact, 0.05 * exact);
        RecordProperty("ratio", std::to_string(curvature_of(rig) / exact));
        // towards the hotter side, which the ends rise to
        Vector3Array normal;
        node_normals(rig.sheet, normal);
        const std::size_t middle = rig.site(1, 20);
        const Vector3 rise =
            0.5 * (rig.sheet.position.at(rig.site(1, 0)) + rig.sheet.position.at(rig.site(1, 40))) -
            rig.sheet.position.at(middle);
        EXPECT_GT(side * rise.dot(normal.at(middle)), 0.01);
    }
}

TEST(Curl, FacesComeToDifferAndForgetItAsHeatCrossesTheCaliper) {
    Rig rig(strip());
    const double tau = face_relaxation_time(rig.params.paper);
    EXPECT_NEAR(tau, 800 * 1380 * 1e-8 / (8 * 0.05), 1e-12);
    const NodeFire fire = fire_from(rig, 100, 1.0);
    constexpr int kSteps = 50;
    for (int i = 0; i < kSteps; ++i)
        (void)curl(rig, fire, 2 * tau / kSteps);
    EXPECT_NEAR(rig.sheet.faces.heat[7], 200 * tau * (1 - std::exp(-2.0)), 1e-9);
    (void)curl(rig, {}, tau);
    EXPECT_NEAR(rig.sheet.faces.heat[7], 200 * tau * (1 - std::exp(-2.0)) * std::exp(-1.0), 1e-9);
    EXPECT_TRUE(curl(rig, {}, 40 * tau));
    // flat again, and then nothing is left to do
    for (const double curvature : rig.sheet.rest_curvature.main)
        EXPECT_NEAR(curvature, 0, 1e-9);
    rig.counters = {};
    EXPECT_FALSE(curl(rig, {}, tau));
    EXPECT_EQ(rig.counters.curl_visited, 0);
}

TEST(Curl, PaperWithTwoUnlikeFacesRollsUpAsItChars) {
    Params p = strip();
    p.curl = {.two_sided = 0.0024, .cross_ratio = 1.0};
    Rig rig(p);
    EXPECT_FALSE(curl(rig, {}, 1.0));
    const double residue = p.burning.residual_mass;
    for (const double share : {0.25, 1.0}) {  // of what it loses
        for (std::size_t i = 0; i < rig.sheet.mass.size(); ++i)
            rig.sheet.mass[i] = rig.sheet.initial_mass[i] * (1 - share * (1 - residue));
        EXPECT_TRUE(curl(rig, {}, 1.0));
        const double exact =
            resolved_curvature(rig.lattice, timoshenko(share * 0.0024, kCaliper, 1, 1));
        for (const double curvature : rig.sheet.rest_curvature.main)
            EXPECT_NEAR(curvature, exact, 1e-9 * exact);
    }
}

TEST(Curl, HeatFromBothSidesDoesNotCurl) {
    Rig rig(strip());
    NodeFire fire = fire_from(rig, 100, 0.0);
    (void)curl(rig, fire, 1.0);
    for (const double heat : rig.sheet.faces.heat)
        EXPECT_EQ(heat, 0);
}

TEST(Curl, NoLatticeBendsTighterThanItsCells) {
    Rig rig(strip());
    const double most = 0.5 / 0.002;
    EXPECT_NEAR(resolved_curvature(rig.lattice, 1.0), 1.0, 1e-5);
    EXPECT_NEAR(resolved_curvature(rig.lattice, 1 / 0.007), 0.99 / 0.007, 0.14 / 0.007);
    EXPECT_LT(resolved_curvature(rig.lattice, 1e9), most * (1 + 1e-12));
    EXPECT_NEAR(resolved_curvature(rig.lattice, -1e9), -most, 1e-6);
}

TEST(Curl, WhatCharsKeepsTheCurvatureThatItHas) {
    Params p = strip();
    p.curl = {.heat = 0, .charring = 0, .cross_ratio = 1, .set = 2.0};
    Rig rig(p);
    constexpr double kRadius = 0.05;
    for (Index site = 0; site < rig.lattice.site_count(); ++site) {
        const auto i = static_cast<std::size_t>(site);
        const double angle = (rig.lattice.column_of(site) - 20) * 0.002 / kRadius;
        const double z = rig.sheet.position.z[i];
        rig.sheet.position.set(i, {kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), z});
    }
    const double present = rig.lattice.site_count() > 0 ? 1 / kRadius : 0;
    // burnt down in three steps or in one, 1 - e^-set of it is kept
    for (const double left : {0.8, 0.5, 0.2}) {
        for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
            rig.sheet.mass[n] = left * rig.sheet.initial_mass[n];
        EXPECT_TRUE(curl(rig, {}, 1.0 / 60));
    }
    const double kept = std::abs(rig.sheet.rest_curvature.main[rig.site(1, 20)]);
    EXPECT_NEAR(kept, resolved_curvature(rig.lattice, present) * (1 - std::exp(-2.0)),
                1e-3 * present);
    EXPECT_NEAR(rig.sheet.rest_curvature.cross[rig.site(1, 20)], 0, 1e-9);
    // left alone, the ash stays bent
    rig.refresh();
    settle_down(rig);
    EXPECT_NEAR(curvature_of(rig), kept, 0.05 * kept);
}

// The small sheet of office paper, lit at its corner.
Params office() {
    Params p = test::small_sheet();
    p.springs.stiffness_scale = 400;
    p.world.held_gravity = 1;
    p.plate.youngs_main = 5e9, p.plate.youngs_cross = 2.5e9;
    p.curl.heat = 5e-5;
    p.curl.charring = 0.02;
    p.curl.set = 3;
    return p;
}

TEST(Curl, TheLedgersOfABurningSheetThatCurlsStayClosed) {
    World world = make_world(office());
    std::int64_t visited = 0;
    for (int tick = 0; tick < 150; ++tick) {
        const StepReport report = world.step();
        ASSERT_TRUE(report.ok()) << report.reason;
        visited += report.counters.curl_visited;
    }
    EXPECT_GT(visited, 1000);
    EXPECT_GT(world.state().totals.ignitions, 50);
    EXPECT_EQ(world.state().totals.retries, 0);
    const EnergyLedger& energy = world.state().energy;
    EXPECT_NE(energy.change_curvature, 0);
    double scale = 0;
    const double unaccounted = unaccounted_energy(energy, scale);
    EXPECT_LT(unaccounted, kEnergyMargin * scale);
}

TEST(Curl, SheetsWithoutItHaveNoStateAndNoWorkOfIt) {
    Params p = test::small_sheet();
    p.curl.heat = 1e-4;  // but no rigidity
    World world = make_world(p);
    for (int tick = 0; tick < 10; ++tick)
        EXPECT_EQ(world.step().counters.curl_visited, 0);
    EXPECT_TRUE(world.state().sheets[0].faces.heat.empty());
    EXPECT_TRUE(world.state().sheets[0].rest_curvature.main.empty());
}

}  // namespace
}  // namespace ember
