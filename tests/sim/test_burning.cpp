// Burning, shrinking and fire: mass ledger, eq. 4 by hand, emission that does not know the tick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "rig.h"
#include "sim/burning.h"
#include "sim/fire.h"
#include "sim/fire_coupling.h"
#include "sim/lighter.h"
#include "sim/shrinkage.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

ActiveNodes active_in(const Rig& rig) {
    ActiveNodes active;
    find_active(rig.lattice, rig.sheet, active);
    return active;
}

std::vector<NodeTiles> tiles_of(const Rig& rig) {
    std::vector<NodeTiles> tiles(1);
    group_nodes(rig.lattice, rig.sheet, tiles[0]);
    return tiles;
}

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

// A sheet whose nodes (2,2) and (2,3) burn at 900 and 700 degC.
Rig two_burning() {
    Rig rig(plain(4, 6));
    rig.sheet.phase[rig.site(2, 2)] = rig.sheet.phase[rig.site(2, 3)] = Phase::Burning;
    rig.sheet.temperature[rig.site(2, 2)] = 273.15 + 900;
    rig.sheet.temperature[rig.site(2, 3)] = 273.15 + 700;
    return rig;
}

double rest_ratio(const Rig& rig, Slot kind, Index row, Index column) {
    const auto slot =
        static_cast<std::size_t>(rig.lattice.slot(kind, rig.lattice.site(row, column)));
    return rig.sheet.rest_length[slot] / rig.lattice.initial_length[slot];
}

TEST(Shrinkage, IsEquation4ByHand) {
    Rig rig = two_burning();
    shrink_burning_springs(rig.lattice, rig.params, 1.0 / 60, active_in(rig), rig.sheet,
                           rig.counters);
    // one application: factor (T_a + T_b) / (k_s c_s), with k_s = 7e3 G A_ref
    const double k_s = 7e3 * 0.080 * 0.21 * 0.297 / (33 * 49);
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::Main, 2, 2), 5e-12 * 1600 / (k_s * 2e-4), 1e-12);
    EXPECT_EQ(rest_ratio(rig, Slot::Main, 2, 3), 1.0);      // one end burns: not structural
    EXPECT_EQ(rest_ratio(rig, Slot::DiagDown, 2, 2), 1.0);  // nor diagonal
    // bending springs with one burning end shrink by half; the cold end is at 20 degC
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::BendMain, 2, 0), 0.5 * 5e-12 * 920 / (k_s * 2e-4), 1e-12);
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::BendCross, 2, 3), 0.5 * 5e-12 * 720 / (k_s * 2e-4),
                1e-12);
    EXPECT_EQ(rig.counters.springs_shrunk, 1 + 8);
}

TEST(Shrinkage, DoesNotDependOnTheStep) {
    Rig once = two_burning(), often = two_burning();
    shrink_burning_springs(once.lattice, once.params, 0.5, active_in(once), once.sheet,
                           once.counters);
    for (int i = 0; i < 8; ++i) {
        shrink_burning_springs(often.lattice, often.params, 0.0625, active_in(often), often.sheet,
                               often.counters);
    }
    EXPECT_NEAR(rest_ratio(once, Slot::Main, 2, 2), rest_ratio(often, Slot::Main, 2, 2), 1e-14);
    EXPECT_LT(rest_ratio(once, Slot::Main, 2, 2), 0.999);
}

TEST(Shrinkage, StopsAtTheFloorAndHasTheRulesOfTheTable) {
    Rig floor = two_burning();
    shrink_burning_springs(floor.lattice, floor.params, 1e6, active_in(floor), floor.sheet,
                           floor.counters);
    EXPECT_EQ(rest_ratio(floor, Slot::Main, 2, 2), 0.7);
    Rig half = two_burning();
    half.params.shrinkage.rule = ShrinkRule::Half;
    shrink_burning_springs(half.lattice, half.params, 1.0 / 60, active_in(half), half.sheet,
                           half.counters);
    EXPECT_LT(rest_ratio(half, Slot::Main, 2, 3), 1.0);
    Rig literal = two_burning();
    literal.params.shrinkage.literal_stiffness = true;
    shrink_burning_springs(literal.lattice, literal.params, 1.0 / 60, active_in(literal),
                           literal.sheet, literal.counters);
    Rig usual = two_burning();
    shrink_burning_springs(usual.lattice, usual.params, 1.0 / 60, active_in(usual), usual.sheet,
                           usual.counters);
    EXPECT_NEAR((1 - rest_ratio(usual, Slot::BendMain, 2, 0)) /
                    (1 - rest_ratio(literal, Slot::BendMain, 2, 0)),
                2e4 / 7e3, 1e-9);
    Rig none = two_burning();
    none.params.shrinkage.factor = 0;
    shrink_burning_springs(none.lattice, none.params, 1.0, active_in(none), none.sheet,
                           none.counters);
    EXPECT_EQ(none.counters.springs_shrunk, 0);
}

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

// One particle above the middle of a sheet.
FireState one_particle(const Rig& rig, double above) {
    FireState fire;
    fire.position.push_back(rig.sheet.position.at(rig.site(4, 4)) + Vector3(0, above, 0));
    fire.velocity.push_back({0, 1, 0});
    fire.temperature = {rig.params.fire.temperature};
    fire.strength = {1.0};
    fire.birth = {0.0};
    fire.death = {1.0};
    fire.id = {1};
    return fire;
}

TEST(Coupling, GivesTheKernelsHeatWithinItsRadiusAndNothingBeyond) {
    Params p = plain(8, 8);
    p.fire.kernel_radius = 0.025;
    p.fire.heating_limit = 1e8;  // no saturation
    Rig rig(p);
    FireState fire = one_particle(rig, 0.015);
    CouplingScratch grid;
    std::vector<NodeFire> received;
    const std::vector<SheetState> sheets{rig.sheet};
    couple_fire(p, 0, 1e-9, sheets, tiles_of(rig), fire, *rig.pool, grid, received, rig.counters);
    const double a = particle_heating(p.fire, p.paper);
    EXPECT_NEAR(a, 6000.0, 1e-9);
    for (Index r = 0; r < 9; ++r) {
        for (Index c = 0; c < 9; ++c) {
            const double d2 = 1e-4 * ((r - 4) * (r - 4) + (c - 4) * (c - 4)) + 0.015 * 0.015;
            const double q = std::max(0.0, 1 - d2 / (0.025 * 0.025));
            EXPECT_NEAR(received[0].heating[rig.site(r, c)], a * q * q, 0.05) << r << ' ' << c;
        }
    }
    EXPECT_GT(received[0].force.y[rig.site(4, 4)], 0);
    EXPECT_LT(rig.counters.coupling_pairs, 81);  // the grid spares distant nodes
}

TEST(Coupling, AParticleLosesWhatItGives) {
    Params p = plain(8, 8);
    Rig rig(p);
    FireState near = one_particle(rig, 0.005), far = one_particle(rig, 0.5);
    CouplingScratch grid;
    std::vector<NodeFire> received;
    const std::vector<SheetState> sheets{rig.sheet};
    const double hot = near.temperature[0];
    // expected: absorption Σ (area / r²) W
    double sum = 0;
    const double r2 = p.fire.kernel_radius * p.fire.kernel_radius;
    for (Index r = 1; r < 8; ++r) {
        for (Index c = 1; c < 8; ++c) {
            const double d2 = 1e-4 * ((r - 4) * (r - 4) + (c - 4) * (c - 4)) + 0.005 * 0.005;
            const double q = std::max(0.0, 1 - d2 / r2);
            sum += 1e-4 / r2 * q * q;
        }
    }
    couple_fire(p, 0, 0.01, sheets, tiles_of(rig), near, *rig.pool, grid, received, rig.counters);
    EXPECT_NEAR((near.temperature[0] - 293.15) / (hot - 293.15),
                std::exp(-p.fire.absorption * sum * 0.01), 1e-9);
    couple_fire(p, 0, 0.01, sheets, tiles_of(rig), far, *rig.pool, grid, received, rig.counters);
    EXPECT_EQ(far.temperature[0], hot);
    rig.sheet.phase.assign(rig.sheet.phase.size(), Phase::BurntOut);  // ash takes nothing
    FireState over_ash = one_particle(rig, 0.005);
    couple_fire(p, 0, 0.01, {rig.sheet}, tiles_of(rig), over_ash, *rig.pool, grid, received,
                rig.counters);
    EXPECT_EQ(over_ash.temperature[0], hot);
    EXPECT_EQ(received[0].heating[rig.site(4, 4)], 0.0);
}

TEST(Coupling, ManyParticlesSaturate) {
    Params p = plain(8, 8);
    Rig rig(p);
    FireState fire = one_particle(rig, 0.0);
    for (int i = 0; i < 2000; ++i) {
        fire.position.push_back(fire.position.at(0));
        fire.velocity.push_back(fire.velocity.at(0));
        fire.temperature.push_back(fire.temperature[0]);
        fire.strength.push_back(1.0);
        fire.birth.push_back(0);
        fire.death.push_back(1);
        fire.id.push_back(static_cast<std::uint64_t>(i));
    }
    CouplingScratch grid;
    std::vector<NodeFire> received;
    couple_fire(p, 0, 0.01, {rig.sheet}, tiles_of(rig), fire, *rig.pool, grid, received,
                rig.counters);
    EXPECT_LE(received[0].heating[rig.site(4, 4)], p.fire.heating_limit);
    EXPECT_GT(received[0].heating[rig.site(4, 4)], 0.99 * p.fire.heating_limit);
    const double pull = Vector3(received[0].force.at(rig.site(4, 4))).norm();
    EXPECT_NEAR(pull / rig.sheet.mass[rig.site(4, 4)], p.fire.force_limit, 1e-9);
}

TEST(Coupling, NoParticlesNoWork) {
    Rig rig(plain(8, 8));
    FireState fire;
    CouplingScratch grid;
    std::vector<NodeFire> received;
    couple_fire(rig.params, 0, 0.01, {rig.sheet}, tiles_of(rig), fire, *rig.pool, grid, received,
                rig.counters);
    EXPECT_EQ(rig.counters.coupling_pairs, 0);
    EXPECT_TRUE(received[0].heating.empty());
    EXPECT_TRUE(grid.grid.begin.empty());
}

}  // namespace
}  // namespace ember
