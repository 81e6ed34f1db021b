// One case of the stress bench: parameters, what is done to the world, and what must come of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/world.h"

namespace ember {

enum class StressDemand {
    RunsOrStops,  ///< every tick is right, or the run stops with a reason and the world as it was
    Stops,        ///< the first tick must be refused
    RollsBack     ///< a tick that is rolled back must equal a clean one with half the sub-step
};

struct StressCase {
    std::string name;
    std::vector<std::string> sets;  ///< "key=value", applied to paper/corner
    int ticks = 24;
    StressDemand demand = StressDemand::RunsOrStops;
    std::function<void(World&)> prepare{};           ///< changes the state before the first tick
    std::function<void(World&, int tick)> during{};  ///< changes parameters before each tick
};

/// `count` cases that fill the space of parameters evenly (a Latin hypercube).
[[nodiscard]] std::vector<StressCase> random_cases(std::size_t count, std::uint64_t seed);

/// Corners of that space, made by hand.
[[nodiscard]] std::vector<StressCase> corner_cases();

/// Worlds into which one impossible number was put.
[[nodiscard]] std::vector<StressCase> fault_cases(std::size_t count, std::uint64_t seed);

/// Worlds whose sub-steps are too long at first, one per integrator that has a bound.
[[nodiscard]] std::vector<StressCase> rollback_cases();

/// The parameters of a case. Throws InputError.
[[nodiscard]] Params stress_params(const StressCase& stress);

/// The command line that simulates the parameters of a case.
[[nodiscard]] std::string reproduction(const StressCase& stress);

}  // namespace ember
