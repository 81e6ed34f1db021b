// The two comparisons that the program prints.
#pragma once

#include <cstdio>

namespace ember::peers {

/// One right-hand side alone, ns per node. `csv` may be null, here and below.
void compare_right_hand_sides(int repeats, std::FILE* csv);

/// The swing problem to its end by every method, and the times at equal errors.
void compare_solvers(int repeats, std::FILE* csv);

}  // namespace ember::peers
