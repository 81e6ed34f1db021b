// What a run did, tick by tick, as JSON.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/run_options.h"
#include "app/stage_clock.h"
#include "sim/world.h"

namespace ember {

/// Number of nodes in each phase.
struct PhaseCounts {
    std::int64_t unburnt = 0, burning = 0, burnt_out = 0;
    [[nodiscard]] std::int64_t total() const { return unburnt + burning + burnt_out; }
};
[[nodiscard]] PhaseCounts count_phases(const WorldState& state);

/// One tick, in the units of the file.
struct TickStats {
    std::uint64_t tick = 0;
    double time = 0;  // [s]
    PhaseCounts nodes;
    double mass = 0;                                     // [kg]
    double coldest = 0, hottest = 0;                     // [degC]
    double kinetic = 0, elastic = 0, gravitational = 0;  // [J]
    std::int64_t particles = 0, emitters = 0, cuts = 0;  // cuts since t = 0
    int retries = 0;
    StepCounters work;
    IntegratorKind integrator = IntegratorKind::Auto;
    HeatSolverKind heat_solver = HeatSolverKind::Auto;
    std::array<double, kStageCount> ms{};
};

/// Collects a TickStats per tick.
class StatsRecorder {
  public:
    [[nodiscard]] StageObserver* observer() { return &clock_; }
    /// To be called after every step of `world`.
    void record(const World& world, const StepReport& report);

    [[nodiscard]] const std::vector<TickStats>& ticks() const { return ticks_; }
    /// Mean milliseconds per tick of each stage.
    [[nodiscard]] std::array<double, kStageCount> mean_ms() const;
    /// First time [s] at which at least `share` of the nodes were burnt out, or NaN.
    [[nodiscard]] double burnt_out_time(double share) const;

    /// The whole document: program, preset, one object per frame, totals.
    [[nodiscard]] std::string json(const World& world, const LoadedPreset& preset) const;

  private:
    StageClock clock_;
    std::vector<TickStats> ticks_;
};

/// "state hash: ", or "fast state hash: " with fast arithmetic, whose bits are others and depend on
/// the processor, and the hash.
[[nodiscard]] std::string labelled_hash(const World& world);

/// 16 hexadecimal digits.
[[nodiscard]] std::string hash_text(std::uint64_t hash);

}  // namespace ember
