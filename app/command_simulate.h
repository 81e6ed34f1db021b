// emberleaf simulate PRESET: no rendering; statistics and states.
#pragma once

#include "app/command_list.h"

namespace ember {
void declare_simulate(CLI::App& program, Command& command);
}
