// Where a person wants the lighter: under the paper, or where the mouse points.
#pragma once

#include <optional>

#include "sim/params.h"
#include "sim/world_view.h"

namespace ember {

/// Places along the lowest rim of the first sheet, as the viewer sees it.
enum class LighterSpot { LeftCorner, Middle, RightCorner };

/// The lighter 20 mm below that place of the sheet as it is now [m]; corners are taken 5 mm
/// inwards. Burnt-out nodes do not count; empty when nothing is left to light.
[[nodiscard]] std::optional<Vector3> lighter_below(const SheetView& sheet, LighterSpot spot);

/// Moves the lighter, which leaves its path, and makes sure that it burns from `now` [s] on unless
/// it does already.
void move_lighter(LighterParams& lighter, const Vector3& place, bool lit, double now);

/// Adds where the lighter is at `time` [s] to its path: it stays where the path ended until one
/// `tick` [s] before. What the path says of later times is given up.
void extend_path(LighterParams& lighter, double time, double tick);

}  // namespace ember
