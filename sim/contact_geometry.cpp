#include "sim/contact_geometry.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ember {
namespace {

// How far beyond an edge [1, share of the triangle] a node still counts as above it, so that
// nothing slips through between two triangles that bend away from each other.
constexpr double kBeyondEdge = 0.05;

Vector3 area_of(const Vector3& a, const Vector3& b, const Vector3& c) {
    return (b - a).cross(c - a);
}

Vector3 at(const Path& path, double time) {
    return path.from + time * (path.to - path.from);
}

// Shares of the corners in the foot of p on the plane of a triangle.
std::array<double, 3> shares_at(const Vector3& p, const Vector3& a, const Vector3& b,
                                const Vector3& c, const Vector3& area) {
    const double whole = area.squaredNorm();
    const double at_b = (p - a).cross(c - a).dot(area) / whole;
    const double at_c = (b - a).cross(p - a).dot(area) / whole;
    return {1.0 - at_b - at_c, at_b, at_c};
}

// How the distance between two planes changes from now to then, and when they meet.
struct Approach {
    double side = 1, now = 0, then = 0;  // [1] ±1, [m]
    double time = 0;                     // [1] of the interval, when only the thickness is left
};

// From signed distances. Braking begins when half of the gap is used up, see contact_solver.h.
bool approach(double from, double to, double thickness, double slack, bool upper, Approach& a) {
    a.side = from > 0 || (from == 0 && upper) ? 1.0 : -1.0;
    a.now = a.side * from;
    a.then = a.side * to;
    const bool close = a.now < thickness + slack;
    if (!close && !(a.now - thickness < 2.0 * (a.now - a.then))) return false;
    a.time = close ? 0.0 : std::min(1.0, (a.now - thickness) / (a.now - a.then));
    return true;
}

}  // namespace

bool meet(const Path& node, const std::array<Path, 3>& triangle, double thickness, double slack,
          bool upper, Touch& touch) {
    const auto& [a, b, c] = triangle;
    const Vector3 area = area_of(a.from, b.from, c.from), later = area_of(a.to, b.to, c.to);
    const double size = area.norm(), later_size = later.norm();
    if (!(size > 0) || !(later_size > 0)) return false;
    Approach way;
    if (!approach(area.dot(node.from - a.from) / size, later.dot(node.to - a.to) / later_size,
                  thickness, slack, upper, way)) {
        return false;
    }
    const Vector3 p_a = at(a, way.time), p_b = at(b, way.time), p_c = at(c, way.time);
    const Vector3 facing = area_of(p_a, p_b, p_c);
    const double length = facing.norm();
    if (!(length > 0)) return false;
    std::array<double, 3> shares = shares_at(at(node, way.time), p_a, p_b, p_c, facing);
    double sum = 0.0;
    for (double& share : shares) {
        if (!(share >= -kBeyondEdge)) return false;
        share = std::max(share, 0.0);
        sum += share;
    }
    touch.weight = {1.0, -shares[0] / sum, -shares[1] / sum, -shares[2] / sum};
    touch.normal = way.side / length * facing;
    touch.gap = way.now - thickness;
    return true;
}

bool meet(const std::array<Path, 2>& edge, const std::array<Path, 2>& other, double thickness,
          double slack, bool upper, Touch& touch) {
    constexpr double kParallel = 1e-3;  // [1] sine of the angle between edges
    const auto& [a, b] = edge;
    const auto& [c, d] = other;
    const auto across = [&](const Vector3& p, const Vector3& q) -> Vector3 {
        const Vector3 normal = p.cross(q);
        const double length = normal.norm();
        return length > kParallel * p.norm() * q.norm() ? Vector3(normal / length)
                                                        : Vector3(Vector3::Zero());
    };
    const Vector3 now = across(b.from - a.from, d.from - c.from);
    const Vector3 later = across(b.to - a.to, d.to - c.to);
    if (now.isZero(0.0) || later.isZero(0.0)) return false;
    Approach way;
    if (!approach(now.dot(a.from - c.from), later.dot(a.to - c.to), thickness, slack, upper, way))
        return false;
    const Vector3 p = at(b, way.time) - at(a, way.time), q = at(d, way.time) - at(c, way.time);
    const Vector3 between = at(c, way.time) - at(a, way.time);
    const Vector3 facing = across(p, q);
    const double whole = p.cross(q).squaredNorm();
    if (facing.isZero(0.0) || !(whole > 0)) return false;
    const double s = between.cross(q).dot(p.cross(q)) / whole;
    const double t = between.cross(p).dot(p.cross(q)) / whole;
    if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return false;
    touch.weight = {1 - s, s, t - 1, -t};
    touch.normal = way.side * facing;
    touch.gap = way.now - thickness;
    return true;
}

}  // namespace ember
