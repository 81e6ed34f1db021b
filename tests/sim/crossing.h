// Whether paper passes through paper: edges of quads against triangles of quads.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <vector>

#include "sim/world.h"

namespace ember::test {

/// Whether the segment p-q passes through the triangle a, b, c (the signs of five volumes).
inline bool passes_through(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b,
                           const Vector3& c) {
    const auto volume = [](const Vector3& o, const Vector3& x, const Vector3& y, const Vector3& z) {
        return (x - o).dot((y - o).cross(z - o));
    };
    if (volume(p, a, b, c) * volume(q, a, b, c) >= 0) return false;
    const double ab = volume(p, q, a, b), bc = volume(p, q, b, c), ca = volume(p, q, c, a);
    return (ab > 0 && bc > 0 && ca > 0) || (ab < 0 && bc < 0 && ca < 0);
}

struct Corner {
    std::size_t sheet;
    Index node;
    bool operator==(const Corner&) const = default;
};
using Triangle = std::array<Corner, 3>;

/// The two triangles of every quad of a world.
inline std::vector<Triangle> triangles_of(const WorldState& state) {
    std::vector<Triangle> triangles;
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        for (const Quad& q : state.sheets[s].quads) {
            triangles.push_back({Corner{s, q[0]}, Corner{s, q[1]}, Corner{s, q[2]}});
            triangles.push_back({Corner{s, q[0]}, Corner{s, q[2]}, Corner{s, q[3]}});
        }
    }
    return triangles;
}

/// How many pairs of an edge and a triangle without a common corner pass through each other.
inline int count_crossings(const WorldState& state) {
    const std::vector<Triangle> triangles = triangles_of(state);
    const auto at = [&](const Corner& c) {
        return state.sheets[c.sheet].position.at(static_cast<std::size_t>(c.node));
    };
    struct Place {
        std::array<Vector3, 3> corner;
        Eigen::AlignedBox3d box;
    };
    std::vector<Place> places;
    for (const Triangle& t : triangles) {
        Place place{{at(t[0]), at(t[1]), at(t[2])}, {}};
        for (const Vector3& corner : place.corner)
            place.box.extend(corner);
        places.push_back(place);
    }
    int crossings = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = 0; j < triangles.size(); ++j) {
            if (i == j || !places[i].box.intersects(places[j].box)) continue;
            const auto shares = [&](const Corner& c) {
                return std::find(triangles[j].begin(), triangles[j].end(), c) != triangles[j].end();
            };
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                if (shares(triangles[i][k]) || shares(triangles[i][next])) continue;
                crossings +=
                    passes_through(places[i].corner[k], places[i].corner[next], places[j].corner[0],
                                   places[j].corner[1], places[j].corner[2])
                        ? 1
                        : 0;
            }
        }
    }
    return crossings;
}

}  // namespace ember::test
