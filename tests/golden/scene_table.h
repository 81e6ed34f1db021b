// The scenes that golden pictures show, read from scenes.txt.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ember::golden {

/// One row.
struct Scene {
    std::string suite, name;  ///< "paper_corner", "300_lattice"
    std::string preset;       ///< "paper/corner"
    std::uint64_t tick = 0;
    int width = 0, height = 0;  ///< [pixels]
    int left = 0, top = 0;      ///< [pixels] of the part of the window that panels show
    /// Of a picture: assignments to the renderer's parameters. Of panels: "key=F1".
    std::vector<std::string> words;

    [[nodiscard]] std::string full_name() const { return suite + '.' + name; }
    /// Panels of the window rather than a picture.
    [[nodiscard]] bool panels() const { return suite == "panels"; }
};

/// Throws std::runtime_error with file, line and what was expected: a row that cannot be read, a
/// name that comes twice, a suite with two presets, ticks of a suite that do not ascend.
[[nodiscard]] std::vector<Scene> read_scenes(const std::filesystem::path& file);

}  // namespace ember::golden
