// The inner loop of the coupling of fire and sheet: sums over particles for eight nodes at once.
#pragma once

#include <array>

#include "sim/coupling_plan.h"

namespace ember {

/// Sums over the particles near each node of a patch.
struct PatchSums {
    alignas(64) std::array<double, kLanes> heating;                 ///< [K/s] before saturation
    std::array<double, kLanes> weight;                              ///< [1] Σ W
    std::array<double, kLanes> momentum_x, momentum_y, momentum_z;  ///< [m/s] Σ W v
};

/// Where the heat of a patch's nodes comes from.
struct PatchDirections {
    alignas(64) std::array<double, kLanes> x, y, z;  ///< [K m/s] Σ heating (x_p - x_n)
};

/// Sums over the same runs as add_patch().
void add_directions(const ParticleGrid& grid, const NodePatch& patch, const ParticleRun* runs,
                    std::size_t count, double inverse_r2, PatchDirections& sums);

/// Sums over `count` runs of particles, in order, and adds to each particle's `absorbed` what the
/// patch takes of it. `inverse_r2` [1/m²]: 1 / r_k².
void add_patch(const ParticleGrid& grid, const NodePatch& patch, const ParticleRun* runs,
               std::size_t count, double inverse_r2, double* absorbed, PatchSums& sums);

}  // namespace ember
