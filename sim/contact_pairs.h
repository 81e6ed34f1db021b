// What may touch within a tick: nodes near the ground, and nodes near quads.
//
// Everything is judged by the boxes that nodes and quads sweep while they move on with their
// present velocity. Boxes of whole rows come first, so that a sheet far from the ground and from
// others costs a few comparisons per node; what is left goes through a hashed grid of cells.
#pragma once

#include <span>
#include <vector>

#include "sim/border_edges.h"
#include "sim/node_grid.h"
#include "sim/params.h"
#include "sim/step_stats.h"

namespace ember {

/// A node that may reach a quad of sheet `other`, which may be its own.
struct NearPair {
    Index sheet, node, other, quad;
};

/// Two edges of borders that may meet, by their numbers in the sheets' BorderEdges.
struct NearEdges {
    Index sheet, edge, other, other_edge;
};

/// What find_near() has found, and its scratch.
struct NearThings {
    std::vector<SheetNode> on_ground;  ///< that may reach it, by sheet and node
    std::vector<NearPair> pairs;       ///< by other, quad, sheet and node
    std::vector<NearEdges> edges;      ///< by sheet, edge, other and its edge; each pair once
    std::vector<BorderEdges> borders;  ///< of each sheet that takes part

    [[nodiscard]] bool empty() const { return on_ground.empty() && pairs.empty() && edges.empty(); }

    // scratch
    std::vector<std::vector<SweptBox>> rows;  ///< swept by each row of each sheet
    std::vector<SweptBox> sheets;             ///< and by all rows together
    std::vector<SweptBox> shared;             ///< the part of it that another sheet's box reaches
    std::vector<Index> order;                 ///< of sheets along an axis
    NodeGrid grid;
};

/// Nodes of the same sheet within this many cells of a quad do not touch it: they are its
/// neighbours, which springs keep apart.
inline constexpr Index kNeighbourCells = 2;

/// Finds what may touch within `dt` [s] if nodes keep apart by `thickness` [m]. `fall` [m] is how
/// much farther than their velocity says nodes may get. Pairs are found by box alone and do not
/// depend on how they were found. With `skip` off all rows are looked at, with the same result.
void find_near(const Params& params, double dt, double thickness, double fall,
               std::span<const SheetInSpace> sheets, NearThings& near, StepCounters& counters);

}  // namespace ember
