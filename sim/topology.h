// Opening the sheet: how quads share the copies of a node, and what a cut does to them.
//
// Every site has up to four quads around it, in sectors 0 to 3, and four glue bits, one per edge:
// bit d says that the quads on both sides of the edge in direction d share this site's node.
//
//              3 (-z)                   sector k lies between direction k and k+1
//          2     │     3
//   2 (-x) ──────┼────── 0 (+x)         quads connected through glued edges form one copy of the
//          1     │     0                node; a cut clears two bits, opposite or adjacent
//              1 (+z)
//
// Quads are never added or removed. Springs follow from quads and glue (spring_network.h).
#pragma once

#include <array>

#include "sim/lattice.h"
#include "sim/world_state.h"

namespace ember {

/// The line along which a site is cut.
enum class CutLine : std::uint8_t { AlongMain, AlongCross };

/// Which sectors of a site exist and which of them hold together: the number of each sector's
/// part, from 0, or -1 where there is no quad.
[[nodiscard]] std::array<int, 4> fan_parts(const Lattice& lattice, Index site, unsigned glue);

/// Gives every part of the fan of `site` that does not hang together with the others a copy of the
/// node. Mass is shared by the number of quads; everything else is copied. Returns the number of
/// nodes added.
Index separate(const Lattice& lattice, SheetState& sheet, Index site);

/// Clears the glue bits `mask` of `site` and gives every part of the fan that has lost touch a copy
/// of the node. Two opposite bits are a straight cut, two adjacent ones a corner. Mass is shared by
/// the number of quads; everything else is copied. Returns the number of nodes added: 0 when the
/// site cannot open there.
Index open_site(const Lattice& lattice, SheetState& sheet, Index site, unsigned mask);

/// Cuts `site` along a line: opens the two edges on it.
Index cut_site(const Lattice& lattice, SheetState& sheet, Index site, CutLine line);

/// The edges of `site` that are no longer glued at their other end, as a mask: a crack has come
/// along each of them as far as this site.
[[nodiscard]] unsigned edges_open_beyond(const Lattice& lattice, const SheetState& sheet,
                                         Index site);

/// Lets go quads that hang together at `site` by this node alone: edges that are no longer glued
/// at their other end do not count. Returns the number of nodes added.
Index release_hinge(const Lattice& lattice, SheetState& sheet, Index site);

/// Recomputes which nodes belong to a piece with a held node (SheetState::piece_held).
/// Returns the number of pieces of paper.
Index find_pieces(SheetState& sheet);

}  // namespace ember
