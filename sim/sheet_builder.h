// Makes a sheet's first state: flat or rolled, slightly wavy, cold, at rest, partly held.
#pragma once

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/world_state.h"

namespace ember {

/// Initial state of `plan` on `lattice`. Masses by border model: a quarter of each quad's mass to
/// each corner (tributary), or all nodes alike (uniform); either sums to G·width·height.
/// Nodes of the held edge are attached. Rest lengths are those of the unburnt sheet.
[[nodiscard]] SheetState make_sheet(const SheetPlan& plan, const Lattice& lattice,
                                    const Params& params, std::size_t sheet);

/// Throws std::invalid_argument naming the parameter when `plan` cannot be built.
void validate(const SheetPlan& plan);

}  // namespace ember
