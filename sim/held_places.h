// Which sites of a sheet are attached.
#pragma once

#include "sim/scene.h"

namespace ember {

/// One flag per site, 1 where it is attached: sites with paper on the edges and at the corners that
/// the plan names, and for each of its points the nearest site with paper and all within the
/// radius. Distances are along the sheet; on a tube across the seam too. Throws SceneError when a
/// point lies beyond the sheet, or has no paper within its radius or a cell.
[[nodiscard]] std::vector<std::uint8_t> held_sites(const SheetPlan& plan);

}  // namespace ember
