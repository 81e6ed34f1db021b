// A renderer on the pinned software rasteriser.
#pragma once

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "render/offscreen_context.h"
#include "render/renderer.h"
#include "support/staged_world.h"

namespace ember::test {

inline std::unique_ptr<OffscreenContext> pinned_context(GlBackend backend) {
    pin_software_rasteriser();
    return OffscreenContext::create(backend);
}

/// Whether tests/checks/graphics_card asks for this machine's card.
inline bool on_a_card() {
    return std::getenv("EMBERLEAF_TEST_CARD") != nullptr;
}

/// The pinned rasteriser, or the card.
inline std::unique_ptr<OffscreenContext> tested_context() {
    return on_a_card() ? OffscreenContext::create(GlBackend::Egl)
                       : pinned_context(GlBackend::OsMesa);
}

/// Makes the running test fail for everything that the driver has to say from now on: errors,
/// undefined behaviour, what is slow. Installed before the renderer makes its objects.
class DebugOutput {
  public:
    explicit DebugOutput(GlLoader loader) {
        if (gladLoadGL(loader) == 0) throw RenderError("OpenGL entry points cannot be loaded");
        if (GLAD_GL_KHR_debug == 0) return;
        glEnable(GL_DEBUG_OUTPUT);
        glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
        glDebugMessageCallback(note, nullptr);
    }

  private:
    static void note(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei,
                     const GLchar* text, const void*) {
        // a shader that does not compile is an exception already
        if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
        // in which memory a card has a buffer, or that it compiles a program once more, is no
        // complaint
        const bool advice =
            severity == GL_DEBUG_SEVERITY_NOTIFICATION || type == GL_DEBUG_TYPE_PERFORMANCE;
        if (on_a_card() && advice) return;
        ADD_FAILURE() << "OpenGL says: " << text;
    }
};

struct GlRig {
    std::unique_ptr<OffscreenContext> context = tested_context();
    DebugOutput output{context->loader()};
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
