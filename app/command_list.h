// emberleaf presets, emberleaf params: what there is.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

namespace ember {

/// A subcommand's work, to be called after parsing; returns the exit code.
using Command = std::function<int()>;

void declare_presets(CLI::App& program, Command& command);
void declare_params(CLI::App& program, Command& command);

/// Names of all built-in presets, e.g. "paper/corner", sorted.
[[nodiscard]] std::vector<std::string> built_in_presets();

}  // namespace ember
