// Edges as the curves that they are, not as the staircase of the lattice.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/world_view.h"

namespace ember {

/// How far each node of a sheet moves on the unburnt sheet so that cracks are drawn along their
/// curves: (main, cross) [m], at most half a cell either way, the same for all nodes of a site, so
/// both lips still fit. Empty without such cracks.
[[nodiscard]] std::vector<std::array<double, 2>> torn_edge_shifts(const SheetView& sheet);

/// The same for the outline of a sheet that has paper in some cells only: its staircase becomes a
/// smooth curve (Taubin, A signal processing approach to fair surface design, 1995, section 3.1:
/// a low-pass filter of polygons that does not shrink them). Where the outline meets itself or the
/// border of the lattice it stays. Empty where every cell is paper.
[[nodiscard]] std::vector<std::array<double, 2>> outline_shifts(const SheetView& sheet);

/// Both together, at most half a cell either way, and beside them a wandering of up to `ragged`
/// cells at every site inside, the same at all times, so that what tears later is no straight line.
/// Empty when nothing moves.
[[nodiscard]] std::vector<std::array<double, 2>> edge_shifts(const SheetView& sheet,
                                                             double ragged = 0);

/// Moves the positions of nodes by their shifts along the surface: x + s_x ∂x/∂main + s_z
/// ∂x/∂cross, with the derivatives of the quads that a node belongs to. Shape N, as the shifts.
[[nodiscard]] std::vector<Vector3> torn_positions(const SheetView& sheet,
                                                  std::span<const std::array<double, 2>> shifts);

}  // namespace ember
