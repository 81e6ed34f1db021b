// What the mouse does to the paper: place the lighter, set fire, touch, blow. No ImGui.
#pragma once

#include "render/camera.h"
#include "ui/picture_controls.h"
#include "ui/workbench.h"

namespace ember {

/// A picture as it is drawn, for rays through its points.
struct PictureCamera {
    Camera camera;
    PictureRect rect;
    [[nodiscard]] Vector3 eye() const { return camera.eye.cast<double>(); }
    /// Direction through a place of the picture [1].
    [[nodiscard]] Vector3 ray(const PicturePoint& at) const;
    /// Where `at` is on the plane through `place` that faces the camera [m].
    [[nodiscard]] Vector3 beside(const Vector3& place, const PicturePoint& at) const;
};

class PaperTools {
  public:
    /// Goes on with what the mouse does. Everything becomes edits of the parameters, so that takes
    /// know it.
    void use(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench);

  private:
    void ignite(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench);
    void touch(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench);
    void blow(const PictureDrag& drag, const PictureCamera& picture, Workbench& bench);
    std::size_t brush_ = 0;  // the lighter that paints
    bool painting_ = false;
    Vector3 held_ = Vector3::Zero();  // [m] where the paper was taken hold of
    HandParams hand_;                 // before that
    WindParams wind_;                 // before blowing
};

}  // namespace ember
