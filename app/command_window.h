// emberleaf [PRESET]: the window.
#pragma once

#include <string>

namespace ember {

/// Opens the window on `preset`; returns the exit code.
int run_window_command(const std::string& preset);

}  // namespace ember
