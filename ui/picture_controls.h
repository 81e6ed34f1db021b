// The mouse over the picture: turn, move and zoom the camera, turn the lamp, or use a tool.
#pragma once

#include <optional>

#include "render/view_params.h"
#include "ui/bindings.h"

namespace ember {

/// Part of the window [points] from its upper left corner.
struct PictureRect {
    double x = 0, y = 0, width = 1, height = 1;
};

/// A place in the picture [points] from its upper left corner.
struct PicturePoint {
    double x = 0, y = 0;
};

/// A tool in use: where it is and where it was put on.
struct PictureDrag {
    Drag drag;
    PicturePoint at, from;
    bool begun = false, ended = false;
};

class PictureControls {
  public:
    /// Applies what the mouse did since the last frame to camera and lamp; says which tool is in
    /// use, if one is. `placing`: a plain click places the lighter, and ends that mode. `taken`:
    /// the mouse is on something else. Call within an ImGui frame.
    [[nodiscard]] std::optional<PictureDrag> update(RenderParams& render, CameraScheme scheme,
                                                    const PictureRect& picture, bool& placing,
                                                    bool taken);
    [[nodiscard]] bool dragging() const { return drag_.has_value(); }

  private:
    void begin_drag(CameraScheme scheme, bool placing);
    std::optional<Drag> drag_;
    PicturePoint from_;
    int button_ = 0;
    bool begun_ = false;
};

/// Where the mouse is in the picture, if it is over it and over nothing else.
[[nodiscard]] std::optional<PicturePoint> mouse_in(const PictureRect& picture);

}  // namespace ember
