// A world that a person runs: play, pause, step, restart, edit. No GL, no ImGui, no clock.
#pragma once

#include <string>

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
    double dropped = 0;  ///< [s] simulated time that was due and not simulated
};

class Session {
  public:
    /// Starts paused at t = 0. Throws std::invalid_argument when `params` cannot be built.
    Session(const Params& params, int threads);

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const Params& params() const { return world_.params(); }
    [[nodiscard]] bool playing() const { return playing_; }
    void play();
    void pause() { playing_ = false; }
    void toggle() { playing_ ? pause() : play(); }
    /// One tick, and then a pause.
    void step_once();
    /// Back to t = 0 with the same parameters and seed; keeps playing if it was.
    void restart();

    /// Lets `seconds` of a person's time pass. Simulates whole ticks; when more than kMostTicks are
    /// due the rest of the time is dropped, and counted, so that a slow machine slows the burn
    /// instead of coarsening it.
    void advance(double seconds);
    static constexpr int kMostTicks = 4;

    /// Takes over edited parameters: live ones act at once, the others restart the scene. What
    /// cannot be built leaves everything as it was, and says so in message().
    void apply(const Params& params);

    /// Why the session has stopped or refused something; empty when all is well.
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] SessionStats stats() const;

  private:
    bool tick();
    World world_;
    int threads_;
    bool playing_ = false, stopped_ = false;
    double due_ = 0, dropped_ = 0;  // [s]
    std::int64_t substeps_ = 0;
    std::string message_;
};

}  // namespace ember
