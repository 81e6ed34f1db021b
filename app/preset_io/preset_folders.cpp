#include "app/preset_io/preset_folders.h"

namespace ember {

std::filesystem::path find_preset(const std::string& name, const std::filesystem::path& beside) {
    std::vector<std::filesystem::path> places{beside};
    const std::vector<std::filesystem::path> built_in = preset_folders();
    places.insert(places.end(), built_in.begin(), built_in.end());
    for (const std::filesystem::path& place : places) {
        for (const std::string& file : {name, name + ".toml"}) {
            std::filesystem::path path = place / file;
            if (std::filesystem::is_regular_file(path)) return path;
        }
    }
    return {};
}

std::vector<std::filesystem::path> preset_folders() {
    // beside the program first: an installed one must not depend on where it was built
    std::vector<std::filesystem::path> folders;
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) {
        const auto beside = program.parent_path() / "../share/emberleaf/presets";
        folders.push_back(beside.lexically_normal());
    }
    folders.emplace_back(EMBERLEAF_PRESET_FOLDER);
    return folders;
}

}  // namespace ember
