#include "app/preset_io/picture_file.h"

#include <stb_image.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>

#include "app/preset_io/own_folder.h"
#include "app/preset_io/png_text.h"

namespace ember {
namespace {

namespace fs = std::filesystem;

struct StbDelete {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

// Width and height as the header of a PNG says them; false for what is no PNG. Not left to the
// decoder, which says of a picture that is too large for it that it is none.
bool png_size(const fs::path& path, std::array<std::uint32_t, 2>& size) {
    constexpr std::string_view kStart("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    std::array<char, 24> head{};
    std::ifstream file(path, std::ios::binary);
    if (!file.read(head.data(), head.size())) return false;
    for (std::size_t i = 0; i < 8; ++i)
        size[i / 4] = size[i / 4] << 8 | static_cast<unsigned char>(head[kStart.size() + i]);
    return std::string_view(head.data(), kStart.size()) == kStart;
}

// Reads the picture, or returns what is wrong with it.
std::string read_png(const fs::path& path, PictureFile& picture) {
    if (!fs::is_regular_file(path)) return "there is no file " + path.string();
    std::array<std::uint32_t, 2> size{};
    if (!png_size(path, size)) return path.string() + " is no PNG";
    const std::string pixels_text = path.string() + " has " + std::to_string(size[0]) + " x " +
                                    std::to_string(size[1]) + " pixels, ";
    if (size[0] < 2 || size[1] < 2) return pixels_text + "a picture needs 2 x 2";
    if (std::max(size[0], size[1]) > kMostPicturePixels)
        return pixels_text + "more than 8192 x 8192";
    int channels = 0;
    const std::unique_ptr<stbi_uc, StbDelete> pixels(
        stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 4));
    if (pixels == nullptr) return path.string() + " cannot be read: " + stbi_failure_reason();
    const auto count =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgba.assign(pixels.get(), pixels.get() + 4 * count);
    return "";
}

// The preset beside which `name` is: the one that says it, or the one that the picture which says
// it was made from.
fs::path preset_of(const std::string& name, const fs::path& said_in) {
    if (fs::exists(said_in.parent_path() / name) || !is_png(said_in)) return said_in;
    const ImageText text = read_png_text(said_in);
    const std::string* source = find_text(text, "Source");
    return source == nullptr ? said_in : find_preset(*source, {});
}

}  // namespace

Diagnostic read_picture(const std::string& key, const std::string& name, const PresetInfo& info,
                        PictureFile& picture) {
    Diagnostic problem = place_error(info, SceneError(key, ""));
    const fs::path said_in = problem.line > 0 ? fs::path(problem.file) : info.path;
    const fs::path preset = preset_of(name, said_in);
    picture.path = preset.parent_path() / name;
    problem.message = leads_out(name) || linked_out(picture.path, preset)
                          ? "expected a file in the preset's own folder, got \"" + name + '"'
                          : read_png(picture.path, picture);
    return problem;
}

}  // namespace ember
