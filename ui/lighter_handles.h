// Handles of the lighters in the picture: place, height, nozzle.
#pragma once

#include <optional>

#include "ui/paper_tools.h"

namespace ember {

class LighterHandles {
  public:
    /// Draws the handles over the picture and moves what they hold. Returns whether the mouse is
    /// on one of them, so that it does nothing else. Call within an ImGui frame.
    [[nodiscard]] bool update(const PictureCamera& picture, Workbench& bench);
    [[nodiscard]] bool dragging() const { return held_.has_value(); }

  private:
    enum class Handle { Place, Height, Radius };
    struct Held {
        Handle handle;
        LighterParams before;
        PicturePoint from;
        Vector3 place;  // [m] of the lighter then
    };
    void drag(const PictureCamera& picture, Workbench& bench);
    std::optional<Held> held_;
};

}  // namespace ember
