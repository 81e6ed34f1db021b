// A rendering of the burn by the program itself, as a child: the same pixels as off-screen.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ui/child_process.h"

namespace ember {

/// What to record of a take.
struct RecordingOptions {
    int frames = 240;
    double fps = 30;
    int width = 1280, height = 720;
    double turntable = 0;  ///< [deg] over the shot
    bool transparent = false;
    bool film = false;  ///< one MP4 instead of numbered PNGs
};

/// The words of `emberleaf render` for it.
[[nodiscard]] std::vector<std::string> render_words(const std::string& program,
                                                    const std::filesystem::path& take,
                                                    const std::filesystem::path& output,
                                                    const RecordingOptions& options);

class Recording {
  public:
    enum class State { None, Running, Done, Failed, Cancelled };

    /// `program`: emberleaf itself.
    explicit Recording(std::string program = own_program()) : program_(std::move(program)) {}

    /// Starts to draw `take` into `output`. Throws std::runtime_error when it cannot be started.
    void start(const std::filesystem::path& take, const std::filesystem::path& output,
               const RecordingOptions& options, double now);
    /// Takes in how far it is.
    void poll(double now);
    void cancel();

    [[nodiscard]] State state() const { return state_; }
    [[nodiscard]] int done() const { return done_; }
    [[nodiscard]] int total() const { return total_; }
    /// [s] left; negative while unknown.
    [[nodiscard]] double left() const { return left_; }
    [[nodiscard]] const std::filesystem::path& output() const { return output_; }
    /// Why it failed: the last lines that the child wrote.
    [[nodiscard]] const std::string& problem() const { return problem_; }

  private:
    std::string program_;
    std::unique_ptr<ChildProcess> child_;
    State state_ = State::None;
    bool cancelled_ = false;
    std::filesystem::path output_;
    int done_ = 0, total_ = 0;
    double started_ = 0, left_ = -1;  // [s]
    std::string problem_;
};

/// Frames that are done according to what `render --progress json` has written; 0 when it has not.
[[nodiscard]] int frames_done(const std::string& output);
/// What it has written besides its progress, as lines.
[[nodiscard]] std::string complaints(const std::string& output);

}  // namespace ember
