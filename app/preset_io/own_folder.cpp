#include "app/preset_io/own_folder.h"

#include <algorithm>

namespace ember {

bool leads_out(const std::filesystem::path& path) {
    return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

bool linked_out(const std::filesystem::path& file, const std::filesystem::path& preset) {
    std::error_code unknown;
    const auto place = std::filesystem::weakly_canonical(file, unknown);
    if (unknown) return false;  // what cannot be followed cannot be read either
    const auto folder = std::filesystem::weakly_canonical(
        std::filesystem::absolute(preset, unknown).parent_path(), unknown);
    return !unknown && leads_out(place.lexically_relative(folder));
}

}  // namespace ember
