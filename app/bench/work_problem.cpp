#include "app/bench/work_problem.h"

#include <algorithm>
#include <cmath>

#include "app/bench/chart.h"
#include "app/preset_io/atomic_file.h"
#include "sim/param_table.h"

namespace ember {
namespace {

const std::string kDefaults = "shipped default";

double ranked_error(const WorkProblem& problem, const WorkPoint& point) {
    return std::max(point.errors.front(), problem.floor);
}

ChartSeries& series_of(LineChart& chart, const std::string& name) {
    for (ChartSeries& series : chart.series) {
        if (series.name == name) return series;
    }
    return chart.series.emplace_back(ChartSeries{name, {}, name != kDefaults});
}

std::string problem_csv(const WorkProblem& problem) {
    std::vector<std::string> columns = {"method",  "setting",          "presets",
                                        "seconds", problem.work_title, "failed"};
    columns.insert(columns.end(), problem.error_titles.begin(), problem.error_titles.end());
    CsvTable table(columns);
    const auto add = [&](const WorkPoint& point) {
        std::string presets;
        for (const std::string& name : point.presets)
            presets += (presets.empty() ? "" : " ") + name;
        std::vector<std::string> cells = {
            point.setting.method,         point.setting.label,        presets,
            short_text(point.seconds, 6), std::to_string(point.work), point.failed ? "failed" : ""};
        for (const double error : point.errors)
            cells.push_back(short_text(error, 6));
        table.add(cells);
    };
    for (const WorkPoint& point : problem.points)
        add(point);
    for (const WorkPoint& point : problem.defaults)
        add(point);
    return table.text();
}

}  // namespace

std::vector<std::string> choices_of(const std::string& key) {
    std::vector<std::string> names;
    for (const std::string_view name : find_param(sim_param_rows(), key)->choices) {
        if (name != "auto") names.emplace_back(name);
    }
    return names;
}

std::vector<WorkPoint> efficient_frontier(const WorkProblem& problem) {
    std::vector<WorkPoint> good;
    for (const WorkPoint& point : problem.points) {
        if (!point.failed) good.push_back(point);
    }
    std::sort(good.begin(), good.end(),
              [](const WorkPoint& a, const WorkPoint& b) { return a.seconds < b.seconds; });
    std::vector<WorkPoint> frontier;
    for (const WorkPoint& point : good) {
        const double error = ranked_error(problem, point);
        if (frontier.empty() || error < ranked_error(problem, frontier.back())) {
            frontier.push_back(point);
        }
    }
    return frontier;
}

std::optional<WorkPoint> cheapest_like(const WorkProblem& problem, const WorkPoint& wanted) {
    std::optional<WorkPoint> best;
    for (const WorkPoint& point : problem.points) {
        if (point.failed || point.setting.group != wanted.setting.group) continue;
        if (ranked_error(problem, point) > ranked_error(problem, wanted)) continue;
        if (!best || point.seconds < best->seconds) best = point;
    }
    return best;
}

std::string problem_chart(const WorkProblem& problem, bool against_work) {
    LineChart chart;
    chart.title = problem.title;
    chart.subtitle = problem.subtitle;
    chart.x_title = against_work ? problem.work_title : "processor time [s]";
    chart.y_title = problem.error_titles.front();
    const auto add = [&](const std::string& name, const WorkPoint& point) {
        const double x = against_work ? static_cast<double>(point.work) : point.seconds;
        series_of(chart, name).points.push_back({x, point.errors.front(), point.failed});
    };
    for (const WorkPoint& point : problem.points)
        add(point.setting.method, point);
    for (const WorkPoint& point : problem.defaults)
        add(kDefaults, point);
    if (!problem.floor_name.empty()) chart.floor = ChartLevel{problem.floor, problem.floor_name};
    chart.failed_name = "failed or diverged";
    return chart_svg(chart);
}

void write_problem(const WorkProblem& problem, const std::filesystem::path& folder) {
    write_file(folder / (problem.name + ".csv"), problem_csv(problem));
    write_file(folder / (problem.name + ".svg"), problem_chart(problem));
    write_file(folder / (problem.name + "_work.svg"), problem_chart(problem, true));
}

}  // namespace ember
