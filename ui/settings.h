// What the window remembers from one time to the next.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ember {

enum class CameraScheme { Viewer, Blender, Maya };

struct Settings {
    int width = 1280, height = 720;  ///< of the window [points]
    bool maximised = false;
    bool show_panel = true, show_info = true, show_profiler = false, show_plots = false;
    CameraScheme scheme = CameraScheme::Viewer;
    std::vector<std::string> recent;  ///< presets, the latest first

    static constexpr std::size_t kMostRecent = 10;
    /// Puts `preset` first.
    void remember(const std::string& preset);
};

/// Reads settings; what is missing or makes no sense is as in a new program.
[[nodiscard]] Settings read_settings(const std::filesystem::path& file);
/// Throws std::runtime_error with path and reason.
void write_settings(const std::filesystem::path& file, const Settings& settings);

}  // namespace ember
