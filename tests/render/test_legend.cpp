// What the legends say.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "render/legend.h"

namespace ember {
namespace {

Legend legend(ViewMode mode, double stress = 20e3) {
    ViewParams view;
    view.mode = mode;
    view.stress_range = stress;
    return legend_of(view);
}

std::vector<std::string> labels(const Legend& legend) {
    std::vector<std::string> texts;
    for (const auto& tick : legend.ticks)
        texts.push_back(tick.text);
    return texts;
}

using Texts = std::vector<std::string>;

TEST(Legends, NumbersAreThoseOfTheScale) {
    EXPECT_EQ(labels(legend(ViewMode::Temperature)), (Texts{"0", "275", "550", "825", "1100"}));
    EXPECT_EQ(labels(legend(ViewMode::Mass)), (Texts{"0", "25", "50", "75", "100"}));
    EXPECT_EQ(labels(legend(ViewMode::Stress)), (Texts{"-20", "-10", "0", "10", "20"}));
    EXPECT_EQ(labels(legend(ViewMode::Stress, 500)), (Texts{"-0.5", "-0.25", "0", "0.25", "0.5"}));
    EXPECT_EQ(labels(legend(ViewMode::Stiffness)), (Texts{"0.9", "0.95", "1", "1.05", "1.1"}));
    EXPECT_EQ(legend(ViewMode::Temperature).title, "temperature *C");
    EXPECT_EQ(legend(ViewMode::Stress).title, "stress kPa");
}

TEST(Legends, PhasesAndSpringsAreNamedInTheirColours) {
    const Legend state = legend(ViewMode::State);
    ASSERT_EQ(state.entries.size(), 3u);
    EXPECT_EQ(state.entries[1].text, "burning");
    EXPECT_EQ(state.entries[1].colour, phase_colour(Phase::Burning));
    EXPECT_EQ(legend(ViewMode::Lattice).entries[2].text, "diagonal");
}

TEST(Legends, PicturesHaveNoneAndViewsCanGoWithout) {
    EXPECT_TRUE(legend(ViewMode::Beauty).empty());
    ViewParams view;
    view.mode = ViewMode::Mass;
    view.legend = false;
    EXPECT_TRUE(legend_of(view).empty());
}

TEST(Legends, EveryCharacterHasAGlyphOfItsOwnAndEverythingIsInThePicture) {
    for (const ViewMode mode : {ViewMode::Lattice, ViewMode::Temperature, ViewMode::Mass,
                                ViewMode::State, ViewMode::Stress, ViewMode::Stiffness}) {
        const Legend all = legend(mode);
        std::string text = all.title;
        for (const auto& tick : all.ticks)
            text += tick.text;
        for (const auto& entry : all.entries)
            text += entry.text;
        std::set<int> cells;
        std::set<char> characters;
        for (const char c : text) {
            if (c == ' ') continue;
            EXPECT_NE(glyph_cell(c), glyph_cell('\n')) << c;
            cells.insert(glyph_cell(c)), characters.insert(c);
        }
        EXPECT_EQ(cells.size(), characters.size());
        for (const auto& [width, height] : {std::pair{640, 360}, {1280, 720}, {1920, 1080}}) {
            for (const LegendVertex& v : legend_triangles(all, width, height)) {
                EXPECT_TRUE(v.x >= 0 && v.x <= static_cast<float>(width)) << v.x;
                EXPECT_TRUE(v.y >= 0 && v.y <= static_cast<float>(height)) << v.y;
                EXPECT_FLOAT_EQ(v.x, std::floor(v.x)) << "letters on whole pixels";
            }
        }
    }
}

}  // namespace
}  // namespace ember
