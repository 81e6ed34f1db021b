// Runs a session on a thread of its own and publishes what it becomes.
#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "ui/session.h"

namespace ember {

/// The only owner of a session, and of a second one that may burn beside it in lock-step. Others
/// send commands, which run in order between two ticks, and read the snapshot published last.
class SessionThread {
  public:
    using Command = std::function<void(Session&)>;

    /// `wake` is called on the session's thread whenever a snapshot has been published and the one
    /// before has been read. Throws std::invalid_argument when `params` cannot be built.
    SessionThread(const Params& params, int threads, std::function<void()> wake = {},
                  std::size_t cache_bytes = Session::kCacheBytes);
    ~SessionThread();
    SessionThread(const SessionThread&) = delete;
    SessionThread& operator=(const SessionThread&) = delete;

    /// Returns the command's number; Snapshot::commands says how many have been done.
    std::uint64_t post(Command command);
    /// Does what `command` says and waits until it is done and published.
    void call(const Command& command);
    /// Whether snapshots are to carry springs, which only some views show.
    void want_springs(bool wanted);

    /// Never null.
    [[nodiscard]] std::shared_ptr<const Snapshot> latest() const;

    /// A burn of `params` beside this one: at the same tick in every snapshot. Where it cannot be
    /// built or goes wrong, its message says so and it stays behind. No params: none any more.
    void put_beside(std::optional<Params> params);

  private:
    void run();
    [[nodiscard]] bool behind() const;
    void follow();
    void publish(std::size_t commands);

    // only the thread touches these
    Session session_;
    std::optional<Session> beside_;
    std::string beside_problem_;
    bool beside_stuck_ = false;
    int threads_;
    double tick_seconds_ = 0;
    std::array<double, kStageCount> stage_seconds_{};
    std::function<void()> wake_;

    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<Command> commands_;
    std::shared_ptr<const Snapshot> published_;
    mutable bool read_ = true;
    bool springs_ = false, quit_ = false;
    std::uint64_t done_ = 0, posted_ = 0;  // commands
    std::thread thread_;                   // the last, so that all else is there when it starts
};

}  // namespace ember
