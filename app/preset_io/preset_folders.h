// Where presets are, and which of them a name means.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ember {

/// Finds a preset by path or name, with or without ".toml": in `beside`, then among the built-in
/// ones, as in "paper/corner". Empty when there is none.
[[nodiscard]] std::filesystem::path find_preset(const std::string& name,
                                                const std::filesystem::path& beside);

/// Folders of built-in presets, in order of search.
[[nodiscard]] std::vector<std::filesystem::path> preset_folders();

}  // namespace ember
