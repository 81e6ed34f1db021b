// The state of all sheets as a PLY file, for numpy, Blender and ParaView.
#pragma once

#include <string>

#include "sim/world_view.h"

namespace ember {

/// Binary little-endian PLY. Per node: double x y z [m], vx vy vz [m/s], temperature [degC],
/// mass [kg]; uchar phase (0 unburnt, 1 burning, 2 burnt out); int sheet, row, column (of the
/// lattice site). Faces are the quads of all sheets.
[[nodiscard]] std::string state_ply(const WorldView& world);

}  // namespace ember
