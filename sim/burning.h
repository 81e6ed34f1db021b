// The states of a node (section 4.2): unburnt, burning, burnt out.
#pragma once

#include "sim/active_nodes.h"
#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Lights nodes that have reached the ignition temperature, burns mass off burning ones at
/// burn_rate · area until residual_mass of it is left, and puts those out. Held nodes do not burn.
/// `time` [s] is the end of the tick, `dt` [s] its length times burn_speed.
/// `active`: the burning nodes; nullptr to look at every node, with the same result.
/// Sites that burnt out are appended to `burnt_out`. Returns the mass that went up in flames [kg].
double update_phases(const Params& params, double time, double dt, const ActiveNodes* active,
                     SheetState& sheet, std::vector<Index>& burnt_out, StepCounters& counters);

}  // namespace ember
