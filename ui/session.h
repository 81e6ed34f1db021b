// A world that a person runs: play, pause, step, restart, edit. No GL, no ImGui, no clock.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/world.h"

namespace ember {

/// What panels show of the world: values, never pointers.
struct SessionStats {
    double time = 0;  ///< [s]
    std::uint64_t tick = 0;
    std::int64_t unburnt = 0, burning = 0, burnt_out = 0;  ///< lattice sites
    std::size_t particles = 0;
    std::int64_t cuts = 0, substeps = 0, retries = 0;
    double hottest = 0;  ///< [K]
    double caliper = 0;  ///< [m]
    double mass = 0;     ///< [kg] of all sheets
    double dropped = 0;  ///< [s] simulated time that was due and not simulated
    bool lighter_lit = false;
};

/// What became of edited parameters.
enum class EditOutcome { Unchanged, Live, Restarted, Refused };

class Session {
  public:
    /// Starts paused at t = 0. Throws std::invalid_argument when `params` cannot be built.
    Session(const Params& params, int threads);
    /// Goes on with a world that exists already; restarts build it anew from its parameters.
    Session(World world, int threads);

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const Params& params() const { return world_.params(); }
    [[nodiscard]] bool playing() const { return playing_; }
    /// Does nothing while a failed tick has not been answered by an edit or a restart.
    void play();
    void pause() { playing_ = false; }
    void toggle() { playing_ ? pause() : play(); }
    /// One tick, and then a pause.
    void step_once();
    /// Back to t = 0 with the same parameters and seed; keeps playing if it was.
    void restart();

    /// Lets `seconds` of a person's time pass; returns how many ticks were simulated. Ticks are
    /// always whole. Where more than kMostTicks are due, or `may_continue` says after one of them
    /// that there is no time for another, the rest is dropped and counted: a slow machine slows
    /// the burn instead of coarsening it.
    int advance(double seconds, const std::function<bool()>& may_continue = {});
    static constexpr int kMostTicks = 12;

    /// Time until a tick is due [s]; 0 when one is.
    [[nodiscard]] double until_next_tick() const;

    /// Takes over edited parameters: live ones act at once, the others restart the scene with the
    /// same seed. What is out of range or cannot be built leaves everything as it was, and
    /// message() says why.
    EditOutcome apply(const Params& params);

    /// Why the session has stopped or refused something; empty when all is well.
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] SessionStats stats() const;
    /// Changes whenever the world may look different.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }

  private:
    bool tick();
    void rebuild(const Params& params);
    World world_;
    int threads_;
    bool playing_ = false, stopped_ = false;
    double due_ = 0, dropped_ = 0;  // [s]
    std::int64_t substeps_ = 0;
    std::uint64_t revision_ = 1;
    std::string message_;
};

}  // namespace ember
