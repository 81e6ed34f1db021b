// The window: one frame after the other, from events to pixels.
#pragma once

#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/params.h"

namespace ember {

struct WindowOptions {
    PresetInfo info;
    Params params;
    RenderParams render;
    int threads = 1;
};

/// Opens the window and runs until it is closed; returns the exit code. Prints the reason and
/// returns 1 where there is no display or no OpenGL 3.3.
int run_window(const WindowOptions& options);

}  // namespace ember
