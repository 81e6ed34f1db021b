// The problem "burn": a whole burn with everything on, over several seeds.
#pragma once

#include "app/bench/work_problem.h"

namespace ember {

/// Runs every integrator with every step or tolerance for every seed. The first error is the
/// RMS difference from the reference burn with the same seed, in units of the spread between
/// seeds, over all measures (burn_run.h); the others are those of single measures.
[[nodiscard]] WorkProblem measure_burn(const BenchOptions& options);

}  // namespace ember
