// What the benches share: loading presets, running independent jobs, time, statistics, tables.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/world.h"

namespace ember {

/// What every bench is told.
struct BenchOptions {
    std::filesystem::path out = "out/bench";  ///< folder of the results
    bool quick = false;                       ///< fewer and smaller runs
    int threads = 1;
};

/// The parameters of a preset with "key=value" texts applied. Throws InputError.
[[nodiscard]] Params bench_params(const std::string& preset,
                                  const std::vector<std::string>& sets = {});

/// Applies "key=value" texts to `params`. Throws InputError.
void set_params(Params& params, const std::vector<std::string>& sets);

/// Calls job(0) ... job(count - 1) on `threads` threads, each job on one. The first exception that
/// a job throws is thrown again when all have ended.
void run_jobs(std::size_t count, int threads, const std::function<void(std::size_t)>& job);

/// Processor time of the calling thread [s], which other programs do not lengthen.
[[nodiscard]] double thread_seconds();
/// Wall time [s] since some fixed moment.
[[nodiscard]] double wall_seconds();

/// Of values that must not be empty; NaN when one of them is.
[[nodiscard]] double median(std::vector<double> values);
[[nodiscard]] double mean(std::span<const double> values);
/// Root of the mean square.
[[nodiscard]] double root_mean_square(std::span<const double> values);
/// Sample standard deviation (n - 1); 0 for one value.
[[nodiscard]] double deviation(std::span<const double> values);

/// Processor, number of threads, compiler and version of the program, on one line.
[[nodiscard]] std::string machine_text();

/// "%.3g" and the like, without the type warnings of printf.
[[nodiscard]] std::string short_text(double value, int digits = 3);

/// Rows of text as CSV (RFC 4180).
class CsvTable {
  public:
    explicit CsvTable(const std::vector<std::string>& columns) { add(columns); }
    void add(const std::vector<std::string>& cells);
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    std::string text_;
};

}  // namespace ember
