// Whether a tick can be believed.
#pragma once

#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Share of the heat given by which the heat ledger may be off.
inline constexpr double kHeatMargin = 1e-10;

/// Sets report.status to Diverged, with stage, sheet, node and reason, when a number of the state
/// is not finite, mechanical energy has come from nowhere, or heat has been lost or made.
void check_state(WorldState& state, StepReport& report);

}  // namespace ember
