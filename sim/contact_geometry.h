// Whether and where a node and a triangle, or two edges, meet while they move straight on.
#pragma once

#include <array>

#include "sim/types.h"

namespace ember {

/// Position now and at the end [m].
struct Path {
    Vector3 from, to;
};

/// Where two things meet: `weight` is that of each of the four nodes in the vector between the
/// nearest points, from the second thing to the first; their sum is 0.
struct Touch {
    Vector3 normal;  ///< [1] unit vector from the second to the first
    std::array<double, 4> weight;
    double gap;  ///< [m] between them now, beyond the thickness; < 0: closer
};

/// Node and triangle keep to the side of each other on which they are now; `upper` decides when the
/// node lies exactly in the triangle's plane. Returns true when they are closer than `thickness`
/// and `slack` [m] together, or when their paths would take up more than half of the gap between
/// them, and the node is above the triangle when they meet. Paths are taken as straight, the
/// distance to the plane as linear in time. A triangle without area touches nothing.
[[nodiscard]] bool meet(const Path& node, const std::array<Path, 3>& triangle, double thickness,
                        double slack, bool upper, Touch& touch);

/// The same for two edges, of which neither may end before the place where they cross.
/// Parallel edges do not meet.
[[nodiscard]] bool meet(const std::array<Path, 2>& edge, const std::array<Path, 2>& other,
                        double thickness, double slack, bool upper, Touch& touch);

}  // namespace ember
