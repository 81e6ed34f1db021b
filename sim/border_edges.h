// The edges of a sheet's border and of its cuts: those that belong to a single quad.
#pragma once

#include <array>
#include <vector>

#include "sim/world_state.h"

namespace ember {

/// Follows from the sheet's topology alone.
struct BorderEdges {
    std::vector<std::array<Index, 2>> ends;  ///< nodes, by the first one and then the second
    std::vector<Index> first;                ///< N + 1: the edges that begin at a node
    std::uint64_t topology_version = ~0ull;  ///< of the sheet it was built for

    std::vector<std::array<Index, 4>> sides;  ///< scratch: of all quads
};

/// Lists the edges again if the sheet has been cut since.
void find_border_edges(const SheetState& sheet, BorderEdges& border);

}  // namespace ember
