// Whether a scene can be built.
#pragma once

#include "sim/params.h"
#include "sim/scene.h"

namespace ember {

/// Throws SceneError when a sheet has no size, no node to hold it where it says, or a shape that
/// its lattice cannot have, or when two sheets are in each other's way from the start. For that
/// each sheet is a set of flat boxes, `caliper` [m] thick: its strips of paper, or on a tube the
/// strips of each side. Waviness is not counted.
void validate(const Scene& scene, double caliper);

}  // namespace ember
