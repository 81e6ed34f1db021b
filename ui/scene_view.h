// The paper in the window: what was drawn last is kept, so that panels can be redrawn alone.
#pragma once

#include <string>

#include "render/renderer.h"
#include "ui/imgui_painter.h"
#include "ui/kept_picture.h"
#include "ui/paper_tools.h"

namespace ember {

/// The camera of a picture in that part of the window.
[[nodiscard]] PictureCamera camera_of(const PictureRect& picture, const CameraParams& camera);

/// Needs the window's GL context in every call.
class SceneView {
  public:
    SceneView(GlLoader loader, std::string version)
        : renderer_(loader), version_(std::move(version)) {}

    /// Draws the burn, or two side by side, and the panels over it, into framebuffer `target` of
    /// that size [pixels]. While it plays and a picture takes long, pictures are simpler; a paused
    /// one is drawn in full.
    void draw(Workbench& bench, const PictureRect& picture, double scale, int width, int height,
              unsigned target);

    /// Saves what the picture shows, with its settings, and says where.
    void screenshot(Workbench& bench, const PictureRect& picture, double scale, bool transparent);

  private:
    void draw_one(const Snapshot& shot, bool beside, const RenderParams& render, int width,
                  int height, KeptPicture& kept);
    Renderer renderer_;
    ImguiPainter painter_;
    KeptPicture left_, right_;
    std::string version_;
    double picture_seconds_ = 0;
    bool simple_ = false;
};

}  // namespace ember
