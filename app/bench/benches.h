// The benches behind `emberleaf bench`. Each writes its tables and charts and returns an exit code.
#pragma once

#include <string>
#include <vector>

#include "app/bench/bench_run.h"

namespace ember {

struct WorkPrecisionOptions {
    BenchOptions common;
    std::string problem;  ///< "swing", "cosine", "burn"; empty: all
    std::string page;     ///< file of docs/ACCURACY.md; empty: none
};
/// Error against time for every integrator and heat solver.
int bench_work_precision(const WorkPrecisionOptions& options);

/// Milliseconds per tick and stage for growing lattices, threads and numbers of particles.
int bench_scaling(const BenchOptions& options);

/// Milliseconds per stage over the course of each preset.
int bench_stages(const BenchOptions& options, std::vector<std::string> presets);

struct StressOptions {
    BenchOptions common;
    int cases = 2000;
    std::int64_t seed = 1;
    std::string only;   ///< name of the one case to run; empty: all
    bool traps = true;  ///< also watch for floating-point exceptions
};
/// Parameters far outside what is usual; kRunFailed when any case ends badly.
int bench_stress(const StressOptions& options);

struct ValidateOptions {
    BenchOptions common;
    std::vector<std::string> presets;  ///< empty: all of real/
    std::vector<std::string> sets;     ///< "key=value" texts for all of them
    std::string page;                  ///< file of docs/VALIDATION.md; empty: none
};
/// Flame spread over strips of paper against what is known of it; kComparisonFailed when a
/// required line is out of range. Quick: horizontal strips only.
int bench_validate(const ValidateOptions& options);

}  // namespace ember
