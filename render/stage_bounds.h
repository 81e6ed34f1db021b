// Where the paper is, and what of it hides the sky from the ground. Pure, no GL.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/world_view.h"

namespace ember {

/// A sphere around something.
struct Bounds {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();  ///< [m]
    float radius = 0;                                  ///< [m] 0: nothing
};

/// Around every node of every sheet.
[[nodiscard]] Bounds bounds_of(const WorldView& world);

inline constexpr int kMostOccluders = 24;

/// A flat disc that stands for a part of a sheet.
struct Occluder {
    Eigen::Vector4f place;   ///< xyz [m], w area [m^2]
    Eigen::Vector4f normal;  ///< unit vector, w unused
};

/// At most kMostOccluders blocks of lattice sites, each with the area of its quads as they are now.
[[nodiscard]] std::vector<Occluder> gather_occluders(const WorldView& world);

/// World to 0 .. 1 in the picture that a lamp far away in `direction` has of `bounds`.
[[nodiscard]] Eigen::Matrix4f shadow_from_world(const Bounds& bounds,
                                                const Eigen::Vector3f& direction);

}  // namespace ember
