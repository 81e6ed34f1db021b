// Files that appear under their name only when they are complete.
#pragma once

#include <filesystem>
#include <string_view>

namespace ember {

/// Writes `contents` to a temporary file beside `path`, makes it durable, and renames it.
/// Creates missing folders. Throws std::runtime_error with path and reason; leaves nothing
/// half-written.
void write_file(const std::filesystem::path& path, std::string_view contents);

/// Creates the folder that `path` lies in. Throws std::runtime_error.
void make_folder_of(const std::filesystem::path& path);

/// Name of the temporary file for `path`, in the same folder.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& path);

}  // namespace ember
