#include "render/legend.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "textures/glyphs.h"

namespace ember {
namespace {

constexpr int kFilled = 63, kColumns = 16, kCellWide = 6, kCellHigh = 8;  // of the font

// A number without trailing zeros, at most three decimals.
std::string number(double value) {
    const auto thousandths = std::llround(value * 1000);
    std::string text = std::to_string(std::llabs(thousandths));
    while (text.size() < 4)
        text.insert(text.begin(), '0');
    text.insert(text.end() - 3, '.');
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    return thousandths < 0 ? '-' + text : text;
}

Legend scale(std::string title, Colour (*map)(double), double low, double high, int steps) {
    Legend legend{std::move(title), map, low, high, {}, {}};
    for (int i = 0; i <= steps; ++i) {
        const double at = static_cast<double>(i) / steps;
        legend.ticks.push_back({at, number(low + at * (high - low))});
    }
    return legend;
}

class Painter {
  public:
    explicit Painter(std::vector<LegendVertex>& out) : out_(out) {}
    void rectangle(float x, float y, float wide, float high, const Colour& c, int cell = kFilled) {
        const auto u = static_cast<float>(cell % kColumns * kCellWide);
        const int row = cell / kColumns;
        const auto v = static_cast<float>(row * kCellHigh);
        const bool filled = cell == kFilled;
        const auto corner = [&](float right, float up) {
            out_.push_back({x + right * wide, y + up * high,
                            u + (filled ? 2.0f : right * (kCellWide - 1)),
                            v + (filled ? 4.0f : (1 - up) * (kCellHigh - 1)), c.x(), c.y(), c.z()});
        };
        corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 0), corner(1, 1), corner(0, 1);
    }
    void text(float x, float y, const std::string& text, float pixel) {
        for (const char c : text) {
            if (c != ' ') {
                rectangle(x, y, (kCellWide - 1) * pixel, (kCellHigh - 1) * pixel,
                          Colour(0.72f, 0.72f, 0.72f), glyph_cell(c));
            }
            x += kCellWide * pixel;
        }
    }

  private:
    std::vector<LegendVertex>& out_;
};

}  // namespace

int glyph_cell(char character) {
    const auto* found = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                     [&](const Glyph& g) { return g.character == character; });
    return found == std::end(kGlyphs) ? kFilled : static_cast<int>(found - std::begin(kGlyphs));
}

Legend legend_of(const ViewParams& view) {
    if (!view.legend) return {};
    switch (view.mode) {
        case ViewMode::Beauty:
            return {};
        case ViewMode::Lattice:
            return {"springs",
                    nullptr,
                    0,
                    1,
                    {},
                    {{spring_colour(SpringColour::Main), "main"},
                     {spring_colour(SpringColour::Cross), "cross"},
                     {spring_colour(SpringColour::Diagonal), "diagonal"},
                     {spring_colour(SpringColour::Bending), "bending"},
                     {spring_colour(SpringColour::Burning), "burning"}}};
        case ViewMode::Temperature:
            return scale("temperature *C", heat_map, 0, kHottest, 4);
        case ViewMode::Mass:
            return scale("mass left %", mass_map, 0, 100, 4);
        case ViewMode::State:
            return {"state",
                    nullptr,
                    0,
                    1,
                    {},
                    {{phase_colour(Phase::Unburnt), "unburnt"},
                     {phase_colour(Phase::Burning), "burning"},
                     {phase_colour(Phase::BurntOut), "burnt out"}}};
        case ViewMode::Stress: {
            const double end = 1e-3 * view.stress_range;
            return scale("stress kPa", stress_map, -end, end, 4);
        }
        case ViewMode::Stiffness:
            return scale("stiffness / mean", mass_map, kSoftest, kStiffest, 4);
    }
    return {};
}

std::vector<LegendVertex> legend_triangles(const Legend& legend, int width, int height) {
    std::vector<LegendVertex> vertices;
    Painter paint(vertices);
    const auto pixel = static_cast<float>(std::max(1, height / 360));
    const float line = 12 * pixel;
    std::size_t longest = legend.title.size();
    for (const auto& entry : legend.entries)
        longest = std::max(longest, entry.text.size() + 3);
    const float left =
        std::floor(static_cast<float>(width) - (6 * static_cast<float>(longest) + 8) * pixel);
    const bool list = !legend.entries.empty();
    const float tall = list ? line * static_cast<float>(legend.entries.size())
                            : std::floor(0.45f * static_cast<float>(height));
    const float bottom = std::floor(0.5f * (static_cast<float>(height) - tall));
    paint.text(left, bottom + tall + line, legend.title, pixel);
    for (std::size_t i = 0; i < legend.entries.size(); ++i) {
        const float y = bottom + tall - line * static_cast<float>(i + 1);
        paint.rectangle(left, y, 8 * pixel, 7 * pixel, legend.entries[i].colour);
        paint.text(left + 14 * pixel, y, legend.entries[i].text, pixel);
    }
    if (legend.map == nullptr) return vertices;
    constexpr int kSlices = 128;
    for (int i = 0; i < kSlices; ++i) {
        const float y = std::floor(tall * static_cast<float>(i) / kSlices);
        const float end = std::floor(tall * static_cast<float>(i + 1) / kSlices);
        paint.rectangle(left, bottom + y, 10 * pixel, end - y, legend.map((i + 0.5) / kSlices));
    }
    for (const auto& tick : legend.ticks) {
        const float y = bottom + std::floor(tall * static_cast<float>(tick.at));
        paint.rectangle(left + 10 * pixel, y, 3 * pixel, pixel, Colour(0.72f, 0.72f, 0.72f));
        paint.text(left + 16 * pixel, y - 3 * pixel, tick.text, pixel);
    }
    return vertices;
}

}  // namespace ember
