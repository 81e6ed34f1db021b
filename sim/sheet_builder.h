// Makes a sheet's first state: flat or rolled, slightly wavy, cold, at rest, partly held.
#pragma once

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/world_state.h"

namespace ember {

/// Initial state of `plan` on `lattice`. Masses by border model: a quarter of each quad's mass to
/// each corner (tributary), or all nodes alike (uniform); either sums to G·width·height.
/// Nodes at held places are attached. Rest lengths are those of the unburnt sheet. Quads exist only
/// where the plan has paper; sites without any keep a node of mass 0 that never moves, and what
/// hangs together by a corner alone is apart from the start.
[[nodiscard]] SheetState make_sheet(const SheetPlan& plan, const Lattice& lattice,
                                    const Params& params, std::size_t sheet);

}  // namespace ember
