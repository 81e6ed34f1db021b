// What follows a cut: its neighbourhood rests, and pieces that hang by one node let go.
#pragma once

#include "sim/lattice.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Sites within `radius` [m] of `site` on the unburnt sheet rest until `until` [s].
void relieve(const Lattice& lattice, Index site, double radius, double until, SheetState& sheet);

/// Lets go burnt hinges at the given sites and their neighbours. Returns their number.
std::int64_t release_hinges(const Lattice& lattice, const std::vector<Index>& sites,
                            SheetState& sheet, StepCounters& counters);

}  // namespace ember
