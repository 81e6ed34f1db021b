// Floating-point exceptions of a run: invalid operations, divisions by zero, overflows. Each is
// noted where it happens, and the run goes on.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/step_stats.h"

namespace ember {

/// One exception: its stage, and the instruction's offset in the program (for addr2line).
struct FloatTrap {
    Stage stage;
    std::uintptr_t offset;
};

/// Observes the stages of a world that runs on the calling thread. The first exception of every
/// stage of every tick is noted; after it that stage goes on unobserved.
class FloatTraps final : public StageObserver {
  public:
    FloatTraps();
    ~FloatTraps() override;
    FloatTraps(const FloatTraps&) = delete;
    FloatTraps& operator=(const FloatTraps&) = delete;

    /// Whether this platform can watch (x86-64 Linux); elsewhere nothing is ever noted.
    [[nodiscard]] static bool available();

    void begin(Stage stage) override;
    void end(Stage stage) override;
    /// Exceptions since the last call, without repetitions.
    [[nodiscard]] std::vector<FloatTrap> take() { return std::exchange(found_, {}); }

  private:
    std::vector<FloatTrap> found_;
};

}  // namespace ember
