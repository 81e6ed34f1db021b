// The air's own motion.
#pragma once

#include "sim/params.h"
#include "sim/types.h"

namespace ember {

/// Velocity of the air at `time` [m/s]: (x, y, z) (1 + gust sin(2π time / gust_period)), everywhere
/// the same. Exactly zero without wind.
[[nodiscard]] Vector3 wind_velocity(const WindParams& wind, double time);

}  // namespace ember
