#include "app/preset_io/mask_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>

namespace ember {
namespace {

namespace fs = std::filesystem;

struct StbDelete {
    void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

bool leads_out(const fs::path& path) {
    return path.is_absolute() || std::find(path.begin(), path.end(), "..") != path.end();
}

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

// The picture, or what is wrong with it.
std::string read_mask(const fs::path& path, MaskImage& image) {
    if (!fs::is_regular_file(path)) return "there is no file " + path.string();
    std::array<std::uint32_t, 2> size{};
    if (!png_size(path, size)) return path.string() + " is no PNG";
    const std::string pixels_text = path.string() + " has " + std::to_string(size[0]) + " x " +
                                    std::to_string(size[1]) + " pixels, ";
    if (size[0] < 2 || size[1] < 2) return pixels_text + "a picture needs 2 x 2";
    if (std::uint64_t{size[0]} * size[1] > kMostMaskPixels)
        return pixels_text + "more than 8192 x 8192";
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_uc, StbDelete> pixels(
        stbi_load(path.c_str(), &width, &height, &channels, 2));  // grey and opacity
    if (pixels == nullptr) return path.string() + " cannot be read: " + stbi_failure_reason();
    image.width = width;
    image.height = height;
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image.paper.resize(count);
    bool any = false;
    for (std::size_t i = 0; i < count; ++i) {
        image.paper[i] = pixels.get()[2 * i] >= 128 && pixels.get()[2 * i + 1] >= 128 ? 1 : 0;
        any = any || image.paper[i] != 0;
    }
    return any ? "" : path.string() + " is black: there is no paper";
}

}  // namespace

std::vector<Diagnostic> read_masks(Params& params, const PresetInfo& info) {
    std::vector<Diagnostic> problems;
    const std::vector<SheetParams> sheets = sheets_of(params);
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const std::string& name = sheets[i].mask;
        const auto known = [&](const auto& mask) { return mask->name == name; };
        if (name.empty() || std::any_of(params.masks.begin(), params.masks.end(), known)) continue;
        const std::string key =
            params.sheets.empty() ? "sheet.mask" : "sheets." + std::to_string(i + 1) + ".mask";
        Diagnostic problem = place_error(info, SceneError(key, ""));
        const fs::path said_in = problem.line > 0 ? fs::path(problem.file) : info.path;
        auto image = std::make_shared<MaskImage>();
        image->name = name;
        problem.message = leads_out(name)
                              ? "expected a file in the preset's own folder, got \"" + name + '"'
                              : read_mask(said_in.parent_path() / name, *image);
        if (problem.message.empty()) {
            params.masks.push_back(std::move(image));
        } else {
            problems.push_back(std::move(problem));
        }
    }
    return problems;
}

}  // namespace ember
