// emberleaf render PRESET -o frame_####.png: pictures and films without a window.
#pragma once

#include "app/command_list.h"

namespace ember {
void declare_render(CLI::App& program, Command& command);
}
