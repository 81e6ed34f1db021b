// The parameter rows of the view.
#include <gtest/gtest.h>

#include <set>

#include "render/view_params.h"

namespace ember {
namespace {

TEST(ViewParameters, EveryDefaultIsAllowedAndWithinWhatWasTried) {
    RenderParams params;
    for (const ParamInfo& row : render_param_rows()) {
        if (!row.is_number()) continue;
        const double value = row.shown(&params);
        EXPECT_TRUE(row.hard.contains(value)) << row.key << " = " << value;
        EXPECT_TRUE(row.tested.contains(value)) << row.key << " = " << value;
        EXPECT_TRUE(row.hard.contains(row.tested.min) && row.hard.contains(row.tested.max))
            << row.key;
    }
}

TEST(ViewParameters, EveryRowReadsAndWritesAFieldOfItsOwn) {
    for (const ParamInfo& row : render_param_rows()) {
        RenderParams params;
        if (row.is_number()) {
            const double other = row.shown(&params) == row.hard.min ? row.hard.max : row.hard.min;
            row.set_shown(&params, other);
            EXPECT_NEAR(row.shown(&params), other, 1e-9) << row.key;
        } else {
            row.assign(&params, std::string("page.png"));
            EXPECT_EQ(row.value(&params), ParamValue(std::string("page.png"))) << row.key;
        }
        const RenderParams defaults;
        for (const ParamInfo& rest : render_param_rows()) {
            if (rest.key != row.key) {
                EXPECT_EQ(rest.value(&params), rest.value(&defaults))
                    << row.key << " moves " << rest.key;
            }
        }
    }
}

TEST(ViewParameters, ThereIsANameForEveryViewMode) {
    const ParamInfo* mode = find_param(render_param_rows(), "view.mode");
    ASSERT_NE(mode, nullptr);
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Beauty)], "beauty");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Lattice)], "lattice");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Temperature)], "temperature");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Mass)], "mass");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Stress)], "stress");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::Stiffness)], "stiffness");
    EXPECT_EQ(mode->choices[static_cast<std::size_t>(ViewMode::State)], "state");
    EXPECT_EQ(mode->choices.size(), 7u);
}

}  // namespace
}  // namespace ember
