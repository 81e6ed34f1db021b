// Section 4.1: how the sheets are moved through a tick, and touch.
#pragma once

#include "sim/tick.h"

namespace ember {

/// Moves all sheets through the tick: loads, sleep, sub-steps, and contact wherever anything is
/// near anything else. Adds the work done to the ledger, but does not measure the energy again.
/// Returns false, with reason and sheet in the report, when a sheet cannot be moved.
bool move_sheets(const Tick& tick, StepReport& report);

}  // namespace ember
