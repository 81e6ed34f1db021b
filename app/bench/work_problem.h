// A problem on which ways of solving are compared: what each run cost and how far off it was.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/bench_run.h"

namespace ember {

/// One way of solving: a choice and how finely it steps.
struct WorkSetting {
    std::string method;             ///< "rk4"
    std::string label;              ///< "64 sub-steps", "tolerance 1e-6"
    std::vector<std::string> sets;  ///< "key=value" that ask for it
    std::string group{};            ///< only runs of one group are alternatives to each other
};

/// What one way of solving cost and yielded.
struct WorkPoint {
    WorkSetting setting;
    double seconds = 0;            ///< processor time of the part under test
    std::int64_t work = 0;         ///< right-hand sides, or heat sub-steps
    std::vector<double> errors{};  ///< one per WorkProblem::error_titles; NaN when it failed
    bool failed = false;
    std::vector<std::string> presets{};  ///< shipped presets that have this as their default
};

/// A measured problem.
struct WorkProblem {
    std::string name;  ///< stem of its files, e.g. "swing"
    std::string title, subtitle;
    std::string work_title;                 ///< what WorkPoint::work counts
    std::vector<std::string> error_titles;  ///< with units; the first one ranks
    double floor = 0;                       ///< of the first error: below it runs are alike
    std::string floor_name;                 ///< empty: none
    std::string reference;                  ///< what errors are against, and how sure that is
    std::vector<WorkPoint> points;          ///< the sweep
    std::vector<WorkPoint> defaults;        ///< settings of the shipped presets
};

/// The choices of a parameter in the order of the table, without "auto".
[[nodiscard]] std::vector<std::string> choices_of(const std::string& key);

/// Points of the sweep that no other beats in both time and first error, cheapest first. Errors
/// below the floor count as equal to it.
[[nodiscard]] std::vector<WorkPoint> efficient_frontier(const WorkProblem& problem);

/// The cheapest point of the sweep that is at least as accurate as `wanted` (or the floor), among
/// those of its group.
[[nodiscard]] std::optional<WorkPoint> cheapest_like(const WorkProblem& problem,
                                                     const WorkPoint& wanted);

/// Writes NAME.csv and NAME.svg (first error against time), and NAME_work.svg (against work).
void write_problem(const WorkProblem& problem, const std::filesystem::path& folder);

/// The chart of the first error against time.
[[nodiscard]] std::string problem_chart(const WorkProblem& problem, bool against_work = false);

}  // namespace ember
