// The nodes of a sheet in groups of eight neighbours, which one vector register holds.
#pragma once

#include <vector>

#include "sim/lanes.h"
#include "sim/lattice.h"
#include "sim/world_state.h"

namespace ember {

/// Follows from the sheet's topology alone.
struct NodeTiles {
    std::vector<Index> node;                 ///< kLanes per tile; kNone in lanes left over
    std::uint64_t topology_version = ~0ull;  ///< of the sheet it was built for

    [[nodiscard]] std::size_t size() const { return node.size() / kLanes; }
};

/// Groups the nodes that are not held: 4 × 2 sites, with the copies of their nodes.
void group_nodes(const Lattice& lattice, const SheetState& sheet, NodeTiles& tiles);

}  // namespace ember
