// A hand that holds a sheet and pulls.
#pragma once

#include "sim/mechanics.h"
#include "sim/params.h"

namespace ember {

/// Adds the pull of a hand to the loads of one tick [N], constant while it lasts:
///
///     F_n = m_n w_n (ω² (p - x_h) - 2 ω v_n),   w = (1 - d²/r²)²,   ω = 1 / response
///
/// p is the hand's place, x_h the node that it holds (the first copy at its site), d [m] the
/// distance on the unburnt lattice from n to it, r the radius. All nodes within reach feel the same
/// acceleration, so the pull does not crumple what it holds. A tick must be shorter than `response`
/// for a critically damped motion. A site outside the sheet is not held: nothing is added.
void pull_by_hand(const HandParams& hand, const Lattice& lattice, const SheetState& sheet,
                  NodeLoads& loads);

}  // namespace ember
