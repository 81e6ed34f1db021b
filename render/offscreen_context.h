// A GL context without a window: OSMesa, or EGL without a surface, whichever this machine has.
#pragma once

#include <memory>
#include <string_view>

#include "render/renderer.h"

namespace ember {

enum class GlBackend { Auto, OsMesa, Egl };

/// Current from construction to destruction. The libraries are opened at run time, so that the
/// program starts where they are missing.
class OffscreenContext {
  public:
    /// Auto tries OSMesa, then EGL. EGL takes the first graphics card that has OpenGL 3.3, and
    /// Mesa's surfaceless display, usually the software rasteriser, when there is none or
    /// LIBGL_ALWAYS_SOFTWARE is set. Throws RenderError that names what was tried and why it
    /// failed.
    [[nodiscard]] static std::unique_ptr<OffscreenContext> create(GlBackend backend);
    virtual ~OffscreenContext() = default;

    [[nodiscard]] virtual GlLoader loader() const = 0;
    [[nodiscard]] virtual std::string_view name() const = 0;  ///< "osmesa" or "egl"
};

/// Makes Mesa's software rasteriser draw the same bits on every x86-64 processor, by keeping it
/// from using instructions that some lack. Call before the first context; costs about a quarter.
void pin_software_rasteriser();

}  // namespace ember
