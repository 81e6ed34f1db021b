#include "sim/ground.h"

#include <algorithm>

#include "sim/math.h"
#include "sim/vectorise.h"

namespace ember {

namespace {

// Nodes looked at together; most blocks are above the ground.
constexpr std::size_t kBlock = 64;

EMBER_VECTORISED bool any_below(const double* height, std::size_t count) {
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < count; ++i)
        below |= height[i] < 0.0 ? 1u : 0u;
    return below != 0;
}

}  // namespace

std::int64_t rest_on_ground(SheetState& sheet, double dt, bool skip, StepCounters& counters) {
    constexpr double kSlidingLoss = 40.0;  // [1/s]: ash slides about as far as its own size
    const double kept = ember::exp(-kSlidingLoss * dt);
    std::int64_t touched = 0;
    const std::size_t nodes = sheet.mass.size();
    for (std::size_t begin = 0; begin < nodes; begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, nodes);
        if (skip && !any_below(sheet.position.y.data() + begin, end - begin)) continue;
        counters.ground_visited += static_cast<std::int64_t>(end - begin);
        for (std::size_t n = begin; n < end; ++n) {
            if (!(sheet.position.y[n] < 0) || sheet.held[n] != 0) continue;
            sheet.position.y[n] = 0.0;
            if (sheet.velocity.y[n] < 0) sheet.velocity.y[n] = 0.0;
            sheet.velocity.x[n] *= kept;
            sheet.velocity.z[n] *= kept;
            ++touched;
        }
    }
    counters.ground_contacts += touched;
    return touched;
}

}  // namespace ember
