// Shrinking of burning fibres (section 4.3, eq. 4).
//
//     l(t + dt) = l(t) - factor · l_init · (T_a + T_b) / (k_s c_s)       T in degC, per step
//
// taken as a rate with the reference step that the paper leaves out, so that halving dt changes
// nothing beyond the order of the method:
//
//     dl/dt = -w factor l_init (T_a + T_b) / (k_s c_s dt_ref),   l >= floor l_init
//
// w is 1 when both ends burn, and 1/2 for bending springs with one burning end; or, with the rule
// "half", half the number of burning ends for every spring.
#pragma once

#include "sim/active_nodes.h"
#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Shrinks the rest lengths of one sheet over `dt` [s]. `active`: of the sheet as it is. Only slots
/// between the first and the last burning site of a row are visited; all of them without `skip`.
void shrink_burning_springs(const Lattice& lattice, const Params& params, double dt,
                            const ActiveNodes& active, SheetState& sheet, StepCounters& counters);

}  // namespace ember
