// Pictures that presets name: outlines of sheets, and what is printed on them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/preset_io/preset_io.h"

namespace ember {

/// Rows from the top, 4 bytes (sRGB red, green, blue; straight alpha) per pixel.
struct PictureFile {
    std::filesystem::path path;
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

inline constexpr int kMostPicturePixels = 8192;  ///< along either side

/// Reads the PNG that `key` names. `name` is a path within the folder of the preset that says it
/// (of the preset that is run, for --set). Returns what is wrong, at that key: a path that leads
/// out of that folder, no file, no PNG, or a picture of a single pixel or of more than
/// kMostPicturePixels either way, which is refused before it is decoded. An empty message: read.
[[nodiscard]] Diagnostic read_picture(const std::string& key, const std::string& name,
                                      const PresetInfo& info, PictureFile& picture);

}  // namespace ember
