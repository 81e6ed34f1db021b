#include "app/sprite_sheet.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/exit_code.h"
#include "app/frame_list.h"
#include "app/preset_io/atomic_file.h"

namespace ember {
namespace {

constexpr long kLargestSide = 32768;  // [pixels]

}  // namespace

SpriteSheet::SpriteSheet(std::filesystem::path path, const PictureFormat& format)
    : path_(std::move(path)), format_(format) {
    columns_ = static_cast<long>(std::ceil(std::sqrt(static_cast<double>(format.count))));
    rows_ = (format.count + columns_ - 1) / columns_;
    if (!format.grid.empty()) {
        const PictureSize grid = parse_size(format.grid, "--grid", "COLUMNSxROWS");
        columns_ = grid.width;
        rows_ = grid.height;
        if (columns_ * rows_ < format.count) {
            throw InputError("--grid: error: " + format.grid + " has no room for " +
                             std::to_string(format.count) + " pictures");
        }
    }
    const long width = columns_ * format.width, height = rows_ * format.height;
    if (width > kLargestSide || height > kLargestSide) {
        throw InputError("-o " + path_.string() + ": error: the sheet would have " +
                         std::to_string(width) + 'x' + std::to_string(height) +
                         " pixels, more than any texture; draw fewer frames (--frames 0..240+4) "
                         "or smaller ones (--size)");
    }
    sheet_ = {static_cast<int>(width), static_cast<int>(height), {}};
    sheet_.rgba.resize(static_cast<std::size_t>(width * height * 4));
    make_folder_of(path_);
}

void SpriteSheet::put(const Picture& picture) {
    const auto index = static_cast<long>(cells_.size());
    const long x = index % columns_ * format_.width, y = index / columns_ * format_.height;
    const auto row = static_cast<std::ptrdiff_t>(format_.width) * 4;
    for (std::ptrdiff_t line = 0; line < format_.height; ++line) {
        std::copy_n(picture.image.rgba.begin() + line * row, row,
                    sheet_.rgba.begin() + ((y + line) * sheet_.width + x) * 4);
    }
    cells_.push_back({picture.number, picture.time});
}

void SpriteSheet::finish() {
    nlohmann::ordered_json frames = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const auto index = static_cast<long>(i);
        frames.push_back({{"number", cells_[i].number},
                          {"time", cells_[i].time},
                          {"x", index % columns_ * format_.width},
                          {"y", index / columns_ * format_.height},
                          {"w", format_.width},
                          {"h", format_.height}});
    }
    const nlohmann::ordered_json document = {
        {"image", path_.filename().string()},      {"columns", columns_}, {"rows", rows_},
        {"cell", {format_.width, format_.height}}, {"fps", format_.fps},  {"frames", frames}};
    write_png(path_, sheet_, format_.text);
    std::filesystem::path json = path_;
    write_file(json.replace_extension(".json"), document.dump(1) + '\n');
}

std::string SpriteSheet::where() const {
    std::filesystem::path json = path_;
    return path_.string() + " and " + json.replace_extension(".json").string() + ": " +
           std::to_string(cells_.size()) + " pictures, " + std::to_string(columns_) + " by " +
           std::to_string(rows_);
}

}  // namespace ember
