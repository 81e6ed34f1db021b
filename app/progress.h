// Progress on stderr: one line that is redrawn on a terminal, a line now and then elsewhere, or an
// object of JSON a line for other programs.
#pragma once

#include <chrono>
#include <string>

namespace ember {

class Progress {
  public:
    enum class Style { Quiet, Terminal, Lines, Json };
    /// `style` is "auto", "json" or "none", as --progress has it.
    [[nodiscard]] static Style style_of(const std::string& style, bool quiet);

    /// `total` pieces of work called `unit`.
    Progress(std::string unit, long total, Style style);
    void update(long done);
    /// Ends the line.
    void finish();
    [[nodiscard]] double seconds() const;  ///< since the beginning

  private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] std::string line(long done) const;
    [[nodiscard]] std::string json(long done, const char* event) const;
    std::string unit_;
    long total_, done_ = 0;
    Style style_;
    Clock::time_point start_, last_;
    int last_percent_ = -100;
};

}  // namespace ember
