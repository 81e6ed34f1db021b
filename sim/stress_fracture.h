// Cracks of any direction: they start where ash is loaded beyond its strength and run on from
// their tips.
#pragma once

#include "sim/fracture.h"

namespace ember {

/// Grows the cracks that there are and starts new ones; appends the sites cut to `opened` and
/// returns their number.
///
/// At a burnt site the membrane stress σ (ash_stress.h) breaks the sheet along the direction in
/// which σ(n)/S(n) is largest, when that exceeds threshold × relative_strength(). A tip goes on at
/// crack_speed [m/s] while the same holds at the tip, where stress concentrates by the square root
/// of crack length over spacing; so its threshold is multiplied by the root of the paper's spacing
/// over the lattice's, which makes toughness, not strength, the property of the sheet there. It
/// turns towards the stress averaged around it by half of the angle in each step, and ends at a
/// border, at another crack, or where the ash holds.
std::int64_t break_by_stress(const FractureInput& in, SheetState& sheet, std::vector<Index>& opened,
                             StepCounters& counters);

}  // namespace ember
