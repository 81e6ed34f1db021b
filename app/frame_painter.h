// Draws the pictures of a shot: camera and look as they are at each time, and motion blur.
#pragma once

#include <span>

#include "app/frame_source.h"
#include "app/picture_sink.h"
#include "app/render_options.h"
#include "render/renderer.h"

namespace ember {

class FramePainter {
  public:
    /// Makes the GL context, which belongs to the calling thread. `options` must outlive the
    /// painter. Throws RenderError.
    explicit FramePainter(const RenderOptions& options);

    /// Draws what is asked for. Several samples are averaged in linear light; layers other than
    /// the picture itself are those of the first sample, since a mean depth means nothing.
    [[nodiscard]] Picture paint(const RenderJob& job, const PlannedPicture& planned,
                                std::span<const FrameView> samples, bool image, bool layers);

    [[nodiscard]] std::string description() const { return renderer_.description(); }
    [[nodiscard]] std::string backend() const { return std::string(context_->name()); }

  private:
    const RenderOptions& options_;
    std::unique_ptr<OffscreenContext> context_;  // outlives the renderer
    Renderer renderer_;
};

/// Camera and look `clock` [s] after the shot's beginning: keys, and then the turntable.
[[nodiscard]] RenderParams look_at(const RenderJob& job, double turntable, double clock);

/// Mean of images of one size, in linear light and weighted by what each covers.
[[nodiscard]] Image mean_of(std::span<const Image> images);

}  // namespace ember
