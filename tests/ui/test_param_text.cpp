// What the rows of the parameter tables look like on a panel.
#include <gtest/gtest.h>

#include <cmath>

#include "render/view_params.h"
#include "sim/param_table.h"
#include "ui/param_text.h"

namespace ember {
namespace {

const ParamInfo& row(std::string_view key) {
    return *find_param(sim_param_rows(), key);
}

TEST(ParamText, UnitsAreShownAsPeopleWriteThem) {
    EXPECT_EQ(unit_text("g/m^2"), "g/m\u00b2");
    EXPECT_EQ(unit_text("kg/m^3"), "kg/m\u00b3");
    EXPECT_EQ(unit_text("degC"), "\u00b0C");
    EXPECT_EQ(value_format(row("fracture.threshold")), "%.15g %%");
}

TEST(ParamText, NamesAreWordsAndSymbolsOfThePaperStayAsTheyAre) {
    EXPECT_EQ(label_text(row("world.held_gravity")), "held gravity");
    EXPECT_EQ(label_text(row("paper.c_s")), "c_s");
    EXPECT_EQ(group_text("paper"), "Paper");
    EXPECT_EQ(symbol_text(row("paper.density")), "\u03c1");
    EXPECT_EQ(symbol_text(row("paper.grammage")), "G");
}

TEST(ParamText, ValuesShowNoNoiseOfUnitConversion) {
    Params params;
    params.paper.c_s = 3e-12;
    params.lighter.x = 0.1 + 0.2;  // 0.30000000000000004
    EXPECT_EQ(shown_value(row("paper.c_s"), &params), "3e-12");
    EXPECT_EQ(shown_value(row("lighter.x"), &params), "300 mm");
    EXPECT_EQ(shown_value(row("heat.ambient"), &params), "20 \u00b0C");
    EXPECT_EQ(shown_value(row("lighter.on"), &params), "on");
    EXPECT_EQ(shown_value(row("sheet.held"), &params), "main start");
}

TEST(ParamText, EverySliderHasARangeWithinWhatIsAllowed) {
    const Params params;
    const RenderParams render;
    const auto check = [](const ParamInfo& r, const void* defaults) {
        if (r.kind != ParamKind::Real && r.kind != ParamKind::Integer) return;
        const double shown = r.shown(defaults);
        const ParamRange range = slider_range(r, shown);
        EXPECT_LT(range.min, range.max) << r.key;
        EXPECT_GE(range.min, r.hard.min) << r.key;
        EXPECT_LE(range.max, r.hard.max) << r.key;
        EXPECT_TRUE(std::isfinite(range.max)) << r.key;
        EXPECT_TRUE(range.contains(r.tested.min) && range.contains(r.tested.max)) << r.key;
        if (r.scale == ParamScale::Logarithmic) {
            EXPECT_GT(range.min, 0) << r.key;
        }
    };
    for (const ParamInfo& r : sim_param_rows())
        check(r, &params);
    for (const ParamInfo& r : render_param_rows())
        check(r, &render);
}

TEST(ParamText, ADraggedValueIsRounded) {
    const ParamInfo& factor = row("shrinkage.factor");
    EXPECT_DOUBLE_EQ(tidy(factor, slider_range(factor, 5), 1.23456e-11), 1.23e-11);
    const ParamInfo& x = row("lighter.x");
    EXPECT_DOUBLE_EQ(tidy(x, slider_range(x, 0), 12.3456), 12);
    EXPECT_FALSE(std::signbit(tidy(x, slider_range(x, 0), -0.001)));
}

}  // namespace
}  // namespace ember
