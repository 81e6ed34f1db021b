// All pictures of a shot in one, for game engines, with a JSON file that says where each one is.
#pragma once

#include <filesystem>

#include "app/picture_sink.h"

namespace ember {

/// Rows of cells from the top, pictures from left to right. `path` is written when finished, and
/// beside it the same name with .json: {"image", "columns", "rows", "cell": [w, h], "fps",
/// "frames": [{"number", "time", "x", "y", "w", "h"}]} with pixels from the top left corner.
class SpriteSheet final : public PictureSink {
  public:
    /// Throws InputError for a bad grid and for one that would be too large a picture.
    SpriteSheet(std::filesystem::path path, const PictureFormat& format);
    void put(const Picture& picture) override;
    void finish() override;
    [[nodiscard]] std::string where() const override;

  private:
    struct Cell {
        long number;
        double time;
    };
    std::filesystem::path path_;
    PictureFormat format_;
    long columns_ = 1, rows_ = 1;
    Image sheet_;
    std::vector<Cell> cells_;
};

}  // namespace ember
