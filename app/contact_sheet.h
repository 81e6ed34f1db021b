// Many small pictures in one, with a line of text below each.
#pragma once

#include <span>
#include <string>

#include "render/image.h"

namespace ember {

struct LabelledPicture {
    Image image;
    std::string label;
};

/// Cells of equal size in `columns` columns from the left and the top, on grey. All pictures must
/// have the size of the first.
[[nodiscard]] Image contact_sheet(std::span<const LabelledPicture> pictures, int columns);

/// Draws `text` in white from pixel (x, y) on, each pixel of the letters `scale` pixels wide.
/// Capitals become small letters, other characters that the font lacks become spaces.
void draw_text(Image& image, int x, int y, const std::string& text, int scale);

}  // namespace ember
