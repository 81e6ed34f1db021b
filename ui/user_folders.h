// Where a person's files are, as the XDG base directory specification says.
#pragma once

#include <filesystem>

namespace ember {

/// Each is $XDG_..._HOME/emberleaf, or its place below $HOME; none is created by asking.
struct UserFolders {
    std::filesystem::path config;   ///< settings
    std::filesystem::path presets;  ///< those saved by hand
    std::filesystem::path cache;    ///< thumbnails
    std::filesystem::path state;    ///< takes
    std::filesystem::path pictures;
    std::filesystem::path videos;
};

[[nodiscard]] UserFolders user_folders();

}  // namespace ember
