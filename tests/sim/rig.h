// A single sheet with everything that the stage functions ask for, for tests below World.
#pragma once

#include <memory>

#include "sim/energy.h"
#include "sim/integrator.h"
#include "sim/lattice.h"
#include "sim/loads.h"
#include "sim/parallel.h"
#include "sim/scene.h"
#include "sim/sheet_builder.h"
#include "sim/spring_network.h"
#include "sim/stability.h"

namespace ember::test {

/// Parameters of a plain sheet: no variation, no waviness, no gravity, no air, no ground, no fire.
inline Params plain(int rows, int columns) {
    Params p;
    p.sheet.rows = rows;
    p.sheet.columns = columns;
    p.sheet.width = 0.01 * rows;
    p.sheet.height = 0.01 * columns;
    p.sheet.pose = SheetPose::Horizontal;
    p.sheet.held = HeldEdge::None;
    p.sheet.imperfection = 0;
    p.springs.variation = 0;
    p.springs.stiffness_scale = 1;
    p.world.gravity = 0;
    p.world.held_gravity = 1;
    p.world.air_drag = 0;
    p.world.ground = false;
    p.lighter.on = false;
    return p;
}

struct Rig {
    Params params;
    Scene scene;
    Lattice lattice;
    SheetState sheet;
    SpringNetwork network;
    Plate plate;
    PlateForces plate_forces;
    NodeLoads loads;
    SpringForces forces;
    OldRows old_rows;
    IntegratorScratch scratch;
    StabilityScratch stability;
    std::vector<MechanicalEnergy> row_energy;
    std::vector<RowSpan> whole;
    std::unique_ptr<ThreadPool> pool = std::make_unique<ThreadPool>(1);
    StepCounters counters;

    explicit Rig(const Params& p) : params(p), scene(make_scene(p)) {
        const auto seed = static_cast<std::uint64_t>(p.numerics.seed);
        lattice = make_lattice(scene.sheets[0], p.paper, p.springs, seed, 0);
        plate = make_plate(scene.sheets[0], lattice, p.paper, p.plate);
        sheet = make_sheet(scene.sheets[0], lattice, p, 0);
        whole = {{0, lattice.row_count}};
        refresh();
    }

    /// After any change of topology, mass or held nodes.
    void refresh() {
        rebuild_network(lattice, sheet, network);
        if (plate.stiff()) {
            rebuild_plate(lattice, sheet, plate);
            weaken_plate(lattice, sheet, params, plate);
        }
        weaken_springs(lattice, sheet, params.springs.follows_mass, *pool, network);
        gather_loads(params, sheet, {}, loads);
    }

    TickWork run(double dt, std::int64_t substeps,
                 IntegratorKind integrator = IntegratorKind::Rk4) {
        return run({.integrator = integrator, .dt = dt, .substeps = substeps});
    }

    TickWork run(const StepControl& control) {
        gather_loads(params, sheet, {}, loads);
        return integrate(mechanics(), sheet, control, scratch, counters);
    }

    /// The right-hand side for the present topology, masses and loads.
    [[nodiscard]] Mechanics mechanics() {
        forces.prepare(lattice, sheet, network, *pool);
        return {lattice, sheet,    network,      loads,
                forces,  old_rows, *pool,        spring_kernel(params.numerics.arithmetic),
                whole,   stiff(),  &plate_forces};
    }

    [[nodiscard]] FastestMotion fastest() {
        gather_loads(params, sheet, {}, loads);
        return find_fastest_motion(lattice, sheet, network, stiff(), loads, *pool, stability);
    }

    [[nodiscard]] MechanicalEnergy energy() {
        MechanicalEnergy all =
            sheet_energy(lattice, params.world, sheet, network, *pool, row_energy);
        if (plate.stiff()) all.elastic += plate_energy(lattice, plate, sheet);
        return all;
    }

    [[nodiscard]] const Plate* stiff() const { return plate.stiff() ? &plate : nullptr; }

    [[nodiscard]] std::size_t site(Index row, Index column) const {
        return static_cast<std::size_t>(lattice.site(row, column));
    }
};

}  // namespace ember::test
