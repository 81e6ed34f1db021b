// The world: everything that exists, how to make it, and how to advance it by one tick.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/scene.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"
#include "sim/world_view.h"

namespace ember {

struct Workspace;  // scratch arrays; contents mean nothing between steps
class ThreadPool;

/// Parameters that come into force at the start of a tick.
struct TimedParams {
    std::uint64_t tick = 0;
    Params params;
};

/// A scene, its parameters and its state. Copyable through snapshot() only.
class World {
  public:
    /// Builds the scene at t = 0. Throws SceneError naming the key when `params` ask for what
    /// cannot be built. `threads` changes speed, never results.
    World(Scene scene, const Params& params, int threads = 1);
    World(World&&) noexcept;
    World& operator=(World&&) noexcept;
    ~World();

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const Params& params() const { return params_; }
    [[nodiscard]] const WorldState& state() const { return state_; }
    [[nodiscard]] double tick_duration() const { return 1.0 / params_.numerics.tick_rate; }  // [s]

    /// Advances by one tick. On failure the world is as before the call and the report says why.
    [[nodiscard]] StepReport step(StageObserver* observer = nullptr);

    /// Takes over live parameters; returns false and changes nothing when one of the changed
    /// parameters needs a rebuild. Paper of another grammage has its masses and spring constants
    /// in proportion, and goes on from where it is. Throws SceneError, and changes nothing, when
    /// thicker sheets would overlap.
    [[nodiscard]] bool apply(const Params& params);

    /// What apply() is to take over at ticks to come, ascending by tick, from `base` on, which is
    /// in force before the first: a burn that a person has steered, step by step. Throws
    /// std::invalid_argument when a change needs a rebuild.
    void set_script(const Params& base, std::vector<TimedParams> script);
    /// Takes over what the script says for the present tick, if that has not been done; step()
    /// does.
    void take_scripted();

    /// In-memory copy of the whole state, and back. With a script, the parameters are then those in
    /// force before that tick, and what the script says for it is still to come.
    [[nodiscard]] WorldState snapshot() const { return state_; }
    void restore(WorldState state);

    /// 64-bit hash over every array of the state.
    [[nodiscard]] std::uint64_t hash() const;

    [[nodiscard]] WorldView view() const { return view(state_); }
    /// The same of another state of this world, which must outlive the view.
    [[nodiscard]] WorldView view(const WorldState& state) const;
    /// The lighters as they are at `time` [s].
    [[nodiscard]] std::vector<LighterView> lighters_at(double time) const;
    /// The springs of one sheet as they are now.
    [[nodiscard]] std::vector<SpringSegment> springs(std::size_t sheet) const;

  private:
    void build_lattices();
    void take_material(const Params& params);
    void put_back(WorldState state);
    Scene scene_;
    Params params_;
    Params base_;  // before the script
    std::vector<TimedParams> script_;
    std::size_t taken_ = 0;  // entries of the script
    WorldState state_;
    std::unique_ptr<Workspace> work_;
    std::unique_ptr<ThreadPool> pool_;
};

/// World of `params` alone: the scene that they describe.
[[nodiscard]] World make_world(const Params& params, int threads = 1);

}  // namespace ember
