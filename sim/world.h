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
    /// parameters needs a rebuild.
    [[nodiscard]] bool apply(const Params& params);

    /// In-memory copy of the whole state, and back.
    [[nodiscard]] WorldState snapshot() const { return state_; }
    void restore(WorldState state);

    /// 64-bit hash over every array of the state.
    [[nodiscard]] std::uint64_t hash() const;

    [[nodiscard]] WorldView view() const;
    /// The lighters as they are at `time` [s].
    [[nodiscard]] std::vector<LighterView> lighters_at(double time) const;
    /// The springs of one sheet as they are now.
    [[nodiscard]] std::vector<SpringSegment> springs(std::size_t sheet) const;

  private:
    Scene scene_;
    Params params_;
    WorldState state_;
    std::unique_ptr<Workspace> work_;
    std::unique_ptr<ThreadPool> pool_;
};

/// World of `params` alone: the scene that they describe.
[[nodiscard]] World make_world(const Params& params, int threads = 1);

}  // namespace ember
