// What `bench validate` asks of a grade of paper, and what it answers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bench/strip_run.h"

namespace ember {

/// A preset, burnt as a strip in one or more directions.
struct GradeRuns {
    std::string name;
    Params params;
    std::array<std::optional<StripRun>, kSpreadNames.size()> runs;  ///< by Spread; empty: not run

    [[nodiscard]] const std::optional<StripRun>& run(Spread spread) const {
        return runs[static_cast<std::size_t>(spread)];
    }
};

enum class Verdict : std::uint8_t { Pass, Fail, Reported };

/// One line of the table.
struct CheckLine {
    std::string grade, what, measured, allowed;
    Verdict verdict = Verdict::Reported;
};

/// Front speed times grammage of horizontal spread over thin paper [kg/(m s)], and for which
/// grammages it is documented [kg/m^2]: P. H. Thomas and M. Law, Fire Research Note 584 (1965).
inline constexpr double kLeastSpreadRate = 0.35e-3, kMostSpreadRate = 0.56e-3;
inline constexpr double kLeastGrammage = 0.060, kMostGrammage = 0.200;

/// Every check that the runs of `grade` allow.
[[nodiscard]] std::vector<CheckLine> check_grade(const GradeRuns& grade);

[[nodiscard]] std::string verdict_text(Verdict verdict);

/// The runs in numbers, one per line.
[[nodiscard]] std::string runs_csv(const std::vector<GradeRuns>& grades);

/// docs/VALIDATION.md.
[[nodiscard]] std::string validation_page(const std::vector<GradeRuns>& grades, double cell,
                                          bool quick);

}  // namespace ember
