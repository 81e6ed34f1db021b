// The paper in the window: what was drawn last is kept, so that panels can be redrawn alone.
#pragma once

#include <filesystem>
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
    /// `shaders`: a folder with shaders and textures that are used instead of the program's own and
    /// read again whenever one changes; empty: none.
    SceneView(GlLoader loader, std::string version, std::filesystem::path shaders = {})
        : renderer_(loader), version_(std::move(version)), shaders_(std::move(shaders)) {}

    /// Looks, once in a while, whether shaders have changed; if so takes the new ones, or keeps
    /// those that it has and says what is wrong with the new. Whether they were taken.
    [[nodiscard]] bool watch_shaders(Workbench& bench);

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
    [[nodiscard]] std::filesystem::file_time_type last_written() const;
    Renderer renderer_;
    ImguiPainter painter_;
    KeptPicture left_, right_;
    std::string version_;
    std::filesystem::path shaders_;
    std::filesystem::file_time_type shaders_written_ = std::filesystem::file_time_type::min();
    double shaders_seen_ = -1;  // [s]
    double picture_seconds_ = 0;
    bool simple_ = false;
};

}  // namespace ember
