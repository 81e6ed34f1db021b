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

/// Lists those particles of `count` runs, in order, that are within reach of the patch's box: less
/// than half of them, as runs are made of whole cells. The others would add zeros to the sums.
/// `list` must have room for all of them and kLanes more. Returns how many there are.
std::size_t list_near(const ParticleGrid& grid, const NodePatch& patch, const ParticleRun* runs,
                      std::size_t count, Index* list);

/// Sums over the same particles as add_patch().
void add_directions(const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
                    std::size_t count, double inverse_r2, PatchDirections& sums);

/// Sums over `count` listed particles, in order, and adds to each one's `absorbed` what the patch
/// takes of it. `inverse_r2` [1/m²]: 1 / r_k².
void add_patch(const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
               std::size_t count, double inverse_r2, double* absorbed, PatchSums& sums);

}  // namespace ember
