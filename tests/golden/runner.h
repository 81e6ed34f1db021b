// Draws scenes one after the other and judges them, or approves what they look like now.
#pragma once

#include <functional>

#include "app/difference_report.h"
#include "golden/stage.h"

namespace ember::golden {

struct RunnerOptions {
    std::filesystem::path presets;   ///< folder of "paper/corner.toml"
    std::filesystem::path approved;  ///< folder of goldens
    std::filesystem::path report;    ///< HTML file that failures are written to
    Rasteriser rasteriser = Rasteriser::Pinned;
};

class Runner {
  public:
    explicit Runner(RunnerOptions options)
        : options_(std::move(options)), approved_(options_.approved) {}

    /// Draws and judges; what is not good goes into the report, which is written at once.
    [[nodiscard]] Verdict check(const Scene& scene);
    /// Draws, and approves what is not exactly what was approved already. Returns whether anything
    /// was written.
    bool update(const Scene& scene, const std::string& reason, const std::string& commit);

    [[nodiscard]] const RunnerOptions& options() const { return options_; }

  private:
    struct Seen;
    [[nodiscard]] Seen look_at(const Scene& scene);
    void report(const Scene& scene, const Seen& seen);
    RunnerOptions options_;
    ApprovedFolder approved_;
    std::string suite_;  // whose stage it is
    std::unique_ptr<Stage> stage_;
    std::vector<ReportEntry> failures_;
};

/// The commit that `repository` is at. Throws std::runtime_error.
[[nodiscard]] std::string present_commit(const std::filesystem::path& repository);

/// Why goldens must not be updated now; empty when they may. They may not in continuous
/// integration (`ci`, the variable CI, is set and not "false"), without a reason, and where
/// `repository` holds changes that are not committed, other than below `approved`.
[[nodiscard]] std::string update_refusal(const std::filesystem::path& repository,
                                         const std::filesystem::path& approved, const char* ci,
                                         const std::string& reason);

}  // namespace ember::golden
