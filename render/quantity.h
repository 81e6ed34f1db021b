// What the views show of every node: pure, no GL.
#pragma once

#include <span>
#include <vector>

#include "render/view_params.h"
#include "sim/world_view.h"

namespace ember {

/// The quantity of `mode` at every node: temperature [degC], share of the mass that is left [1],
/// phase (0, 1, 2), or the mean stress of the structural springs at the node [kPa], which needs
/// them. Empty in modes that show none.
[[nodiscard]] std::vector<float> node_quantity(ViewMode mode, const SheetView& sheet,
                                               std::span<const SpringSegment> springs);

}  // namespace ember
