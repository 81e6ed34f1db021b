// The cases of a sweep: every combination of the values of several parameters.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ember {

/// One parameter and what it is set to, as --set would have it.
struct SweepAxis {
    std::string key;
    std::vector<std::string> values;
};

/// "KEY=60,80,120", "KEY=1..5:9" (nine values, equally far apart, both ends among them) or
/// "KEY=1e-4..1e-2:log:5" (equal ratios). Throws InputError.
[[nodiscard]] SweepAxis parse_axis(const std::string& text);

/// One combination: key and value of every axis, in the order of the axes.
using SweepCase = std::vector<std::pair<std::string, std::string>>;

/// All combinations; the last axis changes fastest. Throws InputError when there are too many or a
/// key is varied twice.
[[nodiscard]] std::vector<SweepCase> sweep_cases(const std::vector<SweepAxis>& axes);

/// A share of the work: "2/8" is the second of eight.
struct SweepShare {
    long number = 1, of = 1;
    [[nodiscard]] bool has(long index) const { return index % of == number - 1; }
};
/// Throws InputError.
[[nodiscard]] SweepShare parse_share(const std::string& text);

}  // namespace ember
