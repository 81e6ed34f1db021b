// What the colours of a view mean: a scale with numbers, or a list of names. Pure, no GL.
#pragma once

#include <string>
#include <vector>

#include "render/palette.h"
#include "render/view_params.h"

namespace ember {

/// A scale of `map` from `low` to `high`, or entries; empty in pictures. Texts have only characters
/// of textures/glyphs.h, where '*' is a degree sign.
struct Legend {
    struct Tick {
        double at;  ///< [1] 0 at the lower end of the scale, 1 at the upper one
        std::string text;
    };
    struct Entry {
        Colour colour;
        std::string text;
    };
    std::string title;  ///< name and unit
    Colour (*map)(double) = nullptr;
    double low = 0, high = 1;  ///< [unit of the title]
    std::vector<Tick> ticks;
    std::vector<Entry> entries;
    [[nodiscard]] bool empty() const { return title.empty(); }
};

[[nodiscard]] Legend legend_of(const ViewParams& view);

/// One rectangle of a legend: place in the picture [pixels from the lower left corner], cell of the
/// font, colour.
struct LegendVertex {
    float x, y;
    float u, v;     ///< in the font, in pixels of it
    float r, g, b;  ///< linear
};

/// The legend as triangles for a picture of width × height: at its right edge, in letters whose
/// pixels are whole pixels of the picture.
[[nodiscard]] std::vector<LegendVertex> legend_triangles(const Legend& legend, int width,
                                                         int height);

/// Column and row of a character in the font, in cells; the filled cell for others.
[[nodiscard]] int glyph_cell(char character);

}  // namespace ember
