// One burn, boiled down to the few numbers that can be compared between burns.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/params.h"

namespace ember {

/// What is compared: trajectories of burns are chaotic, these numbers are less so.
inline constexpr std::array<std::string_view, 5> kBurnMeasures = {
    "t10 [s]", "t50 [s]", "t90 [s]", "burnt share at the end [1]", "mean shrink [1]"};

struct BurnRun {
    /// Times when 10, 50 and 90 % of the nodes were burnt out (NaN if never), the share burnt out
    /// at the end, mean of rest length / initial length over all springs.
    std::array<double, kBurnMeasures.size()> measures{};
    double seconds = 0;  ///< processor time of stepping
    std::int64_t right_hand_sides = 0, cuts = 0;
    bool failed = false;
};

/// Burns what `params` describe for `duration` [s] on the calling thread.
[[nodiscard]] BurnRun run_burn(const Params& params, double duration);

}  // namespace ember
