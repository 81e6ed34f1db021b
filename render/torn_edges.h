// Torn edges as the cracks that they are, not as the staircase of the lattice.
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

/// Moves the positions of nodes by their shifts along the surface: x + s_x ∂x/∂main + s_z
/// ∂x/∂cross, with the derivatives of the quads that a node belongs to. Shape N, as the shifts.
[[nodiscard]] std::vector<Vector3> torn_positions(const SheetView& sheet,
                                                  std::span<const std::array<double, 2>> shifts);

}  // namespace ember
