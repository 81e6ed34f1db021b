// The problem "cosine heat": one mode of heat decays in an insulated sheet; the solution is known.
#pragma once

#include "app/bench/work_problem.h"

namespace ember {

/// Runs every heat solver with ticks of many lengths, one problem per lattice. The error is the
/// L2 distance to the exact solution at 2 s relative to the mode; the floor is what the lattice
/// itself makes wrong.
[[nodiscard]] std::vector<WorkProblem> measure_cosine(const BenchOptions& options);

}  // namespace ember
