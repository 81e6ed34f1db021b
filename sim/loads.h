// What pulls, pushes and drags at nodes from outside during a tick.
#pragma once

#include "sim/fire_coupling.h"
#include "sim/integrator.h"
#include "sim/params.h"

namespace ember {

/// Collects gravity, the push of the fire, and air drag for one tick. `fire` may be empty. The drag
/// is linear in v - W, W the wind at `middle` [s] of the tick, so W's part of it is one constant
/// force more.
void gather_loads(const Params& params, const SheetState& sheet, const NodeFire& fire,
                  NodeLoads& loads, double middle = 0);

/// Unit normals of all nodes [1], N: area-weighted over the quads of each node; zero where the
/// quads have no area.
void node_normals(const SheetState& sheet, Vector3Array& normals);

}  // namespace ember
