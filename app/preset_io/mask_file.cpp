#include "app/preset_io/mask_file.h"

#include <algorithm>
#include <memory>

#include "app/preset_io/picture_file.h"

namespace ember {
namespace {

// Where `picture` is opaque and at least half as bright as white; false when that is nowhere.
bool cut_out(const PictureFile& picture, MaskImage& image) {
    image.width = picture.width;
    image.height = picture.height;
    image.paper.resize(picture.rgba.size() / 4);
    bool any = false;
    for (std::size_t i = 0; i < image.paper.size(); ++i) {
        const std::uint8_t* p = &picture.rgba[4 * i];
        // luma of BT.601 in 1/256, as for grey pictures, which it leaves as they are
        const int grey = (77 * p[0] + 150 * p[1] + 29 * p[2]) >> 8;
        image.paper[i] = grey >= 128 && p[3] >= 128 ? 1 : 0;
        any = any || image.paper[i] != 0;
    }
    return any;
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
        PictureFile picture;
        Diagnostic problem = read_picture(key, name, info, picture);
        auto image = std::make_shared<MaskImage>();
        image->name = name;
        if (problem.message.empty() && !cut_out(picture, *image))
            problem.message = picture.path.string() + " is black: there is no paper";
        if (problem.message.empty()) {
            params.masks.push_back(std::move(image));
        } else {
            problems.push_back(std::move(problem));
        }
    }
    return problems;
}

}  // namespace ember
