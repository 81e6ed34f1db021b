// The ground at y = 0: pieces that reach it stay on it.
#pragma once

#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Puts nodes below y = 0 back onto the ground, takes away their downward speed, and slows their
/// sliding over `dt` [s] (inelastic contact at the end of a tick). Held nodes are left alone.
/// With `skip`, blocks of nodes that are all above the ground are not visited; the result is the
/// same. Returns the number of nodes touched.
std::int64_t rest_on_ground(SheetState& sheet, double dt, bool skip, StepCounters& counters);

}  // namespace ember
