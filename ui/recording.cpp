#include "ui/recording.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "app/preset_io/parameter_value.h"

namespace ember {
namespace {

constexpr std::size_t kTail = 400;  // [bytes] of what a failed child wrote
constexpr int kNice = 5;            // the window goes first

std::string tail_of(std::string text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
        text.pop_back();
    return text.size() <= kTail ? text : text.substr(text.size() - kTail);
}

}  // namespace

std::vector<std::string> render_words(const std::string& program, const std::filesystem::path& take,
                                      const std::filesystem::path& output,
                                      const RecordingOptions& options) {
    std::vector<std::string> words = {
        program,
        "render",
        take,
        "-o",
        output,
        "--frames",
        "0.." + std::to_string(std::max(0, options.frames - 1)),
        "--fps",
        number_text(options.fps),
        "--size",
        std::to_string(options.width) + 'x' + std::to_string(options.height)};
    if (options.turntable != 0) {
        words.push_back("--turntable");
        words.push_back(number_text(options.turntable));
    }
    if (options.transparent) words.push_back("--transparent");
    return words;
}

int frames_done(const std::string& output) {
    constexpr std::string_view kKey = "\"done\":";
    const std::size_t at = output.rfind(kKey);
    return at == std::string::npos ? 0 : std::atoi(output.c_str() + at + kKey.size());
}

std::string complaints(const std::string& output) {
    std::istringstream lines(output);
    std::string said;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with('{')) said += line + '\n';
    }
    return said;
}

void Recording::start(const std::filesystem::path& take, const std::filesystem::path& output,
                      const RecordingOptions& options, double now) {
    std::vector<std::string> words = render_words(program_, take, output, options);
    words.insert(words.end(), {"--progress", "json"});
    child_ = std::make_unique<ChildProcess>(words, kNice);
    state_ = State::Running;
    output_ = output;
    done_ = 0;
    total_ = options.frames;
    started_ = now;
    left_ = -1;
    cancelled_ = false;
    problem_.clear();
}

void Recording::poll(double now) {
    if (state_ != State::Running) return;
    const std::optional<int> code = child_->poll();
    done_ = std::max(done_, std::min(total_, frames_done(child_->output())));
    if (done_ > 0) left_ = (now - started_) / done_ * (total_ - done_);
    if (!code) return;
    state_ = cancelled_ ? State::Cancelled : *code == 0 ? State::Done : State::Failed;
    if (*code == 0) done_ = total_;
    problem_ = tail_of(complaints(child_->output()));
    child_.reset();
}

void Recording::cancel() {
    if (state_ != State::Running) return;
    child_->terminate();  // it finishes the picture that it is at
    cancelled_ = true;
}

}  // namespace ember
