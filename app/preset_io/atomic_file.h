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

/// Makes `temporary`, a complete file, durable and gives it the name `path`. Throws
/// std::runtime_error with path and reason, and then removes it.
void publish_file(const std::filesystem::path& temporary, const std::filesystem::path& path);

/// Name of the temporary file for `path`, in the same folder: hidden, with this machine's name and
/// the number of this process, and with the extension of `path`.
[[nodiscard]] std::filesystem::path temporary_name(const std::filesystem::path& path);

/// Removes the temporary files in `folder` that processes of this machine have left there when
/// they were killed: those whose process is no more.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace ember
