#include "app/progress.h"

#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

namespace ember {
namespace {

double to_seconds(std::chrono::steady_clock::duration d) {
    return std::chrono::duration<double>(d).count();
}

}  // namespace

Progress::Style Progress::style_of(const std::string& style, bool quiet) {
    if (style == "json") return Style::Json;
    if (quiet || style == "none") return Style::Quiet;
    return ::isatty(STDERR_FILENO) == 1 ? Style::Terminal : Style::Lines;
}

Progress::Progress(std::string unit, long total, Style style)
    : unit_(std::move(unit)),
      total_(total),
      style_(total > 0 ? style : Style::Quiet),
      start_(Clock::now()),
      last_(start_) {}

double Progress::seconds() const {
    return to_seconds(Clock::now() - start_);
}

std::string Progress::line(long done) const {
    constexpr int kBar = 20;
    const double elapsed = seconds();
    const double rate = elapsed > 0 ? static_cast<double>(done) / elapsed : 0;
    const double left = rate > 0 ? static_cast<double>(total_ - done) / rate : 0;
    const auto filled = static_cast<std::size_t>(kBar * done / total_);
    const std::string bar = style_ == Style::Terminal ? '[' + std::string(filled, '#') +
                                                            std::string(kBar - filled, '.') + "] "
                                                      : "";
    char text[160];
    std::snprintf(text, sizeof text, "%s%ld/%ld %s  %3ld %%  %.1f/s  %d:%02d left", bar.c_str(),
                  done, total_, unit_.c_str(), 100 * done / total_, rate,
                  static_cast<int>(left) / 60, static_cast<int>(left) % 60);
    return text;
}

std::string Progress::json(long done, const char* event) const {
    const double elapsed = seconds();
    const double rate = elapsed > 0 ? static_cast<double>(done) / elapsed : 0;
    nlohmann::ordered_json object = {{"event", event},  {"unit", unit_},      {"done", done},
                                     {"total", total_}, {"seconds", elapsed}, {"rate", rate}};
    if (rate > 0) object["left"] = static_cast<double>(total_ - done) / rate;
    return object.dump();
}

void Progress::update(long done) {
    done_ = done;
    const auto now = Clock::now();
    const int percent = static_cast<int>(100 * done / std::max(total_, 1l));
    const double since = to_seconds(now - last_);
    switch (style_) {
        case Style::Quiet:
            return;
        case Style::Terminal:
            if (done < total_ && since < 0.1) return;
            std::fprintf(stderr, "\r%s\033[K", line(done).c_str());
            break;
        case Style::Lines:
            if (done < total_ && percent < last_percent_ + 10 && since < 10) return;
            std::fprintf(stderr, "%s\n", line(done).c_str());
            break;
        case Style::Json:
            if (done < total_ && since < 0.1) return;
            std::fprintf(stderr, "%s\n", json(done, "progress").c_str());
            break;
    }
    std::fflush(stderr);
    last_ = now;
    last_percent_ = percent;
}

void Progress::finish() {
    if (style_ == Style::Terminal) std::fputc('\n', stderr);
    if (style_ == Style::Json) std::fprintf(stderr, "%s\n", json(done_, "end").c_str());
}

}  // namespace ember
