// Charts as SVG: lines with markers, and stacked bars. The legend has a column of its own, so it
// never covers anything.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bench/chart_axis.h"

namespace ember {

struct ChartPoint {
    double x = 0, y = 0;
    bool failed = false;  ///< drawn as a cross at the upper border, at x
};

struct ChartSeries {
    std::string name;
    std::vector<ChartPoint> points;
    bool joined = true;  ///< by a line, in their order
};

/// A horizontal dashed line with the band below it shaded, e.g. a noise floor.
struct ChartLevel {
    double y = 0;
    std::string name;
};

struct LineChart {
    std::string title{}, subtitle{}, x_title{}, y_title{};  ///< axis titles with units
    AxisScale x_scale = AxisScale::Logarithmic, y_scale = AxisScale::Logarithmic;
    std::vector<ChartSeries> series{};
    std::optional<ChartLevel> floor{};
    std::string failed_name = "failed";  ///< what a cross means, for the legend
};

/// One bar per category; values[s][c] of series s are stacked in order.
struct BarChart {
    std::string title{}, subtitle{}, x_title{}, y_title{};
    std::vector<std::string> categories{}, series{};
    std::vector<std::vector<double>> values{};
};

/// The part of the page [px] in which every point of every chart lies.
struct PlotArea {
    double left = 92, top = 74, right = 640, bottom = 484;
};
inline constexpr double kChartWidth = 900, kChartHeight = 560;  // [px]

/// The chart as a document of 900×560 px.
[[nodiscard]] std::string chart_svg(const LineChart& chart);
[[nodiscard]] std::string chart_svg(const BarChart& chart);

}  // namespace ember
