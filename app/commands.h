// The subcommands. Each adds itself to the command line and, when chosen, leaves what to run.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace ember {

/// What the command line asks for; returns the exit code, or throws InputError or RunError.
using Task = std::function<int()>;

void add_render_command(CLI::App& app, Task& task);
void add_simulate_command(CLI::App& app, Task& task);
void add_check_command(CLI::App& app, Task& task);
void add_bench_command(CLI::App& app, Task& task);
void add_presets_command(CLI::App& app, Task& task);
void add_params_command(CLI::App& app, Task& task);
/// The program without a subcommand: `emberleaf [PRESET]`.
void add_window_command(CLI::App& app, Task& task);

}  // namespace ember
