// Progress on stderr: one line that is redrawn on a terminal, a line now and then elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace ember {

class Progress {
  public:
    /// `total` pieces of work called `unit`; silent when `quiet`.
    Progress(std::string unit, long total, bool quiet);
    void update(long done);
    /// Ends the line.
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    [[nodiscard]] std::string line(long done) const;
    std::string unit_;
    long total_;
    bool quiet_, terminal_;
    Clock::time_point start_, last_;
    int last_percent_ = -100;
};

}  // namespace ember
