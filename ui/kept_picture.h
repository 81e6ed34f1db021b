// The last picture of the scene, kept so that panels can be redrawn alone while nothing burns.
#pragma once

#include <cstdint>

#include "render/gl_objects.h"
#include "render/view_params.h"

namespace ember {

/// What a picture depends on.
struct PictureKey {
    std::uint64_t revision = 0;  ///< of the session
    bool beside = false;         ///< of the one that burns beside it
    RenderParams render;
    int width = 0, height = 0;
};

class KeptPicture {
  public:
    /// Whether a picture with this key is kept; if not, makes room for it.
    [[nodiscard]] bool holds(const PictureKey& key);
    /// Whatever is kept is no longer true.
    void forget() { key_ = {}; }
    /// Framebuffer to draw a new one into.
    [[nodiscard]] unsigned framebuffer() const { return framebuffer_.name(); }
    /// Copies it into framebuffer `target`, with its lower left corner at (x, y) [pixels].
    void show(int x, int y, unsigned target) const;

  private:
    Texture colour_;
    Framebuffer framebuffer_;
    PictureKey key_;
};

}  // namespace ember
