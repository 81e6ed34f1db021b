// OpenEXR files out and in; the only place that knows the library, which may be missing.
#pragma once

#include <filesystem>

#include "render/float_image.h"
#include "render/image.h"

namespace ember {

/// Whether this program was built with OpenEXR.
[[nodiscard]] bool exr_available();

/// Writes `path` through a temporary file that is renamed when complete, with `text` as attributes.
/// Depth and temperature are stored as 32-bit floats, all else as half. Throws std::runtime_error
/// with path and reason, also when OpenEXR is not there.
void write_exr(const std::filesystem::path& path, const FloatImage& image, const ImageText& text);

/// The texts that write_exr was given. Throws std::runtime_error when the file is missing, not
/// whole or no EXR file.
[[nodiscard]] ImageText read_exr_text(const std::filesystem::path& path);

/// Throws std::runtime_error when the file is missing or no EXR file. Channels by name.
[[nodiscard]] FloatImage read_exr(const std::filesystem::path& path);

}  // namespace ember
