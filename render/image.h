// 8-bit images: PNG in and out, with texts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/preset_io/png_text.h"

namespace ember {

/// Rows from the top, 4 bytes (sRGB red, green, blue; straight alpha) per pixel.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgba;
};

/// The bytes of a PNG file. Throws std::runtime_error for an image without its pixels.
[[nodiscard]] std::string encode_png(const Image& image, const ImageText& text = {});

/// Writes `path` through a temporary file in the same folder that is renamed when complete.
/// Throws std::runtime_error with path and reason; never leaves half a file under `path`.
void write_png(const std::filesystem::path& path, const Image& image, const ImageText& text = {});

/// Reads a PNG to its end and checks every checksum. Throws std::runtime_error with path and
/// reason when the file is missing, damaged or not whole.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

}  // namespace ember
