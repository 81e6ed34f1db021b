// What fire particles give to nodes close to them (section 4.2): heat, and a push.
//
// Particle p heats node n, at distance d < r_k, by
//     A · strength_p · e^(-age/heating_time) · (T_p - ambient)/(T_0 - ambient) · W(d)  [K/s],
//     W(d) = (1 - d²/r_k²)²,
// with A = A_0 (80 g/m² / G)^a (2e-4 / c_s)^b; a node takes S_max (1 - exp(-S/S_max)) of the sum S.
// Particles lose what they give: their excess temperature falls at the rate
// absorption · e^(-age/heating_time) · Σ_n (area_n / r_k²) W(d) over the nodes that they heat.
// Particles of heat capacity c_s c G A r_k² / absorption would do the same.
#pragma once

#include <vector>

#include "sim/coupling_plan.h"
#include "sim/parallel.h"
#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// What a sheet's nodes receive in a tick.
struct NodeFire {
    std::vector<double> heating;  ///< [K/s], N
    Vector3Array force;           ///< [N], N
    /// [1] mean distance of what heats a node, over the radius of the kernel, 3×N. Empty unless the
    /// sheet curls, which asks from which side it is heated.
    Vector3Array direction;
};

/// Scratch.
struct CouplingScratch {
    ParticleGrid grid;
    CouplingPlan plan;
    std::vector<double> absorbed;      ///< Σ (area / r_k²) W in the grid's order, for each block
    std::vector<ParticleRun> touched;  ///< by each block
    std::vector<Index> near;           ///< particles near a patch, for each block
    std::vector<double> kept;          ///< share of its excess that each particle keeps
};

/// A of the law above [K/s].
[[nodiscard]] double particle_heating(const FireParams& fire, const PaperParams& paper);

/// Fills `received` for every sheet and cools the particles by what they gave during `dt` [s].
/// `time` [s] is the moment that the particles have reached. `tiles`: see group_nodes().
/// Burnt-out nodes take a push but no heat. Without particles nothing is computed or allocated.
/// Without numerics.skip every node looks at every particle, and the result is the same.
/// Same bits for any number of threads.
void couple_fire(const Params& params, double time, double dt,
                 const std::vector<SheetState>& sheets, const std::vector<NodeTiles>& tiles,
                 FireState& fire, ThreadPool& pool, CouplingScratch& scratch,
                 std::vector<NodeFire>& received, StepCounters& counters);

}  // namespace ember
