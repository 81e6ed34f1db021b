// Makes what is printed: emberleaf_make_pages FONT_FOLDER PAGE_FOLDER.
//
// font.png    the glyphs of glyphs.h in cells of 6×8 pixels, 16 to a row, in their order; the last
//             cell is filled.
// letter.png  a typed letter, music.png a sheet of music: pages of 210 mm × 297 mm.
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "glyphs.h"

namespace {

double hash(int x, int y, int seed) {
    auto h = static_cast<std::uint32_t>(x) * 0x8DA6B343u ^
             static_cast<std::uint32_t>(y) * 0xD8163841u ^
             static_cast<std::uint32_t>(seed) * 0xCB1AB31Fu;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    h ^= h >> 15;
    return h / 4294967296.0;
}

std::uint8_t byte(double v) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
}

void write(const std::string& path, const std::vector<std::uint8_t>& pixels, int width, int height,
           int channels) {
    if (stbi_write_png(path.c_str(), width, height, channels, pixels.data(), channels * width) ==
        0) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
    }
}

// A page of ink, 0 .. 1, drawn in millimetres with soft edges.
class Page {
  public:
    static constexpr int kWide = 512, kHigh = 724;
    void spot(double x, double y, double along, double across, double lean) {
        const double reach = std::max(along, across) + 0.5;
        for (int j = pixel(y - reach); j <= pixel(y + reach); ++j) {
            for (int i = pixel(x - reach); i <= pixel(x + reach); ++i) {
                if (i < 0 || j < 0 || i >= kWide || j >= kHigh) continue;
                const double dx = (i + 0.5) / kScale - x, dy = (j + 0.5) / kScale - y;
                const double u = (dx + lean * dy) / along, v = (dy - lean * dx) / across;
                const double edge = (1 - std::sqrt(u * u + v * v)) * std::min(along, across);
                double& ink = ink_[static_cast<std::size_t>(j * kWide + i)];
                ink = std::max(ink, std::clamp(edge * kScale + 0.5, 0.0, 1.0));
            }
        }
    }
    void line(double x0, double y0, double x1, double y1, double wide) {
        const double length = std::hypot(x1 - x0, y1 - y0);
        for (double t = 0; t <= length; t += 0.15) {
            spot(x0 + (x1 - x0) * t / length, y0 + (y1 - y0) * t / length, wide, wide, 0);
        }
    }
    // Glyphs as struck by a typewriter: a spot for every pixel.
    void type(double x, double y, const std::string& text, double size) {
        for (std::size_t k = 0; k < text.size(); ++k) {
            const double left = x + 6 * size * static_cast<double>(k);
            const double wobble = 0.25 * (hash(static_cast<int>(k), static_cast<int>(y), 9) - 0.5);
            for (const Glyph& glyph : kGlyphs) {
                if (glyph.character != text[k]) continue;
                for (int row = 0; row < 7; ++row) {
                    for (int column = 0; column < 5; ++column) {
                        if ((glyph.rows[static_cast<std::size_t>(row)] >> (4 - column) & 1) == 0)
                            continue;
                        spot(left + column * size, y + wobble + row * size, 0.72 * size,
                             0.72 * size, 0);
                    }
                }
            }
        }
    }
    [[nodiscard]] std::vector<std::uint8_t> pixels() const {
        std::vector<std::uint8_t> grey;
        for (const double ink : ink_)
            grey.push_back(byte(1 - 0.96 * ink));
        return grey;
    }

  private:
    static constexpr double kScale = kWide / 210.0;  // [pixels/mm]
    static int pixel(double mm) { return static_cast<int>(std::floor(mm * kScale)); }
    std::vector<double> ink_ = std::vector<double>(kWide * kHigh, 0.0);
};

Page letter() {
    const char* lines[] = {"the 9th of november",
                           "",
                           "my dear friend,",
                           "",
                           "you asked me to burn this letter",
                           "when you had read it. so hold it",
                           "by its upper edge, light a corner",
                           "and watch the brown line run ahead",
                           "of the flame. what was white turns",
                           "black, what was black turns grey,",
                           "and for a moment every word of it",
                           "shines like silver on the char.",
                           "",
                           "then the sheet will curl and crack,",
                           "small red lines will crawl along the",
                           "cracks and go out one by one, and",
                           "nobody but you will know what i",
                           "wrote.",
                           "",
                           "",
                           "with all my heart,"};
    Page page;
    double y = 28;
    for (const char* line : lines) {
        page.type(22, y, line, 0.74);
        y += 10.2;
    }
    // a signature: one stroke that swings
    for (double t = 0; t < 1; t += 0.002) {
        const double x = 60 + 70 * t, swing = std::sin(26 * t) * (9 - 7 * t);
        page.spot(x + 0.5 * swing, 252 + swing + 4 * std::sin(5 * t), 0.5 + 0.35 * std::cos(26 * t),
                  0.5, 0.4);
    }
    page.line(58, 263, 138, 258, 0.35);
    return page;
}

Page music() {
    Page page;
    for (int staff = 0; staff < 9; ++staff) {
        const double top = 30 + 28.0 * staff;
        for (int line = 0; line < 5; ++line)
            page.line(18, top + 2.2 * line, 192, top + 2.2 * line, 0.16);
        for (int bar = 0; bar <= 4; ++bar)
            page.line(18 + 43.5 * bar, top, 18 + 43.5 * bar, top + 8.8, 0.22);
        double before_x = 0, before_y = 0;
        for (int note = 0; note < 16; ++note) {
            const double x = 24 + 43.5 * (note / 4) + 9.6 * (note % 4);
            const double y = top + 8.8 - 1.1 * std::floor(9 * hash(note, staff, 31));
            const double stem = y - 8.0;
            page.spot(x, y, 1.35, 0.95, -0.35);
            page.line(x + 1.15, y - 0.3, x + 1.15, stem, 0.2);
            if (note % 2 == 1) page.line(before_x, before_y, x + 1.15, stem, 0.5);
            before_x = x + 1.15, before_y = stem;
        }
    }
    return page;
}

std::vector<std::uint8_t> font() {
    constexpr int kColumns = 16, kWide = 6 * kColumns, kHigh = 8 * 4;
    std::vector<std::uint8_t> grey(kWide * kHigh, 0);
    const auto set = [&](int cell, int x, int y) {
        grey[static_cast<std::size_t>((cell / kColumns * 8 + y) * kWide + cell % kColumns * 6 +
                                      x)] = 255;
    };
    int cell = 0;
    for (const Glyph& glyph : kGlyphs) {
        for (int y = 0; y < 7; ++y) {
            for (int x = 0; x < 5; ++x) {
                if ((glyph.rows[static_cast<std::size_t>(y)] >> (4 - x) & 1) != 0) set(cell, x, y);
            }
        }
        ++cell;
    }
    for (int i = 0; i < 48; ++i)
        set(63, i % 6, i / 6);
    return grey;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: %s FONT_FOLDER PAGE_FOLDER\n", argv[0]);
        return 2;
    }
    const std::string fonts = std::string(argv[1]) + '/', folder = std::string(argv[2]) + '/';
    write(fonts + "font.png", font(), 96, 32, 1);
    write(folder + "letter.png", letter().pixels(), Page::kWide, Page::kHigh, 1);
    write(folder + "music.png", music().pixels(), Page::kWide, Page::kHigh, 1);
}
