#include "sim/ground.h"

#include "sim/math.h"

namespace ember {

std::int64_t rest_on_ground(SheetState& sheet, double dt, StepCounters& counters) {
    constexpr double kSlidingLoss = 40.0;  // [1/s]: ash slides about as far as its own size
    const double kept = ember::exp(-kSlidingLoss * dt);
    std::int64_t touched = 0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (!(sheet.position.y[n] < 0) || sheet.held[n] != 0) continue;
        sheet.position.y[n] = 0.0;
        if (sheet.velocity.y[n] < 0) sheet.velocity.y[n] = 0.0;
        sheet.velocity.x[n] *= kept;
        sheet.velocity.z[n] *= kept;
        ++touched;
    }
    counters.ground_contacts += touched;
    return touched;
}

}  // namespace ember
