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
    Contact,
    Springs,
    Heat,
    Burning,
    Shrinkage,
    Fracture,
    Check
};
inline constexpr std::size_t kStageCount = 9;
inline constexpr std::array<std::string_view, kStageCount> kStageNames = {
    "fire", "coupling", "contact", "springs", "heat", "burning", "shrinkage", "fracture", "check"};

/// Where an array with one element for each stage has the given one.
[[nodiscard]] constexpr std::size_t index_of(Stage stage) {
    return static_cast<std::size_t>(stage);
}

/// Told when stages begin and end; the simulation itself never looks at a clock.
class StageObserver {
  public:
    virtual ~StageObserver() = default;
    virtual void begin(Stage stage) = 0;
    virtual void end(Stage stage) = 0;
};

/// Tells the observer, if there is one, when a stage begins and ends.
class StageScope {
  public:
    StageScope(StageObserver* observer, Stage stage) : observer_(observer), stage_(stage) {
        if (observer_ != nullptr) observer_->begin(stage_);
    }
    ~StageScope() {
        if (observer_ != nullptr) observer_->end(stage_);
    }
    StageScope(const StageScope&) = delete;
    StageScope& operator=(const StageScope&) = delete;

  private:
    StageObserver* observer_;
    Stage stage_;
};

/// Work done in one tick; a stage with nothing to do counts zero.
struct StepCounters {
    std::int64_t particles_born = 0, particles_moved = 0;
    std::int64_t emitters_visited = 0;
    std::int64_t coupling_pairs = 0;  ///< node-particle distances looked at
    std::int64_t substeps = 0, substeps_rejected = 0;
    std::int64_t right_hand_sides = 0, spring_evaluations = 0;
    std::int64_t rows_asleep = 0;
    std::int64_t solver_iterations = 0;  ///< of the implicit integrator's linear systems
    std::int64_t heat_substeps = 0, heat_nodes = 0;
    std::int64_t heat_guarded = 0;  ///< steps of RKL2 or ADI that overshot and were done again
    std::int64_t nodes_ignited = 0, nodes_burning = 0, nodes_burnt_out = 0;
    std::int64_t burning_visited = 0;                          ///< nodes
    std::int64_t shrinkage_visited = 0, fracture_visited = 0;  ///< spring slots
    std::int64_t contact_visited = 0;  ///< nodes looked at beside the ground or a quad
    std::int64_t contact_pairs = 0;    ///< nodes and quads that may touch in the tick
    std::int64_t contacts = 0;         ///< solved for, in all intervals
    std::int64_t contact_sweeps = 0;
    std::int64_t springs_shrunk = 0;
    std::int64_t curl_visited = 0;  ///< sites whose faces differ, or that char
    std::int64_t cuts = 0, nodes_added = 0;
};

/// Calls visit(name, count) for every counter.
template <class Counters, class Visitor>
void for_each_counter(Counters& c, Visitor&& visit) {
    visit("particles_born", c.particles_born), visit("particles_moved", c.particles_moved);
    visit("emitters_visited", c.emitters_visited), visit("coupling_pairs", c.coupling_pairs);
    visit("substeps", c.substeps), visit("substeps_rejected", c.substeps_rejected);
    visit("right_hand_sides", c.right_hand_sides);
    visit("spring_evaluations", c.spring_evaluations);
    visit("rows_asleep", c.rows_asleep), visit("solver_iterations", c.solver_iterations);
    visit("heat_substeps", c.heat_substeps), visit("heat_nodes", c.heat_nodes);
    visit("heat_guarded", c.heat_guarded);
    visit("nodes_ignited", c.nodes_ignited), visit("nodes_burning", c.nodes_burning);
    visit("nodes_burnt_out", c.nodes_burnt_out), visit("springs_shrunk", c.springs_shrunk);
    visit("burning_visited", c.burning_visited), visit("contact_visited", c.contact_visited);
    visit("shrinkage_visited", c.shrinkage_visited);
    visit("curl_visited", c.curl_visited);
    visit("fracture_visited", c.fracture_visited);
    visit("cuts", c.cuts), visit("nodes_added", c.nodes_added);
    visit("contact_pairs", c.contact_pairs), visit("contacts", c.contacts);
    visit("contact_sweeps", c.contact_sweeps);
}

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
    IntegratorKind integrator = IntegratorKind::Auto;  ///< that moved the last sheet, if any moved

    [[nodiscard]] bool ok() const { return status == StepStatus::Ok; }
};

/// Where and why the numbers went wrong: "stage heat, sheet 0, node 7: reason".
[[nodiscard]] inline std::string cause_text(const StepReport& report) {
    std::string text = "stage ";
    text += kStageNames[static_cast<std::size_t>(report.stage)];
    if (report.sheet != kNone) text += ", sheet " + std::to_string(report.sheet);
    if (report.node != kNone) text += ", node " + std::to_string(report.node);
    return text + ": " + report.reason;
}

}  // namespace ember
