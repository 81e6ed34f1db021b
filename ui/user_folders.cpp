#include "ui/user_folders.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace ember {
namespace {

std::filesystem::path from_environment(const char* name) {
    const char* value = std::getenv(name);
    const std::filesystem::path path = value == nullptr ? "" : value;
    return path.is_absolute() ? path : std::filesystem::path();
}

std::filesystem::path home() {
    const std::filesystem::path path = from_environment("HOME");
    return path.empty() ? std::filesystem::temp_directory_path() : path;
}

std::filesystem::path base(const char* variable, const char* below_home) {
    const std::filesystem::path path = from_environment(variable);
    return (path.empty() ? home() / below_home : path) / "emberleaf";
}

// A line such as XDG_PICTURES_DIR="$HOME/Bilder" of the desktop's own file.
std::filesystem::path desktop_folder(const std::string& name, const char* otherwise) {
    const std::filesystem::path set = from_environment(name.c_str());
    if (!set.empty()) return set / "emberleaf";
    const std::filesystem::path config = from_environment("XDG_CONFIG_HOME");
    std::ifstream in((config.empty() ? home() / ".config" : config) / "user-dirs.dirs");
    for (std::string line; std::getline(in, line);) {
        const std::string start = name + "=\"";
        if (!line.starts_with(start) || line.back() != '"') continue;
        std::string value = line.substr(start.size(), line.size() - start.size() - 1);
        if (value.starts_with("$HOME")) value = home().string() + value.substr(5);
        return std::filesystem::path(value) / "emberleaf";
    }
    return home() / otherwise / "emberleaf";
}

}  // namespace

UserFolders user_folders() {
    return {base("XDG_CONFIG_HOME", ".config"),
            base("XDG_DATA_HOME", ".local/share") / "presets",
            base("XDG_CACHE_HOME", ".cache"),
            base("XDG_STATE_HOME", ".local/state"),
            desktop_folder("XDG_PICTURES_DIR", "Pictures"),
            desktop_folder("XDG_VIDEOS_DIR", "Videos")};
}

}  // namespace ember
