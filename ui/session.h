// A world that a person runs: play, pause, go back, edit, fork. No GL, no ImGui, no clock, no
// thread.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/world.h"
#include "ui/snapshot.h"

namespace ember {

/// What became of edited parameters.
enum class EditOutcome { Unchanged, Live, Restarted, Refused };

class Session {
  public:
    static constexpr std::size_t kCacheBytes = std::size_t{512} << 20;

    /// Starts paused at t = 0. Throws std::invalid_argument when `params` cannot be built.
    Session(const Params& params, int threads, std::size_t cache_bytes = kCacheBytes);
    /// Goes on with a world that exists already; restarts build it anew from its parameters.
    Session(World world, int threads, std::size_t cache_bytes = kCacheBytes);

    [[nodiscard]] const Params& params() const { return world_.params(); }
    [[nodiscard]] std::uint64_t tick_number() const { return world_.state().tick; }
    [[nodiscard]] std::uint64_t hash() const { return world_.hash(); }
    [[nodiscard]] bool playing() const { return playing_; }
    /// Does nothing while a failed tick has not been answered by an edit, a restart or a retry.
    void play();
    void pause() { playing_ = false; }
    void toggle() { playing_ ? pause() : play(); }
    /// One tick, and then a pause.
    void step_once();
    /// Another burn from t = 0 with the present parameters and seed; keeps playing if it was.
    void restart();

    /// Goes to a tick of the burn so far, by a kept state and at most interval - 1 ticks more. What
    /// comes later stays until something is edited here: then the burn forks.
    void go_to(std::uint64_t tick);
    /// Simulated time per time; > 0.
    void set_speed(double speed) { speed_ = speed; }
    /// Whether playing begins again at t = 0 when it reaches the end of the burn so far.
    void set_loop(bool loop) { loop_ = loop; }

    /// Lets `seconds` of a person's time pass; returns how many ticks were simulated. Ticks are
    /// always whole. Where more than kMostTicks are due, or `may_continue` says after one of them
    /// that there is no time for another, the rest is dropped and counted: a slow machine slows
    /// the burn instead of coarsening it.
    int advance(double seconds, const std::function<bool()>& may_continue = {});
    static constexpr int kMostTicks = 12;

    /// Time until a tick is due [s]; 0 when one is.
    [[nodiscard]] double until_next_tick() const;

    /// Takes over edited parameters at the present tick: live ones act at once, the others restart
    /// the scene with the same seed. What comes later in the burn so far is dropped. What is out
    /// of range or cannot be built leaves everything as it was, and message() says why.
    EditOutcome apply(const Params& params);
    /// Edits that are to come by themselves, as those of a take that is opened. Throws
    /// std::invalid_argument when one of them needs a rebuild.
    void follow_script(std::vector<TimedParams> script);
    /// After a stop: half the step, as an edit, and on. Returns false where nothing has stopped.
    bool retry_with_smaller_step();

    /// The edits that have led here, from base() on, which was in force at t = 0.
    [[nodiscard]] const std::vector<TimedParams>& script() const { return *script_; }
    [[nodiscard]] const Params& base() const { return base_; }

    /// Why the session has stopped or refused something; empty when all is well.
    [[nodiscard]] const std::string& message() const { return message_; }
    [[nodiscard]] SessionStats stats() const;
    [[nodiscard]] TimelineSpan timeline() const;
    /// Changes whenever the world may look different.
    [[nodiscard]] std::uint64_t revision() const { return revision_; }
    /// Everything that others may see of the session.
    [[nodiscard]] std::shared_ptr<Snapshot> snapshot(bool with_springs) const;
    /// Is told of the stages of every tick; may be null.
    void observe(StageObserver* observer) { observer_ = observer; }

  private:
    static std::shared_ptr<const std::vector<TimedParams>> no_edits();
    bool tick();
    void arrive(SharedState state);
    void rebuild(const Params& params);
    EditOutcome start_anew(const Params& params);
    bool edit_here(const Params& params);

    World world_;
    int threads_;
    Params base_;
    std::shared_ptr<const std::vector<TimedParams>> script_ = no_edits();
    StateCache cache_;
    SharedState arrived_;  // the present tick before what the script says for it
    std::uint64_t end_ = 0;
    bool playing_ = false, stopped_ = false, loop_ = false;
    double speed_ = 1, due_ = 0, dropped_ = 0;  // [s]
    std::int64_t substeps_ = 0;
    std::uint64_t revision_ = 1;
    std::string message_;
    StageObserver* observer_ = nullptr;
};

}  // namespace ember
