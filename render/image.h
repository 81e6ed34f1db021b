// 8-bit images: PNG in and out, with text chunks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ember {

/// Rows from the top, 4 bytes (sRGB red, green, blue; straight alpha) per pixel.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// PNG tEXt chunks: keyword (1 to 79 Latin-1 characters) and text.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// Writes `path` through a temporary file in the same folder that is renamed when complete.
/// Throws std::runtime_error with path and reason; never leaves half a file under `path`.
void write_png(const std::filesystem::path& path, const Image& image, const ImageText& text = {});

/// Throws std::runtime_error when the file is missing or is no image.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

/// The text chunks of a PNG.
[[nodiscard]] ImageText read_png_text(const std::filesystem::path& path);

}  // namespace ember
