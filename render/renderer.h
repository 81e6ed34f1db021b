// Draws a world into the current GL context; knows nothing of time, files or windows.
#pragma once

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/image.h"
#include "render/view_params.h"
#include "sim/world_view.h"

namespace ember {

/// GL could not be used: no context, a shader that does not compile (names file and line), ...
class RenderError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Looks up a GL entry point by name, e.g. glfwGetProcAddress.
using GlLoader = void (*(*)(const char* name))();

/// What one frame shows. Spans must stay valid during draw().
struct Frame {
    const WorldView* world = nullptr;
    /// Springs per sheet; only for modes that needs_springs() tells, else may be empty.
    std::span<const std::vector<SpringSegment>> springs;
};

/// How often each pass has run; a pass with nothing to draw does not.
struct PassCounters {
    int frames = 0, shadow = 0, ground = 0, lighter = 0, sheets = 0, lattice = 0, fire = 0,
        legend = 0;
};

/// Owns every GL object. One per GL context; the context must be current in every call, the
/// constructor and the destructor included.
class Renderer {
  public:
    /// Loads GL 3.3 core entry points and compiles the shaders. Throws RenderError.
    explicit Renderer(GlLoader loader, int samples = 4);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Draws `frame` at width×height pixels into framebuffer `target` (0: the window).
    void draw(const Frame& frame, const RenderParams& params, int width, int height,
              unsigned target = 0);

    /// Draws into a framebuffer of its own and reads it back.
    [[nodiscard]] Image draw_image(const Frame& frame, const RenderParams& params, int width,
                                   int height);

    [[nodiscard]] PassCounters counters() const;

    /// GL_RENDERER and GL_VERSION, for metadata and bug reports.
    [[nodiscard]] std::string description() const;

  private:
    struct Passes;
    std::unique_ptr<Passes> passes_;
};

}  // namespace ember
