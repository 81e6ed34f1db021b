// Cracks (section 4.4): a burnt bending spring that is stretched too far opens the sheet across it.
#pragma once

#include "sim/active_nodes.h"
#include "sim/params.h"
#include "sim/spring_network.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Cuts where burnt bending springs are longer than (1 + threshold) × rest length. Their rest
/// length is the burnt rest length of the paper: it stopped changing when the last end burnt out.
///
/// The worst spring is cut first; the sites within relief_radius of a cut then rest for
/// relief_time, because the cut relieves them as soon as the forces have been integrated again,
/// and cutting everything at once turns a sheet into powder. All times are physical, so the
/// pattern does not depend on the tick.
///
/// active: of the sheet as it is. Only springs between the first and the last burnt site of a row
/// are looked at; all of them without numerics.skip.
/// burnt_out: sites that burnt out in this tick; together with the neighbours of cuts they may
/// have become hinges. Returns the number of cuts, hinges released included.
std::int64_t break_burnt_springs(const Lattice& lattice, const Params& params,
                                 const SpringNetwork& network, const ActiveNodes& active,
                                 double time, const std::vector<Index>& burnt_out,
                                 SheetState& sheet, StepCounters& counters);

}  // namespace ember
