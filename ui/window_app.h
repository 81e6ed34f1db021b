// The window: one frame after the other, from events to pixels.
#pragma once

#include <filesystem>
#include <string>

#include "ui/document.h"

namespace ember {

struct WindowOptions {
    Document document;
    int threads = 1;
    double ui_scale = 0;  ///< of panels and text; 0: as the monitor says
    std::string version;  ///< for pictures
    /// Shaders and textures from here, read again whenever they change; empty: the program's own.
    std::filesystem::path shaders;
};

/// Opens the window and runs until it is closed; returns the exit code. Prints the reason and
/// returns 1 where there is no display or no OpenGL 3.3.
int run_window(const WindowOptions& options);

}  // namespace ember
