// Fire as particles (section 4.2): emitters on the lighter and on every burning node.
//
// Particle k of an emitter that started at t0 is born at t0 + (k + u_k)/rate with its own random
// numbers, at the place where the emitter is at that very moment. Which particles exist, and how
// they fly, therefore does not depend on the tick: a shorter tick refines the same fire.
#pragma once

#include "sim/active_nodes.h"
#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world_state.h"

namespace ember {

/// Moves every particle through [time, time + dt], removes those that die, and adds those that
/// are born in it. Between collisions with nothing, a particle obeys
///     dv/dt = b u/u0 ŷ - γ v,   du/dt = -u/τ,   u = T - ambient
/// whose solution is used exactly, with u frozen at its mean over the tick in the first. In moving
/// air: v is relative to the wind, which is frozen at the middle of the tick.
/// `lattices`: of the sheets, for fire.area_emission.
/// `active`: the burning nodes of each sheet; nullptr to look for them at every node.
void advance_fire(const Params& params, const std::vector<LighterParams>& lighters,
                  std::uint64_t seed, double time, double dt, const std::vector<SheetState>& sheets,
                  const std::vector<const Lattice*>& lattices,
                  const std::vector<const ActiveNodes*>& active, FireState& fire,
                  StepCounters& counters);

}  // namespace ember
