// What one tick did and cost, and whether it succeeded.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "sim/params.h"
#include "sim/types.h"

namespace ember {

/// The stages of a tick, in order.
enum class Stage : std::uint8_t {
    Fire,
    Coupling,
    Springs,
    Ground,
    Heat,
    Burning,
    Shrinkage,
    Fracture,
    Check
};
inline constexpr std::size_t kStageCount = 9;
inline constexpr std::array<std::string_view, kStageCount> kStageNames = {
    "fire", "coupling", "springs", "ground", "heat", "burning", "shrinkage", "fracture", "check"};

/// Told when stages begin and end; the simulation itself never looks at a clock.
class StageObserver {
  public:
    virtual ~StageObserver() = default;
    virtual void begin(Stage stage) = 0;
    virtual void end(Stage stage) = 0;
};

/// Work done in one tick; a stage with nothing to do counts zero.
struct StepCounters {
    std::int64_t particles_born = 0, particles_moved = 0;
    std::int64_t coupling_pairs = 0;  ///< node-particle distances looked at
    std::int64_t substeps = 0, right_hand_sides = 0, spring_evaluations = 0;
    std::int64_t heat_substeps = 0, heat_nodes = 0;
    std::int64_t heat_guarded = 0;  ///< steps of RKL2 or ADI that overshot and were done again
    std::int64_t nodes_ignited = 0, nodes_burning = 0, nodes_burnt_out = 0;
    std::int64_t springs_shrunk = 0;
    std::int64_t cuts = 0, nodes_added = 0, ground_contacts = 0;
};

enum class StepStatus : std::uint8_t { Ok, Diverged };

/// Outcome of one tick.
struct StepReport {
    StepStatus status = StepStatus::Ok;
    int retries = 0;                    ///< times the tick was rolled back and halved
    Stage stage = Stage::Check;         ///< where the numbers went wrong (when Diverged)
    Index sheet = kNone, node = kNone;  ///< the first bad node, if one is to blame
    double time = 0;                    ///< [s] at the start of the failed tick
    std::string reason;
    HeatSolverKind heat_solver = HeatSolverKind::Auto;  ///< used last; Auto: all was cold
    StepCounters counters;

    [[nodiscard]] bool ok() const { return status == StepStatus::Ok; }
};

}  // namespace ember
