// Draws what Dear ImGui has laid out, with our own GL loader: Debian's back end brings a loader of
// its own, which finds nothing in an off-screen context.
#pragma once

#include <imgui.h>

#include "render/gl_objects.h"
#include "render/shader_library.h"

namespace ember {

/// One per GL context and ImGui context; both must be current.
class ImguiPainter {
  public:
    /// Uploads the font atlas as it is now.
    ImguiPainter();
    /// Draws into framebuffer `target`, over what is there.
    void draw(const ImDrawData& data, unsigned target = 0);

  private:
    Program program_{"ui"};
    Texture font_;
    VertexArray array_;
    Buffer vertices_, indices_;
};

}  // namespace ember
