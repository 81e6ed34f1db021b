// Shaders and textures, embedded in the binary.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

namespace ember {

struct Asset {
    std::string_view name;  ///< file name without folders
    std::span<const unsigned char> bytes;
};

/// Every file of shaders/ and textures/.
[[nodiscard]] std::span<const Asset> assets();

/// From now on files of `folder` stand in for embedded ones of the same name; empty: none does.
void use_asset_folder(const std::filesystem::path& folder);

/// Contents of the asset `name`; throws RenderError when there is none.
[[nodiscard]] std::span<const unsigned char> asset(std::string_view name);

}  // namespace ember
