#include "app/contact_sheet.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "textures/glyphs.h"

namespace ember {
namespace {

constexpr int kGap = 4, kGlyphWide = 6, kGlyphHigh = 7;  // [pixels]
constexpr std::uint8_t kGround = 38, kInk = 225;

const Glyph* glyph_of(char character) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
    for (const char wanted : {character, small}) {
        const auto* found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                         [&](const Glyph& g) { return g.character == wanted; });
        if (found != std::end(kGlyphs)) return found;
    }
    return nullptr;
}

void fill(Image& image, int x, int y, int size, std::uint8_t level) {
    for (int row = y; row < std::min(y + size, image.height); ++row) {
        for (int column = x; column < std::min(x + size, image.width); ++column) {
            auto* pixel = &image.rgba[4 * (static_cast<std::size_t>(row) *
                                               static_cast<std::size_t>(image.width) +
                                           static_cast<std::size_t>(column))];
            pixel[0] = pixel[1] = pixel[2] = level;
            pixel[3] = 255;
        }
    }
}

void paste(Image& sheet, const Image& image, int x, int y) {
    for (int row = 0; row < image.height; ++row) {
        const auto* from = image.rgba.data() + std::ptrdiff_t{4} * row * image.width;
        auto* to = sheet.rgba.data() + std::ptrdiff_t{4} * ((y + row) * sheet.width + x);
        for (int i = 0; i < 4 * image.width; i += 4) {  // over the ground, where it is transparent
            const int alpha = from[i + 3];
            for (int c = 0; c < 3; ++c)
                to[i + c] = static_cast<std::uint8_t>(
                    (from[i + c] * alpha + kGround * (255 - alpha)) / 255);
        }
    }
}

}  // namespace

void draw_text(Image& image, int x, int y, const std::string& text, int scale) {
    for (const char character : text) {
        const Glyph* glyph = glyph_of(character);
        for (int row = 0; glyph != nullptr && row < kGlyphHigh; ++row) {
            for (int bit = 0; bit < 5; ++bit) {
                const unsigned line = glyph->rows[static_cast<std::size_t>(row)];
                if ((line >> (4 - bit) & 1u) != 0)
                    fill(image, x + bit * scale, y + row * scale, scale, kInk);
            }
        }
        x += kGlyphWide * scale;
    }
}

Image contact_sheet(std::span<const LabelledPicture> pictures, int columns) {
    const Image& first = pictures.front().image;
    std::size_t longest = 1;
    for (const LabelledPicture& picture : pictures)
        longest = std::max(longest, picture.label.size());
    const int scale = std::clamp(first.width / (kGlyphWide * static_cast<int>(longest)), 1, 3);
    const int cell_wide = first.width + kGap;
    const int cell_high = first.height + (kGlyphHigh + 2) * scale + kGap;
    const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
    Image sheet{columns * cell_wide + kGap, rows * cell_high + kGap, {}};
    sheet.rgba.resize(4 * static_cast<std::size_t>(sheet.width) *
                      static_cast<std::size_t>(sheet.height));
    fill(sheet, 0, 0, std::max(sheet.width, sheet.height), kGround);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const int x = kGap + static_cast<int>(i) % columns * cell_wide;
        const int y = kGap + static_cast<int>(i) / columns * cell_high;
        paste(sheet, pictures[i].image, x, y);
        draw_text(sheet, x, y + first.height + scale, pictures[i].label, scale);
    }
    return sheet;
}

}  // namespace ember
