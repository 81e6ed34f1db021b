// The subcommands, one row each: from it come the parser, every help text, the manual page and
// the completions of shells.
#pragma once

#include <functional>
#include <span>
#include <string_view>

namespace CLI {
class App;
}

namespace ember {

/// What the command line asks for; returns the exit code, or throws InputError or RunError.
using Task = std::function<int()>;

/// A command line that does something useful, and what that is.
struct Example {
    std::string_view line, what;
};

struct CommandRow {
    std::string_view name;  ///< empty: the program without a subcommand
    std::string_view summary;
    /// Adds options to `command` and, when it is chosen, leaves what to run in `task`.
    void (*add)(CLI::App& command, Task& task);
    std::span<const Example> examples;
};

[[nodiscard]] std::span<const CommandRow> command_rows();
/// The row of a subcommand, or null.
[[nodiscard]] const CommandRow* find_command(std::string_view name);

/// Builds the whole command line from the rows.
void build_command_line(CLI::App& app, Task& task);

void add_render_command(CLI::App& command, Task& task);
void add_sheet_command(CLI::App& command, Task& task);
void add_simulate_command(CLI::App& command, Task& task);
void add_export_command(CLI::App& command, Task& task);
void add_sweep_command(CLI::App& command, Task& task);
void add_show_command(CLI::App& command, Task& task);
void add_diff_command(CLI::App& command, Task& task);
void add_check_command(CLI::App& command, Task& task);
void add_bench_command(CLI::App& command, Task& task);
void add_presets_command(CLI::App& command, Task& task);
void add_params_command(CLI::App& command, Task& task);
void add_man_command(CLI::App& command, Task& task);
void add_completion_command(CLI::App& command, Task& task);
/// The program without a subcommand: `emberleaf [PRESET]`.
void add_window_command(CLI::App& app, Task& task);

}  // namespace ember
