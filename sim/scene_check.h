// Whether a scene can be built.
#pragma once

#include <cstdint>

#include "sim/params.h"
#include "sim/scene.h"

namespace ember {

/// How many nodes the scene of `params` begins with, counted in 64 bits before anything is made.
/// Throws SceneError when there are more than kMostNodes, or more than 1024 sheets.
[[nodiscard]] std::int64_t count_nodes(const Params& params);

/// Throws SceneError when a sheet has no size, no node to hold it where it says, or a shape that
/// its lattice cannot have, or when two sheets are in each other's way from the start. For that
/// each sheet is a set of flat boxes, `caliper` [m] thick: its strips of paper, or on a tube the
/// strips of each side. Waviness is not counted.
void validate(const Scene& scene, double caliper);

}  // namespace ember
