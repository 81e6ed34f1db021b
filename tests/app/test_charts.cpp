// Charts: well-formed, and everything where it belongs.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

#include "app/bench/chart.h"

namespace ember {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// The first thing that is wrong with a document of elements, attributes and text, or "".
std::string xml_problem(const std::string& text) {
    static const std::regex declaration(R"(^<\?xml version="1.0" encoding="UTF-8"\?>)");
    static const std::regex tag(
        R"(<(/?)([a-z]+)((\s+[A-Za-z][A-Za-z0-9-]*="[^"<&]*(&[a-z]+;[^"<&]*)*")*)\s*(/?)>)");
    static const std::regex words(R"(([^<>&]|&(amp|lt|gt|quot|apos);)*)");
    if (!std::regex_search(text, declaration)) return "no declaration";
    std::vector<std::string> open;
    auto from = text.cbegin() + static_cast<std::ptrdiff_t>(text.find("?>") + 2);
    std::smatch match;
    while (std::regex_search(from, text.cend(), match, tag)) {
        if (!std::regex_match(from, match[0].first, words))
            return "bad text: " + match.prefix().str();
        if (match[1].length() > 0) {
            if (open.empty() || open.back() != match[2].str()) return "closes " + match[2].str();
            open.pop_back();
        } else if (match[6].length() == 0) {
            open.push_back(match[2].str());
        }
        from = match[0].second;
    }
    if (!std::regex_match(from, text.cend(), words)) return "bad end";
    return open.empty() ? "" : "not closed: " + open.back();
}

// Values of an attribute, in order.
std::vector<double> numbers(const std::string& svg, const std::string& element,
                            const std::string& attribute) {
    const std::regex pattern('<' + element + "\\b[^>]*\\s" + attribute + "=\"([-0-9.]+)\"");
    std::vector<double> found;
    for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it)
        found.push_back(std::stod((*it)[1]));
    return found;
}

LineChart wild_chart() {
    LineChart chart{.title = "Errors < 1 & \"more\"",
                    .subtitle = "it's wide",
                    .x_title = "time [s]",
                    .y_title = "error [m]"};
    ChartSeries series{"a <b>", {}};
    for (int i = -12; i < 9; ++i)
        series.points.push_back({std::pow(10.0, i), std::pow(3.0, -i)});
    series.points.push_back({1.0, kNaN, true});
    series.points.push_back({1.0, 0.0});
    chart.series.push_back(series);
    chart.floor = ChartLevel{1e-3, "floor"};
    return chart;
}

TEST(Chart, IsWellFormedWhateverItsTextsAre) {
    EXPECT_EQ(xml_problem(chart_svg(wild_chart())), "");
    EXPECT_NE(xml_problem("<?xml version=\"1.0\" encoding=\"UTF-8\"?><svg><g></svg>"), "");
    EXPECT_NE(xml_problem("<?xml version=\"1.0\" encoding=\"UTF-8\"?><svg>a & b</svg>"), "");
}

TEST(Chart, PutsEveryPointIntoThePlotArea) {
    // circles are the markers of the first series; the last one is in the legend
    const std::string svg = chart_svg(wild_chart());
    std::vector<double> xs = numbers(svg, "circle", "cx"), ys = numbers(svg, "circle", "cy");
    ASSERT_EQ(xs.size(), 22u) << "21 points and a legend";
    const PlotArea area;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        const bool inside =
            xs[i] >= area.left && xs[i] <= area.right && ys[i] >= area.top && ys[i] <= area.bottom;
        outside += inside ? 0u : 1u;
        if (!inside) {
            EXPECT_GT(xs[i], area.right) << "the legend has its own column";
        }
    }
    EXPECT_EQ(outside, 1u);
}

TEST(Chart, MarksWhatFailedAtTheUpperBorder) {
    LineChart chart = wild_chart();
    const std::string with = chart_svg(chart);
    std::erase_if(chart.series[0].points, [](const ChartPoint& p) { return !(p.y > 0); });
    const std::string without = chart_svg(chart);
    EXPECT_NE(with.find(">failed<"), std::string::npos);
    EXPECT_EQ(without.find(">failed<"), std::string::npos);
    EXPECT_EQ(numbers(with, "line", "x1").size(), numbers(without, "line", "x1").size() + 6)
        << "two points and the legend, two strokes each";
}

TEST(Chart, WritesDecadesShortly) {
    const ChartAxis axis(AxisScale::Logarithmic, {1e-7, 3.0});
    std::string labels;
    for (const AxisTick& tick : axis.ticks()) {
        EXPECT_TRUE(axis.covers(tick.value));
        if (!tick.label.empty()) labels += tick.label + ' ';
    }
    EXPECT_EQ(labels, "1e-7 1e-6 1e-5 1e-4 1e-3 1e-2 1e-1 1e0 ");
    std::size_t named = 0;
    for (const AxisTick& tick : ChartAxis(AxisScale::Logarithmic, {1e-30, 1e30}).ticks())
        named += tick.label.empty() ? 0u : 1u;
    EXPECT_GE(named, 4u);
    EXPECT_LE(named, 10u) << "they must not overlap";
    EXPECT_FALSE(axis.covers(0));
}

TEST(BarChart, StacksBarsFromTheAxisUp) {
    const std::string svg = chart_svg(BarChart{.title = "t",
                                               .x_title = "x",
                                               .y_title = "y",
                                               .categories = {"one", "two"},
                                               .series = {"a", "b"},
                                               .values = {{1, 2}, {3, 0.5}}});
    EXPECT_EQ(xml_problem(svg), "");
    const auto y = numbers(svg, "rect", "y"), height = numbers(svg, "rect", "height");
    ASSERT_EQ(y.size(), 1u + 4u + 2u) << "page, bars, legend";
    EXPECT_NEAR(y[1] + height[1], PlotArea().bottom, 0.02);
    EXPECT_NEAR(y[2] + height[2], y[1], 0.02) << "b stands on a";
    EXPECT_NEAR(height[2], 3 * height[1], 0.05);
}

}  // namespace
}  // namespace ember
