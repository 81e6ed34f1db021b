// What a preset may name: files in its own folder and below.
#pragma once

#include <filesystem>

namespace ember {

/// Whether a relative path says that it leaves the folder that it begins in, or is absolute.
[[nodiscard]] bool leads_out(const std::filesystem::path& path);

/// Whether `file` really is elsewhere than in the folder of `preset` or below it, by links.
[[nodiscard]] bool linked_out(const std::filesystem::path& file,
                              const std::filesystem::path& preset);

}  // namespace ember
