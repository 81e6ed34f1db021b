// The problem "swing": a soft sheet falls from the horizontal, smoothly, without fire.
#pragma once

#include "app/bench/work_problem.h"

namespace ember {

/// Runs every integrator with every step, or tolerance where it chooses its own step. The error is
/// the RMS node distance [m] to a reference at t = 0.25 and 0.5 s.
[[nodiscard]] WorkProblem measure_swing(const BenchOptions& options);

}  // namespace ember
