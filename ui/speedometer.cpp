#include "ui/speedometer.h"

namespace ember {
namespace {

constexpr double kRatioEvery = 0.5;  // [s]

// Numbers that jump with every frame cannot be read.
void follow(double& shown, double value) {
    shown = shown == 0 ? value : shown + 0.1 * (value - shown);
}

}  // namespace

void Speedometer::drawn(double seconds) {
    follow(times_.picture_ms, 1e3 * seconds);
}

void Speedometer::simulated(int ticks, double tick_duration, double seconds) {
    if (ticks == 0) return;
    follow(times_.tick_ms, 1e3 * seconds / ticks);
    simulated_ += ticks * tick_duration;
}

void Speedometer::passed(double seconds, bool playing) {
    if (!playing) {
        times_.real_time = wall_ = simulated_ = 0;
        return;
    }
    wall_ += seconds;
    if (wall_ < kRatioEvery) return;
    times_.real_time = simulated_ / wall_;
    wall_ = simulated_ = 0;
}

}  // namespace ember
