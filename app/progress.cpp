#include "app/progress.h"

#include <unistd.h>

#include <cstdio>

namespace ember {
namespace {

double seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

}  // namespace

Progress::Progress(std::string unit, long total, bool quiet)
    : unit_(std::move(unit)),
      total_(total),
      quiet_(quiet),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

std::string Progress::line(long done) const {
    const double elapsed = seconds(Clock::now() - start_);
    const double rate = elapsed > 0 ? static_cast<double>(done) / elapsed : 0;
    const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0;
    char text[160];
    std::snprintf(text, sizeof text, "%ld/%ld %s  %3ld %%  %.1f/s  %d:%02d left", done, total_,
                  unit_.c_str(), total_ > 0 ? 100 * done / total_ : 100, rate,
                  static_cast<int>(left) / 60, static_cast<int>(left) % 60);
    return text;
}

void Progress::update(long done) {
    if (quiet_ || total_ <= 0) return;
    const auto now = Clock::now();
    const int percent = static_cast<int>(100 * done / total_);
    if (terminal_) {
        if (done < total_ && seconds(now - last_) < 0.1) return;
        std::fprintf(stderr, "\r%s\033[K", line(done).c_str());
    } else {
        if (done < total_ && percent < last_percent_ + 10 && seconds(now - last_) < 10) return;
        std::fprintf(stderr, "%s\n", line(done).c_str());
    }
    std::fflush(stderr);
    last_ = now;
    last_percent_ = percent;
}

void Progress::finish() {
    if (!quiet_ && terminal_ && total_ > 0) std::fputc('\n', stderr);
}

}  // namespace ember
