// Meshes as files that many programs read: PLY, OBJ and PC2. Texts of whole files.
#pragma once

#include <span>
#include <string>

#include "app/geometry_frames.h"

namespace ember {

/// Binary little-endian PLY: float x y z [m], s t, temperature [degC], mass [kg], age [s]; uchar
/// phase; faces are the quads.
[[nodiscard]] std::string mesh_ply(const MeshFrame& mesh);

/// Wavefront OBJ: v [m], vt per corner, f.
[[nodiscard]] std::string mesh_obj(const MeshFrame& mesh);

/// Point cache 2, as modifiers of Blender, 3ds Max and Maya read it: the points [m] of all frames,
/// which must have the same number, from frame `first` on, one sample per frame.
[[nodiscard]] std::string point_cache(std::span<const MeshFrame> frames, float first);

}  // namespace ember
