// How fast things go, from measurements that the window makes; no clock of its own.
#pragma once

namespace ember {

/// How long things take, as shown.
struct FrameTimes {
    double picture_ms = 0;  ///< to draw one picture
    double tick_ms = 0;     ///< to simulate one tick
    double real_time = 0;   ///< [1] simulated time per time; 0 while paused
};

class Speedometer {
  public:
    /// `seconds` went into one picture.
    void drawn(double seconds);
    /// `ticks` of `tick_duration` [s] each were simulated and took `seconds`.
    void simulated(int ticks, double tick_duration, double seconds);
    /// `seconds` of a person's time have passed, playing or paused.
    void passed(double seconds, bool playing);

    [[nodiscard]] const FrameTimes& times() const { return times_; }

  private:
    FrameTimes times_;
    double wall_ = 0, simulated_ = 0;  // [s] since the ratio was last taken
};

}  // namespace ember
