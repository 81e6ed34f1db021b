// Draws scenes.
#pragma once

#include <memory>

#include "golden/verdict.h"
#include "render/offscreen_context.h"

namespace ember::golden {

enum class Rasteriser {
    Pinned,  ///< the software rasteriser with the instructions that every x86-64 processor has
    AsItIs,  ///< with what this processor has: another environment
    GraphicsCard,  ///< through EGL: another environment
};

/// Owns an OpenGL context; only one may exist at a time.
class Stage {
  public:
    virtual ~Stage() = default;
    /// Scenes of one suite in the order of the table. Throws std::runtime_error.
    [[nodiscard]] virtual Drawn draw(const Scene& scene) = 0;
};

/// A burn of `preset`, a file; stepped as far as its scenes ask.
[[nodiscard]] std::unique_ptr<Stage> picture_stage(const std::filesystem::path& preset,
                                                   Rasteriser rasteriser);
/// The window's panels over a burn of `preset`, a file.
[[nodiscard]] std::unique_ptr<Stage> panel_stage(const std::filesystem::path& preset,
                                                 Rasteriser rasteriser);

/// Before the first context of the process. Returns what its contexts are to be made with.
[[nodiscard]] GlBackend choose_rasteriser(Rasteriser rasteriser);
/// Of the current context.
[[nodiscard]] Environment present_environment(const std::string& renderer);

}  // namespace ember::golden
