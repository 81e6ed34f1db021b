#include "app/bench/chart.h"

#include <algorithm>

#include "app/bench/svg.h"

namespace ember {
namespace {

constexpr PlotArea kArea;
constexpr std::string_view kFrame = "#444444", kGrid = "#DDDDDD", kFine = "#F1F1F1",
                           kFailed = "#444444", kFloor = "#888888";

PagePoint place(double share_x, double share_y) {
    return {kArea.left + share_x * (kArea.right - kArea.left),
            kArea.bottom - share_y * (kArea.bottom - kArea.top)};
}

void draw_titles(SvgPage& page, const std::string& title, const std::string& subtitle,
                 const std::string& x_title, const std::string& y_title) {
    page.text({kArea.left, 32}, title, {.size = 19, .bold = true});
    page.text({kArea.left, 55}, subtitle, {.size = 13.5, .colour = "#555555"});
    page.text({(kArea.left + kArea.right) / 2, kArea.bottom + 52}, x_title,
              {.size = 15, .anchor = TextAnchor::Middle});
    page.text({26, (kArea.top + kArea.bottom) / 2}, y_title,
              {.size = 15, .anchor = TextAnchor::Middle, .turn = -90});
}

void draw_frame(SvgPage& page) {
    page.line(place(0, 0), place(1, 0), kFrame, 1.5);
    page.line(place(0, 0), place(0, 1), kFrame, 1.5);
}

void draw_x_ticks(SvgPage& page, const ChartAxis& axis) {
    for (const AxisTick& tick : axis.ticks()) {
        const double at = axis.share(tick.value);
        page.line(place(at, 0), place(at, 1), tick.label.empty() ? kFine : kGrid, 1);
        PagePoint below = place(at, 0);
        below.y += 22;
        page.text(below, tick.label, {.size = 14, .anchor = TextAnchor::Middle});
    }
}

void draw_y_ticks(SvgPage& page, const ChartAxis& axis) {
    for (const AxisTick& tick : axis.ticks()) {
        const double at = axis.share(tick.value);
        page.line(place(0, at), place(1, at), tick.label.empty() ? kFine : kGrid, 1);
        PagePoint left = place(0, at);
        left.x -= 9;
        left.y += 5;
        page.text(left, tick.label, {.size = 14, .anchor = TextAnchor::End});
    }
}

// The column at the right: one entry below the other.
class Legend {
  public:
    explicit Legend(SvgPage& page) : page_(page) {}

    /// Where the next entry's sample goes; writes its name beside it.
    PagePoint next(const std::string& name) {
        const PagePoint at{kArea.right + 32, kArea.top + 12 + 24.0 * static_cast<double>(count_++)};
        page_.text({at.x + 22, at.y + 5}, name, {.size = 13.5});
        return at;
    }

  private:
    SvgPage& page_;
    int count_ = 0;
};

void draw_floor(SvgPage& page, const ChartAxis& y, const ChartLevel& level, Legend& legend) {
    if (!y.covers(level.y)) return;
    const double at = y.share(level.y);
    const PagePoint corner = place(0, at);
    page.rectangle(corner, kArea.right - kArea.left, kArea.bottom - corner.y, kFloor, 0.13);
    page.line(corner, place(1, at), kFloor, 2, "7 5");
    const PagePoint sample = legend.next(level.name);
    page.line({sample.x - 16, sample.y}, {sample.x + 16, sample.y}, kFloor, 2, "7 5");
}

// Lines are broken where a point failed.
void draw_series(SvgPage& page, const ChartAxis& x, const ChartAxis& y, const ChartSeries& series,
                 std::size_t number) {
    std::vector<PagePoint> run;
    const auto end_run = [&] {
        if (series.joined && run.size() > 1) page.polyline(run, series_colour(number), 2);
        for (const PagePoint& p : run)
            draw_marker(page, number, p, 5);
        run.clear();
    };
    for (const ChartPoint& p : series.points) {
        const bool shown = !p.failed && x.covers(p.x) && y.covers(p.y);
        if (shown) {
            run.push_back(place(x.share(p.x), y.share(p.y)));
        } else {
            end_run();
            if (!x.covers(p.x)) continue;
            PagePoint border = place(x.share(p.x), 1);
            border.y += 8;
            draw_cross(page, border, 5, series_colour(number));
        }
    }
    end_run();
}

bool is_failed(const ChartPoint& point) {
    return point.failed;
}

}  // namespace

std::string chart_svg(const LineChart& chart) {
    std::vector<double> xs, ys;
    bool any_failed = false;
    for (const ChartSeries& series : chart.series) {
        for (const ChartPoint& p : series.points) {
            xs.push_back(p.x);
            if (!p.failed) ys.push_back(p.y);
        }
        any_failed |= std::any_of(series.points.begin(), series.points.end(), is_failed);
    }
    if (chart.floor) ys.push_back(chart.floor->y);
    const ChartAxis x(chart.x_scale, xs), y(chart.y_scale, ys);
    SvgPage page(kChartWidth, kChartHeight);
    Legend legend(page);
    draw_titles(page, chart.title, chart.subtitle, chart.x_title, chart.y_title);
    draw_x_ticks(page, x);
    draw_y_ticks(page, y);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const PagePoint at = legend.next(chart.series[i].name);
        if (chart.series[i].joined) {
            page.line({at.x - 16, at.y}, {at.x + 16, at.y}, series_colour(i), 2);
        }
        draw_marker(page, i, at, 5);
    }
    if (chart.floor) draw_floor(page, y, *chart.floor, legend);
    draw_frame(page);
    for (std::size_t i = 0; i < chart.series.size(); ++i)
        draw_series(page, x, y, chart.series[i], i);
    if (any_failed) draw_cross(page, legend.next(chart.failed_name), 5, kFailed);
    return page.svg();
}

std::string chart_svg(const BarChart& chart) {
    const std::size_t bars = chart.categories.size();
    std::vector<double> tops(bars, 0.0);
    for (const auto& row : chart.values) {
        for (std::size_t c = 0; c < bars; ++c)
            tops[c] += row[c];
    }
    const ChartAxis y(AxisScale::Linear, tops, true);
    SvgPage page(kChartWidth, kChartHeight);
    Legend legend(page);
    draw_titles(page, chart.title, chart.subtitle, chart.x_title, chart.y_title);
    draw_y_ticks(page, y);
    const double slot = 1.0 / static_cast<double>(std::max<std::size_t>(bars, 1));
    for (std::size_t c = 0; c < bars; ++c) {
        double below = 0;
        const double at = slot * static_cast<double>(c);
        for (std::size_t s = 0; s < chart.values.size(); ++s) {
            const double above = below + chart.values[s][c];
            const PagePoint corner = place(at + 0.12 * slot, y.share(above));
            page.rectangle(corner, 0.76 * slot * (kArea.right - kArea.left),
                           place(0, y.share(below)).y - corner.y, series_colour(s));
            below = above;
        }
        PagePoint label = place(at + 0.5 * slot, 0);
        label.y += 22;
        page.text(label, chart.categories[c], {.size = 13, .anchor = TextAnchor::Middle});
    }
    draw_frame(page);
    // the topmost part of the bars comes first
    for (std::size_t s = chart.series.size(); s-- > 0;) {
        const PagePoint at = legend.next(chart.series[s]);
        page.rectangle({at.x - 10, at.y - 8}, 20, 16, series_colour(s));
    }
    return page.svg();
}

}  // namespace ember
