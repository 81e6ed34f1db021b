// emberleaf check FILE...: validate presets.
#pragma once

#include "app/command_list.h"

namespace ember {
void declare_check(CLI::App& program, Command& command);
}
