// What the mouse points at.
#pragma once

#include <optional>

#include "render/camera.h"
#include "sim/params.h"
#include "sim/world_view.h"

namespace ember {

/// A place on a sheet.
struct Pick {
    Vector3 place = Vector3::Zero();  ///< [m]
    std::size_t sheet = 0;
    std::size_t node = 0;  ///< the nearest of the quad that is hit
};

/// Where a ray first meets a sheet; empty when it meets none.
[[nodiscard]] std::optional<Pick> pick_sheet(const WorldView& world, const Vector3& eye,
                                             const Vector3& direction);

/// The place of pick_sheet(); failing that, the plane in which the first sheet started, so that a
/// click beside the paper lands level with it. Empty when the ray meets neither.
[[nodiscard]] std::optional<Vector3> pick(const WorldView& world, const Params& params,
                                          const Vector3& eye, const Vector3& direction);

}  // namespace ember
