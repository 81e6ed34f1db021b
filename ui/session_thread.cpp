#include "ui/session_thread.h"

#include <array>
#include <chrono>
#include <exception>
#include <utility>

namespace ember {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kMostTicking = 0.010;   // [s] before a snapshot is published
constexpr double kMostFollowing = 0.05;  // [s]
constexpr double kLongestWait = 3600;    // [s]

double since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// How long the stages of a tick take.
class StageTimes final : public StageObserver {
  public:
    void begin(Stage) override { start_ = Clock::now(); }
    void end(Stage stage) override { seconds_[index_of(stage)] += since(start_); }
    // Of each tick since the last call, on average.
    std::array<double, kStageCount> take(int ticks) {
        std::array<double, kStageCount> taken = seconds_;
        for (double& s : taken)
            s /= ticks;
        seconds_.fill(0);
        return taken;
    }

  private:
    Clock::time_point start_;
    std::array<double, kStageCount> seconds_{};
};

}  // namespace

SessionThread::SessionThread(const Params& params, int threads, std::function<void()> wake,
                             std::size_t cache_bytes)
    : session_(params, threads, cache_bytes), threads_(threads), wake_(std::move(wake)) {
    published_ = session_.snapshot(false);
    thread_ = std::thread([this] { run(); });
}

SessionThread::~SessionThread() {
    {
        const std::lock_guard lock(mutex_);
        quit_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

std::uint64_t SessionThread::post(Command command) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        commands_.push_back(std::move(command));
        number = ++posted_;
    }
    changed_.notify_all();
    return number;
}

void SessionThread::call(const Command& command) {
    const std::uint64_t mine = post(command);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return done_ >= mine; });
}

void SessionThread::want_springs(bool wanted) {
    {
        const std::lock_guard lock(mutex_);
        if (springs_ == wanted) return;
        springs_ = wanted;
    }
    post([](Session&) {});  // publishes
}

std::shared_ptr<const Snapshot> SessionThread::latest() const {
    const std::lock_guard lock(mutex_);
    read_ = true;
    return published_;
}

void SessionThread::put_beside(std::optional<Params> params) {
    post([this, params = std::move(params)](Session&) {
        beside_.reset();
        beside_problem_.clear();
        beside_stuck_ = false;
        if (!params) return;
        try {
            beside_.emplace(*params, threads_, Session::kCacheBytes / 2);
        } catch (const std::exception& e) {
            beside_problem_ = e.what();
        }
    });
}

bool SessionThread::behind() const {
    return beside_ && !beside_stuck_ && beside_->tick_number() != session_.tick_number();
}

// Lock-step: the one beside is brought to the tick of the other, which waits for it.
void SessionThread::follow() {
    const Clock::time_point begin = Clock::now();
    while (behind() && since(begin) < kMostFollowing) {
        const std::uint64_t tick = session_.tick_number(), before = beside_->tick_number();
        if (before > tick) {
            beside_->go_to(tick);
            continue;
        }
        beside_->step_once();
        beside_stuck_ = beside_->tick_number() == before;
    }
}

void SessionThread::publish(std::size_t commands) {
    bool springs = false;
    {
        const std::lock_guard lock(mutex_);
        springs = springs_;
    }
    std::shared_ptr<Snapshot> shot = session_.snapshot(springs);
    if (beside_) shot->beside = beside_->snapshot(springs);
    if (!beside_problem_.empty() && shot->message.empty()) shot->message = beside_problem_;
    shot->stats.tick_seconds = tick_seconds_;
    shot->stats.stage_seconds = stage_seconds_;
    bool wake = false;
    {
        const std::lock_guard lock(mutex_);
        done_ += commands;
        shot->commands = done_;
        published_ = std::move(shot);
        wake = std::exchange(read_, false);
    }
    changed_.notify_all();
    if (wake && wake_) wake_();
}

void SessionThread::run() {
    StageTimes times;
    session_.observe(&times);
    Clock::time_point last = Clock::now();
    for (;;) {
        std::vector<Command> commands;
        {
            const double wait = behind()             ? 0
                                : session_.playing() ? session_.until_next_tick()
                                                     : kLongestWait;
            std::unique_lock lock(mutex_);
            changed_.wait_for(lock, std::chrono::duration<double>(wait),
                              [this] { return quit_ || !commands_.empty(); });
            if (quit_) return;
            commands.swap(commands_);
        }
        const bool was_playing = session_.playing();
        for (const Command& command : commands)
            command(session_);
        if (!was_playing) last = Clock::now();
        const Clock::time_point begin = Clock::now();
        const double seconds = std::chrono::duration<double>(begin - last).count();
        last = begin;
        const int ticks = session_.advance(seconds, [&] { return since(begin) < kMostTicking; });
        if (ticks == 0 && commands.empty() && session_.playing()) continue;
        if (ticks > 0) {
            tick_seconds_ = since(begin) / ticks;
            stage_seconds_ = times.take(ticks);
        }
        follow();
        publish(commands.size());
    }
}

}  // namespace ember
