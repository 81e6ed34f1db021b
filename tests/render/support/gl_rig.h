// A renderer on the pinned software rasteriser.
#pragma once

#include <glad/gl.h>

#include "render/offscreen_context.h"
#include "render/renderer.h"
#include "support/staged_world.h"

namespace ember::test {

inline std::unique_ptr<OffscreenContext> pinned_context(GlBackend backend = GlBackend::OsMesa) {
    pin_software_rasteriser();
    return OffscreenContext::create(backend);
}

struct GlRig {
    std::unique_ptr<OffscreenContext> context = pinned_context();
    Renderer renderer{context->loader()};

    [[nodiscard]] Image draw(const WorldView& world, const RenderParams& params, int width = 320,
                             int height = 180) {
        Image image = renderer.draw_image({&world, {}}, params, width, height);
        if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
            throw RenderError("OpenGL error " + std::to_string(error) + " in a frame");
        }
        return image;
    }
};

[[nodiscard]] inline RenderParams in_mode(ViewMode mode, bool flames = true) {
    RenderParams params;
    params.view.mode = mode;
    params.view.flames = flames;
    return params;
}

}  // namespace ember::test
