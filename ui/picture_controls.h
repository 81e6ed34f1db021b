// The mouse over the picture: turn, move and zoom the camera, point at a place.
#pragma once

#include <optional>

#include "render/view_params.h"
#include "ui/bindings.h"

namespace ember {

/// A place in the picture, in points from its upper left corner.
struct PicturePoint {
    double x = 0, y = 0;
};

class PictureControls {
  public:
    /// Applies what the mouse did since the last frame to `camera`; `height` is the picture's
    /// [points]. `placing`: a plain click points at a place too, and ends that mode. Returns the
    /// place that is pointed at, if one is. Call within an ImGui frame.
    [[nodiscard]] std::optional<PicturePoint> update(CameraParams& camera, double height,
                                                     bool& placing);

  private:
    void begin_drag(bool placing);
    std::optional<Drag> drag_;
    int button_ = 0;
};

}  // namespace ember
