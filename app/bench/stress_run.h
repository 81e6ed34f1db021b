// Runs one stress case and judges it.
#pragma once

#include <string>
#include <vector>

#include "app/bench/float_traps.h"
#include "app/bench/stress_case.h"

namespace ember {

enum class StressEnd { Ran, Stopped, Refused, Failed };
[[nodiscard]] std::string_view stress_end_name(StressEnd end);

struct StressOutcome {
    StressEnd end = StressEnd::Ran;
    std::string detail;  ///< why it stopped, was refused or failed
    int ticks = 0;       ///< that succeeded
    int retries = 0;
    /// Floating-point exceptions in ticks that succeeded at once; those of ticks that were rolled
    /// back are what rolling back is for, and only counted.
    std::vector<FloatTrap> traps{};
    int excused_traps = 0;
};

/// Runs `stress` on the calling thread; stops early once it has cost enough, which depends on
/// counted work alone. `traps` also watches for floating-point exceptions.
[[nodiscard]] StressOutcome run_stress(const StressCase& stress, bool traps);

}  // namespace ember
