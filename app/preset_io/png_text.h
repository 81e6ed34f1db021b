// The texts in a PNG file, read without decoding its pixels.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace ember {

/// Keyword (1 to 79 Latin-1 characters) and text (UTF-8), as a PNG's tEXt and iTXt chunks have
/// them.
using ImageText = std::vector<std::pair<std::string, std::string>>;

/// Whether the file begins as a PNG does.
[[nodiscard]] bool is_png(const std::filesystem::path& path);

/// The texts of a PNG that are not compressed, in their order. Throws std::runtime_error with path
/// and reason when it is none or a chunk is not whole.
[[nodiscard]] ImageText read_png_text(const std::filesystem::path& path);

/// The text of `keyword`, or null.
[[nodiscard]] const std::string* find_text(const ImageText& text, std::string_view keyword);

}  // namespace ember
