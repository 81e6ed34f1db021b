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

#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Scratch of the neighbour search: particles sorted into cells of the kernel's radius.
struct ParticleGrid {
    Vector3 origin = Vector3::Zero();  ///< [m] corner of cell (0, 0, 0)
    double cell = 0;                   ///< [m]
    Index nx = 0, ny = 0, nz = 0;
    std::vector<Index> begin;         ///< first entry of each cell, cells + 1
    std::vector<Index> order;         ///< particle numbers, by cell, ascending within a cell
    Vector3Array position, velocity;  ///< of the particles in that order
    std::vector<double> heating;      ///< [K/s] at the kernel's centre, in that order
    std::vector<double> freshness;    ///< e^(-age/heating_time), in that order
    std::vector<double> absorbed;     ///< Σ (area / r_k²) W, in that order
};

/// What a sheet's nodes receive in a tick.
struct NodeFire {
    std::vector<double> heating;  ///< [K/s], N
    Vector3Array force;           ///< [N], N
};

/// A of the law above [K/s].
[[nodiscard]] double particle_heating(const FireParams& fire, const PaperParams& paper);

/// Fills `received` for every sheet and cools the particles by what they gave during `dt` [s].
/// `time` [s] is the moment that the particles have reached.
/// Burnt-out nodes take a push but no heat. Without particles nothing is computed or allocated.
void couple_fire(const Params& params, double time, double dt,
                 const std::vector<SheetState>& sheets, FireState& fire, ParticleGrid& grid,
                 std::vector<NodeFire>& received, StepCounters& counters);

}  // namespace ember
