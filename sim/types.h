// The few types that every file of the simulation shares.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ember {

using Index = std::int32_t;       ///< node, site, spring or quad number; -1 means "none"
using Vector3 = Eigen::Vector3d;  ///< one point or vector; y is up
inline constexpr Index kNone = -1;

/// What has become of a node (section 4.2 of the paper).
enum class Phase : std::uint8_t { Unburnt = 0, Burning = 1, BurntOut = 2 };

/// N vectors as three separate arrays, so that loops over them vectorise. Shape 3×N.
struct Vector3Array {
    std::vector<double> x, y, z;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Vector3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
    void set(std::size_t i, const Vector3& v) { x[i] = v.x(), y[i] = v.y(), z[i] = v.z(); }
    void resize(std::size_t n) { x.resize(n), y.resize(n), z.resize(n); }
    void push_back(const Vector3& v) { x.push_back(v.x()), y.push_back(v.y()), z.push_back(v.z()); }
};

}  // namespace ember
