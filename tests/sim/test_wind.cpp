// The air's own motion: what it does to paper and to fire, and its place in the ledger.
#include <gtest/gtest.h>

#include "rig.h"
#include "sim/fire.h"
#include "sim/wind.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::plain;

// A free horizontal sheet in the air.
Params leaf() {
    Params p = plain(4, 6);
    p.sheet.elevation = 100;
    p.world.gravity = 9.81;
    p.world.air_drag = 2.0;
    return p;
}

void advance(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i)
        ASSERT_TRUE(world.step().ok());
}

TEST(Wind, ComesAndGoesAsItsFormulaSays) {
    WindParams wind;
    EXPECT_EQ(wind_velocity(wind, 3.0), Vector3::Zero());
    wind.x = 2;
    wind.z = -1;
    EXPECT_EQ(wind_velocity(wind, 3.0), Vector3(2, 0, -1));
    wind.gust = 0.5;
    wind.gust_period = 4;
    EXPECT_NEAR((wind_velocity(wind, 1.0) - Vector3(3, 0, -1.5)).norm(), 0, 1e-14);
    EXPECT_NEAR((wind_velocity(wind, 4003.0) - Vector3(1, 0, -0.5)).norm(), 0, 1e-12);
}

TEST(Wind, PaperFallsAtItsTerminalVelocityInAirThatRises) {
    Params p = leaf();
    p.wind.y = 0.25;
    World world = make_world(p);
    advance(world, 60);
    const double terminal = 0.25 - p.paper.grammage * 9.81 / p.world.air_drag;
    const SheetState& sheet = world.state().sheets[0];
    for (std::size_t n = 0; n < sheet.mass.size(); ++n)
        EXPECT_NEAR(sheet.velocity.y[n], terminal, 1e-9);
}

TEST(Wind, PaperRestsOnAirThatCarriesIt) {
    Params p = leaf();
    p.wind.y = p.paper.grammage * 9.81 / p.world.air_drag;
    World world = make_world(p);
    const Vector3 before = world.state().sheets[0].position.at(8);
    advance(world, 60);
    EXPECT_NEAR((world.state().sheets[0].position.at(8) - before).norm(), 0, 1e-12);
}

TEST(Wind, TheLedgerKnowsItsWork) {
    Params p = leaf();
    p.sheet.imperfection = 0.002;
    p.wind.x = 3;
    p.wind.y = 1;
    p.wind.gust = 0.8;
    p.wind.gust_period = 0.3;
    p.numerics.integrator = IntegratorKind::Rk4;  // whose own error is small
    p.numerics.substeps_min = 20;
    World world = make_world(p);
    advance(world, 60);
    const EnergyLedger& e = world.state().energy;
    EXPECT_GT(e.work_wind, 1e-4);
    EXPECT_GT(e.loss_drag, 0);
    double scale = 0;
    EXPECT_LT(std::abs(unaccounted_energy(e, scale)), 1e-6 * e.work_wind);
}

TEST(Wind, FireIsCarriedAlong) {
    Params p = plain(2, 2);
    p.fire.drag = 2;
    p.fire.life_min = p.fire.life_max = 5;
    p.wind.x = 1.5;
    FireState fire;
    fire.position.push_back({0, 0, 0});
    fire.velocity.push_back({0, 0, 0});
    fire.temperature = {p.fire.temperature};
    fire.strength = {1.0};
    fire.birth = {0.0};
    fire.death = {10.0};
    fire.id = {7};
    StepCounters counters;
    for (int i = 0; i < 60; ++i)
        advance_fire(p, {}, 1, i / 60.0, 1 / 60.0, {}, {}, {}, fire, counters);
    EXPECT_NEAR(fire.velocity.x[0], 1.5 * (1 - std::exp(-2.0)), 1e-12);
    EXPECT_NEAR(fire.position.x[0], 1.5 * (1 - 0.5 * (1 - std::exp(-2.0))), 1e-12);
    EXPECT_EQ(fire.position.z[0], 0.0);
}

}  // namespace
}  // namespace ember
