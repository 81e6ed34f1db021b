#include "ui/lighter_placement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/scene.h"

namespace ember {
namespace {

constexpr double kBelow = 0.020;    // [m]
constexpr double kGrain = 0.0001;   // [m] nobody aims finer
constexpr double kInwards = 0.005;  // [m]
constexpr double kRim = 0.010;      // [m] height of what counts as the lowest rim

Vector3 node(const SheetView& sheet, Index i) {
    const auto n = static_cast<std::size_t>(i);
    return {sheet.x[n], sheet.y[n], sheet.z[n]};
}

// Distance along the ray to a triangle, +inf when it is missed.
double distance_to(const Vector3& eye, const Vector3& ray, const Vector3& a, const Vector3& b,
                   const Vector3& c) {
    constexpr double kMiss = std::numeric_limits<double>::infinity();
    const Vector3 ab = b - a, ac = c - a, across = ray.cross(ac);
    const double determinant = ab.dot(across);
    if (determinant == 0) return kMiss;
    const Vector3 from = eye - a, turned = from.cross(ab);
    const double u = from.dot(across) / determinant, v = ray.dot(turned) / determinant;
    const double t = ac.dot(turned) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : kMiss;
}

double distance_to(const Vector3& eye, const Vector3& ray, const SheetView& sheet) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Quad& quad : sheet.quads) {
        const Vector3 a = node(sheet, quad[0]), b = node(sheet, quad[1]);
        const Vector3 c = node(sheet, quad[2]), d = node(sheet, quad[3]);
        nearest =
            std::min({nearest, distance_to(eye, ray, a, b, c), distance_to(eye, ray, a, c, d)});
    }
    return nearest;
}

double distance_to_plane(const Vector3& eye, const Vector3& ray, const SheetPlan& plan) {
    const Vector3 normal = plan.main.cross(plan.cross);
    const double slope = ray.dot(normal);
    if (std::abs(slope) < 1e-4) return -1;  // along the plane
    return (plan.origin - eye).dot(normal) / slope;
}

}  // namespace

std::optional<Vector3> lighter_below(const SheetView& sheet, LighterSpot spot) {
    std::vector<Vector3> rim;
    double lowest = std::numeric_limits<double>::infinity();
    const auto burns = [&](std::size_t n) {
        return sheet.phase[n] != Phase::BurntOut && sheet.initial_mass[n] > 0;
    };
    for (std::size_t n = 0; n < sheet.y.size(); ++n) {
        if (burns(n)) lowest = std::min(lowest, sheet.y[n]);
    }
    for (std::size_t n = 0; n < sheet.y.size(); ++n) {
        if (burns(n) && sheet.y[n] <= lowest + kRim) {
            rim.push_back({sheet.x[n], sheet.y[n], sheet.z[n]});
        }
    }
    if (rim.empty()) return std::nullopt;
    const auto [left, right] = std::ranges::minmax(rim, {}, [](const Vector3& p) { return p.x(); });
    const double middle = 0.5 * (left.x() + right.x());
    const double inset = std::min(kInwards, 0.5 * (right.x() - left.x()));
    double x = middle;
    if (spot == LighterSpot::LeftCorner) x = left.x() + inset;
    if (spot == LighterSpot::RightCorner) x = right.x() - inset;
    // of the nodes about there, the one nearest to the viewer
    const auto off = [&](const Vector3& p) { return std::abs(p.x() - x) - 0.1 * p.z(); };
    const Vector3 nearest = *std::ranges::min_element(rim, {}, off);
    return Vector3(x, lowest - kBelow, nearest.z());
}

std::optional<Vector3> pick(const WorldView& world, const Params& params, const Vector3& eye,
                            const Vector3& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const SheetView& s : world.sheets)
        nearest = std::min(nearest, distance_to(eye, direction, s));
    if (std::isfinite(nearest)) return eye + nearest * direction;
    const Scene scene = make_scene(params);
    if (scene.sheets.empty()) return std::nullopt;
    const double level = distance_to_plane(eye, direction, scene.sheets.front());
    if (!(level > 0)) return std::nullopt;
    return eye + level * direction;
}

void move_lighter(LighterParams& lighter, const Vector3& place, bool lit, double now) {
    const auto whole = [](double length) { return std::round(length / kGrain) * kGrain; };
    lighter.x = whole(place.x());
    lighter.y = whole(place.y());
    lighter.z = whole(place.z());
    lighter.path.clear();  // put there by hand, it stays there
    if (lit) return;
    lighter.on = true;
    lighter.start = now;
}

}  // namespace ember
