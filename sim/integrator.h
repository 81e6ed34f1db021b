// Classical fourth-order Runge-Kutta over one tick (section 2 of the paper: "an explicit
// Runge-Kutta of order four").
#pragma once

#include "sim/spring_forces.h"
#include "sim/step_stats.h"

namespace ember {

/// What acts on a sheet's nodes during a tick besides springs; all arrays N.
struct NodeLoads {
    std::vector<double> inverse_mass;  ///< [1/kg]; 0 for held nodes
    Vector3Array force;                ///< [N] constant during the tick: gravity and fire
    Vector3Array fire;                 ///< [N] the part of it that is fire's
    std::vector<double> drag;          ///< [kg/s] across the sheet
    Vector3Array normal;               ///< [1] unit normal at the start of the tick
    double drag_tangential = 0;        ///< [1] share of drag along the sheet
    bool has_drag = false;
};

/// Scratch of one sheet's integration.
struct IntegratorScratch {
    Vector3Array stage_x, stage_v;  ///< [m], [m/s] where the next right-hand side is taken
    Vector3Array sum_x, sum_v;      ///< weighted sums of the stages
    Vector3Array start_x;           ///< [m] at the start of the tick, for the work of the fire
    std::vector<double> drag_loss;  ///< [J] since the start of the tick, N
    std::vector<double> row_force;  ///< 3×row, one block per row so that threads do not meet
};

/// Where mechanical energy went in a tick [J].
struct TickWork {
    double fire = 0, damping = 0, drag = 0;
};

/// Advances positions and velocities by `dt` [s] in `substeps` equal steps. Fourth order in the
/// step where loads are constant. `dt / substeps` must respect substep_bound() (stability.h).
/// Returns the work done, by the same quadrature as the motion.
TickWork integrate(const Lattice& lattice, SheetState& sheet, const SpringNetwork& network,
                   const NodeLoads& loads, double dt, std::int64_t substeps, SpringForces& forces,
                   IntegratorScratch& scratch, ThreadPool& pool, StepCounters& counters);

}  // namespace ember
