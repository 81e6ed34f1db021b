// Draws a world into the current GL context; knows nothing of time, files or windows.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "render/float_image.h"
#include "render/image.h"
#include "render/view_params.h"
#include "sim/world_view.h"

namespace ember {

struct PassInput;

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

/// How often each pass has run; a pass with nothing to draw does not. And how often vertices of
/// paper and fire went to their buffers: only when they have changed.
struct PassCounters {
    int frames = 0, shadow = 0, ground = 0, lighter = 0, sheets = 0, lattice = 0, fire = 0,
        bloom = 0, legend = 0, uploads = 0;
};

/// Is told the name of each pass when all its work is done; for measuring.
using PassObserver = std::function<void(std::string_view pass)>;

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

    /// Linear light and what it is made of, for compositing and grading, as channels of an EXR
    /// file: R G B A           light of the whole picture, premultiplied, without exposure, bloom
    /// and tone
    ///                   curve; fire may send more light than its alpha covers
    /// albedo.R ...      reflectance of the paper        emission.R ...  light that it glows with
    /// normal.X ...      towards the camera, in the world
    /// depth.Z           [m] from the camera along its axis; 1e10 where no paper is
    /// temperature.T     [degC]                          phase.id        0, 1, 2; -1 without paper
    /// All but the first four show paper only, and have one sample per pixel.
    [[nodiscard]] FloatImage draw_layers(const Frame& frame, const RenderParams& params, int width,
                                         int height);

    /// Has `observer` told of each pass from now on, which makes every pass wait for its end; an
    /// empty one ends that.
    void observe_passes(PassObserver observer);

    /// Makes all programs and textures anew, from the files of `folder` where it has them. Throws
    /// RenderError, with file and line, when one is not good; then what has been stays in use.
    void reload(const std::filesystem::path& folder);

    [[nodiscard]] PassCounters counters() const;

    /// GL_RENDERER and GL_VERSION, for metadata and bug reports.
    [[nodiscard]] std::string description() const;

  private:
    struct Passes;
    void draw_scene(const PassInput& in);
    std::unique_ptr<Passes> passes_;
    GlLoader loader_;
};

}  // namespace ember
