#include "sim/scene_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "sim/held_places.h"
#include "sim/math.h"

namespace ember {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr std::int64_t kMostSheets = 1024;
constexpr std::size_t kMostStrips = 4096;  // of a sheet

// A box by its middle and its half axes: along the strip, across it, and through the paper.
struct Box {
    Vector3 middle;
    std::array<Vector3, 3> half;
    double radius = 0;  // [m] of the sphere around it
};

Box make_box(const Vector3& middle, const Vector3& along, const Vector3& across,
             const Vector3& through) {
    const double square = along.squaredNorm() + across.squaredNorm() + through.squaredNorm();
    return {middle, {along, across, through}, std::sqrt(square)};
}

// Whether all of `a` lies on one side of all of `b` along `axis` (separating axes). A little room,
// so that sheets that touch do not depend on rounding.
bool apart_along(const Vector3& axis, const Box& a, const Box& b) {
    constexpr double kRoom = 1e-9;  // of the boxes' size
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i)
        reach += std::abs(axis.dot(a.half[i])) + std::abs(axis.dot(b.half[i]));
    const double scale = axis.norm() * (a.radius + b.radius);
    return std::abs(axis.dot(b.middle - a.middle)) >= reach - kRoom * scale && scale > 0;
}

bool meet(const Box& a, const Box& b) {
    if ((a.middle - b.middle).norm() >= a.radius + b.radius) return false;
    for (std::size_t i = 0; i < 3; ++i) {
        if (apart_along(a.half[i], a, b) || apart_along(b.half[i], a, b)) return false;
    }
    for (const Vector3& u : a.half) {
        for (const Vector3& v : b.half) {
            const Vector3 axis = u.cross(v);
            // of parallel edges nothing but rounding is left
            if (axis.squaredNorm() < 1e-16 * u.squaredNorm() * v.squaredNorm()) continue;
            if (apart_along(axis, a, b)) return false;
        }
    }
    return true;
}

// The sheet's strips of paper: of every row of cells the runs that hang together, and of rows with
// the same runs one.
std::vector<Box> boxes_of(const SheetPlan& plan, double caliper) {
    std::vector<Box> boxes;
    const double du = plan.height / plan.columns, dv = plan.width / plan.rows;
    const bool tube = plan.shape == SheetShape::Cylinder;
    const Vector3 normal = plan.cross.cross(plan.main);
    const double ring = tube ? 0.5 * dv / ember::sin(0.5 * kTwoPi / plan.rows) : 0.0;
    const auto at = [&](double row, double column) -> Vector3 {
        const Vector3 along = plan.origin + column * du * plan.main;
        if (!tube) return along + row * dv * plan.cross;
        const double angle = kTwoPi * row / plan.rows;
        return along + ring * (ember::cos(angle) * plan.cross + ember::sin(angle) * normal);
    };
    const auto same = [&](int a, int b) {
        for (int c = 0; c < plan.columns; ++c) {
            if (plan.is_paper(a, c) != plan.is_paper(b, c)) return false;
        }
        return true;
    };
    for (int first = 0, last = 0; first < plan.rows; first = last) {
        last = first + 1;
        while (!tube && last < plan.rows && (plan.paper.empty() || same(first, last)))
            ++last;
        for (int begin = 0, end = 0; begin < plan.columns; begin = end + 1) {
            end = begin;
            while (end < plan.columns && plan.is_paper(first, end))
                ++end;
            if (end == begin) continue;
            const Vector3 a = at(first, begin), b = at(last, begin);
            const Vector3 along = 0.5 * (end - begin) * du * plan.main, across = 0.5 * (b - a);
            const Vector3 through = 0.5 * caliper * across.cross(along).normalized();
            boxes.push_back(make_box(0.5 * (a + b) + along, along, across, through));
        }
        // an outline so frayed is looked at as a whole, which may refuse more but never less
        if (boxes.size() > kMostStrips && !plan.paper.empty()) {
            SheetPlan whole = plan;
            whole.paper.clear();
            return boxes_of(whole, caliper);
        }
    }
    return boxes;
}

Box around(const std::vector<Box>& boxes) {
    Box whole{Vector3::Zero(), {}, 0};
    for (const Box& box : boxes)
        whole.middle += box.middle / static_cast<double>(boxes.size());
    for (const Box& box : boxes)
        whole.radius = std::max(whole.radius, (box.middle - whole.middle).norm() + box.radius);
    return whole;
}

void check_apart(const Scene& scene, double caliper) {
    std::vector<std::vector<Box>> sheets;
    std::vector<Box> spheres;
    for (const SheetPlan& plan : scene.sheets) {
        sheets.push_back(boxes_of(plan, caliper));
        spheres.push_back(around(sheets.back()));
        const std::size_t b = sheets.size() - 1;
        for (std::size_t a = 0; a < b; ++a) {
            const double reach = spheres[a].radius + spheres[b].radius;
            if ((spheres[a].middle - spheres[b].middle).norm() >= reach) continue;
            for (const Box& p : sheets[a]) {
                for (const Box& q : sheets[b]) {
                    if (!meet(p, q)) continue;
                    throw SceneError(plan.group, scene.sheets[a].name + " and " + plan.name +
                                                     " are in each other at the start");
                }
            }
        }
    }
}

void check_plan(const SheetPlan& plan) {
    const auto require = [&](bool condition, const char* name, const char* message) {
        if (!condition) throw SceneError(plan.group + '.' + name, message);
    };
    require(plan.rows >= 1 && plan.columns >= 1, "rows",
            "a sheet needs at least one cell each way");
    require(plan.width > 0, "width", "must be above 0");
    require(plan.height > 0, "height", "must be above 0");
    const bool tube = plan.shape == SheetShape::Cylinder;
    require(!tube || plan.rows >= 3, "rows", "a cylinder needs at least 3");
    require(!tube || (plan.held & HeldEdge::BothMainEnds) == plan.held, "held",
            "a cylinder has no edges or corners but main_start and main_end");
    if (!plan.held_points.empty()) static_cast<void>(held_sites(plan));
}

}  // namespace

// The product is what a slip of a finger makes huge.
std::int64_t count_nodes(const Params& params) {
    const std::vector<SheetParams> elements = sheets_of(params);
    std::int64_t nodes = 0, sheets = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const SheetParams& s = elements[i];
        const std::string group =
            params.sheets.empty() ? "sheet" : "sheets." + std::to_string(i + 1);
        if (s.rows < 1 || s.columns < 1)
            throw SceneError(group + ".rows", "a sheet needs at least one cell each way");
        sheets += s.count;
        nodes += s.count * (std::int64_t{s.rows} + 1) * (std::int64_t{s.columns} + 1);
        if (nodes > kMostNodes) {
            throw SceneError(group + ".rows", "more than 4096 x 4096 nodes in all, here " +
                                                  std::to_string(s.count) + " x " +
                                                  std::to_string(std::int64_t{s.rows} + 1) + " x " +
                                                  std::to_string(std::int64_t{s.columns} + 1));
        }
        if (sheets > kMostSheets) throw SceneError(group + ".count", "more than 1024 sheets");
    }
    return nodes;
}

void validate(const Scene& scene, double caliper) {
    std::int64_t nodes = 0;
    for (const SheetPlan& plan : scene.sheets) {
        check_plan(plan);
        nodes += (std::int64_t{plan.rows} + 1) * (std::int64_t{plan.columns} + 1);
        if (nodes > kMostNodes)
            throw SceneError(plan.group + ".rows", "more than 4096 x 4096 nodes in all");
    }
    if (scene.sheets.size() > 1) check_apart(scene, caliper);
}

}  // namespace ember
