// A camera as text, to copy and paste.
#pragma once

#include <optional>
#include <string>

#include "render/view_params.h"

namespace ember {

/// JSON: {"camera.target_x": 0, ...} in shown units.
[[nodiscard]] std::string camera_text(const CameraParams& camera);

/// The camera of such a text; empty when a key is missing or a value is not allowed.
[[nodiscard]] std::optional<CameraParams> camera_from_text(const std::string& text);

}  // namespace ember
