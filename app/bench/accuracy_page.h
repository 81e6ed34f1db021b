// docs/ACCURACY.md: what the work-precision bench found, as a page for people.
#pragma once

#include <string>
#include <vector>

#include "app/bench/work_problem.h"

namespace ember {

/// How much slower than the cheapest run at its error a shipped default may be.
inline constexpr double kMostWaste = 1.5;

/// The page in Markdown. Charts are referred to as accuracy_NAME.svg beside it.
[[nodiscard]] std::string accuracy_page(const std::vector<WorkProblem>& problems, bool quick);

/// One sentence for every shipped default that wastes more than kMostWaste, or fails.
[[nodiscard]] std::vector<std::string> wasteful_defaults(const WorkProblem& problem);

}  // namespace ember
