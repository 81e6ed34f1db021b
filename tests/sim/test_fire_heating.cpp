// What a particle gives the nodes around it: the kernel, its radius, and its limit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rig.h"
#include "sim/fire_coupling.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

std::vector<NodeTiles> tiles_of(const Rig& rig) {
    std::vector<NodeTiles> tiles(1);
    group_nodes(rig.lattice, rig.sheet, tiles[0]);
    return tiles;
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
