// Cracks (section 4.4): ash that is stretched too far opens.
#pragma once

#include "sim/active_nodes.h"
#include "sim/params.h"
#include "sim/spring_network.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// What decides where one sheet cracks.
struct FractureInput {
    const Lattice& lattice;
    const Params& params;
    const SpringNetwork& network;
    const ActiveNodes& active;  ///< of the sheet as it is
    std::size_t sheet_number;   ///< in the scene: sheets differ in their noise
    double time;                ///< [s]
    /// Sites that burnt out in this tick; like the neighbours of cuts they may be hinges now.
    const std::vector<Index>& burnt_out;
};

/// Cuts ash by the rule fracture.rule, then lets go what hangs by a single node. Returns the number
/// of cuts, hinges released included.
///
/// paper: cuts across burnt bending springs that are longer than (1 + threshold) × rest length.
/// Their rest length is the burnt rest length of the paper: it stopped changing when the last end
/// burnt out. Only springs between the first and the last burnt site of a row are looked at; all
/// of them without numerics.skip.
/// stress: see stress_fracture.h.
///
/// Either way the worst place is cut first; the sites within relief_radius of a cut then rest for
/// relief_time, because the cut relieves them as soon as the forces have been integrated again,
/// and cutting everything at once turns a sheet into powder. All times are physical, so the
/// pattern does not depend on the tick.
std::int64_t break_ash(const FractureInput& in, SheetState& sheet, StepCounters& counters);

}  // namespace ember
