// Which particles each small group of nodes has to look at.
#pragma once

#include <array>
#include <vector>

#include "sim/node_tiles.h"
#include "sim/particle_grid.h"

namespace ember {

/// Consecutive sorted particles.
struct ParticleRun {
    Index begin, end;
};

/// Up to eight nodes of one sheet that are close to each other now.
struct NodePatch {
    alignas(64) std::array<double, kLanes> x, y, z;  ///< [m]; idle lanes are out of reach of all
    std::array<double, kLanes> share;  ///< [1] area / r_k² of a node that takes heat, else 0
    std::array<Index, kLanes> node;    ///< kNone: an idle lane
    Box box;                           ///< that holds them
    std::size_t sheet;
    std::size_t first_run, last_run;  ///< its runs are first_run .. last_run - 1
    Index block;                      ///< of those into which the work is divided
};

struct CouplingPlan {
    std::vector<NodePatch> patches;
    std::vector<ParticleRun> runs;
    Index blocks = 1;
};

/// Lists the patches that have particles within reach, and those particles; with `all`, every
/// patch, though its runs still are those within reach. Patches are divided into blocks of about
/// the same work: what is in a block depends on the state alone.
void plan_coupling(const Params& params, bool all, const std::vector<SheetState>& sheets,
                   const std::vector<NodeTiles>& tiles, const ParticleGrid& grid,
                   CouplingPlan& plan);

}  // namespace ember
