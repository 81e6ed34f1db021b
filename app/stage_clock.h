// How long each stage of the simulation takes. The clock lives here, outside the simulation.
#pragma once

#include <array>
#include <chrono>

#include "sim/step_stats.h"

namespace ember {

class StageClock final : public StageObserver {
  public:
    void begin(Stage stage) override;
    void end(Stage stage) override;
    /// Milliseconds of each stage since the last reset.
    [[nodiscard]] const std::array<double, kStageCount>& milliseconds() const { return ms_; }
    void reset() { ms_.fill(0); }

  private:
    std::chrono::steady_clock::time_point start_;
    std::array<double, kStageCount> ms_{};
};

}  // namespace ember
