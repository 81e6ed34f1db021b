#include "ui/pick.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/scene.h"

namespace ember {
namespace {

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

double distance_to_plane(const Vector3& eye, const Vector3& ray, const SheetPlan& plan) {
    const Vector3 normal = plan.main.cross(plan.cross);
    const double slope = ray.dot(normal);
    if (std::abs(slope) < 1e-4) return -1;  // along the plane
    return (plan.origin - eye).dot(normal) / slope;
}

}  // namespace

std::optional<Pick> pick_sheet(const WorldView& world, const Vector3& eye,
                               const Vector3& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    std::optional<Pick> pick;
    for (std::size_t s = 0; s < world.sheets.size(); ++s) {
        const SheetView& sheet = world.sheets[s];
        for (const Quad& quad : sheet.quads) {
            const Vector3 a = node(sheet, quad[0]), b = node(sheet, quad[1]);
            const Vector3 c = node(sheet, quad[2]), d = node(sheet, quad[3]);
            const double distance = std::min(distance_to(eye, direction, a, b, c),
                                             distance_to(eye, direction, a, c, d));
            if (!(distance < nearest)) continue;
            nearest = distance;
            const Vector3 place = eye + distance * direction;
            const auto off = [&](Index n) { return (node(sheet, n) - place).squaredNorm(); };
            pick =
                Pick{place, s, static_cast<std::size_t>(*std::ranges::min_element(quad, {}, off))};
        }
    }
    return pick;
}

std::optional<Vector3> pick(const WorldView& world, const Params& params, const Vector3& eye,
                            const Vector3& direction) {
    if (const auto hit = pick_sheet(world, eye, direction)) return hit->place;
    const Scene scene = make_scene(params);
    if (scene.sheets.empty()) return std::nullopt;
    const double level = distance_to_plane(eye, direction, scene.sheets.front());
    if (!(level > 0)) return std::nullopt;
    return eye + level * direction;
}

}  // namespace ember
