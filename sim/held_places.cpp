#include "sim/held_places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/types.h"

namespace ember {
namespace {

// The sites of a plan, row by row, as far as it matters here.
struct Sites {
    const SheetPlan& plan;
    int rows, columns;

    explicit Sites(const SheetPlan& p)
        : plan(p),
          rows(p.shape == SheetShape::Cylinder ? p.rows : p.rows + 1),
          columns(p.columns + 1) {}

    // Whether one of the four cells around the site is paper.
    [[nodiscard]] bool has_paper(int row, int column) const {
        for (const int dr : {-1, 0}) {
            int r = row + dr;
            if (r < 0 && plan.shape == SheetShape::Cylinder) r += plan.rows;
            for (const int c : {column - 1, column}) {
                const bool inside = r >= 0 && r < plan.rows && c >= 0 && c < plan.columns;
                if (inside && plan.is_paper(r, c)) return true;
            }
        }
        return false;
    }

    [[nodiscard]] HeldEdge places_of(int row, int column) const {
        const bool start = column == 0, end = column == columns - 1;
        const bool first = row == 0, last = row == rows - 1;
        HeldEdge at = HeldEdge::None;
        const auto add = [&at](bool there, HeldEdge place) {
            if (there) at = at | place;
        };
        add(start, HeldEdge::MainStart);
        add(end, HeldEdge::MainEnd);
        add(first, HeldEdge::CrossStart);
        add(last, HeldEdge::CrossEnd);
        add(start && first, HeldEdge::CornerMainStartCrossStart);
        add(start && last, HeldEdge::CornerMainStartCrossEnd);
        add(end && first, HeldEdge::CornerMainEndCrossStart);
        add(end && last, HeldEdge::CornerMainEndCrossEnd);
        return at;
    }

    // Along the sheet [m].
    [[nodiscard]] double distance(int row, int column, const std::array<double, 3>& point) const {
        const double along = plan.height * column / plan.columns - point[0];
        double across = std::abs(plan.width * row / plan.rows - point[1]);
        if (plan.shape == SheetShape::Cylinder) across = std::min(across, plan.width - across);
        return std::sqrt(along * along + across * across);
    }
};

void hold_point(const Sites& sites, const std::array<double, 3>& point,
                std::vector<std::uint8_t>& held) {
    const SheetPlan& plan = sites.plan;
    const double du = plan.height / plan.columns, dv = plan.width / plan.rows;
    const std::string key = plan.group + ".held_points";
    if (point[0] > plan.height || point[1] > plan.width)
        throw SceneError(key, "a point lies beyond the sheet");
    double nearest = std::numeric_limits<double>::infinity();
    std::size_t site = 0, best = 0;
    for (int row = 0; row < sites.rows; ++row) {
        for (int column = 0; column < sites.columns; ++column, ++site) {
            if (!sites.has_paper(row, column)) continue;
            const double distance = sites.distance(row, column, point);
            if (distance <= point[2]) held[site] = 1;
            if (distance >= nearest) continue;
            nearest = distance;
            best = site;
        }
    }
    if (!(nearest <= std::max(point[2], std::sqrt(du * du + dv * dv))))
        throw SceneError(key, "there is no paper at a point");
    held[best] = 1;
}

}  // namespace

std::vector<std::uint8_t> held_sites(const SheetPlan& plan) {
    const Sites sites(plan);
    std::vector<std::uint8_t> held;
    held.reserve(static_cast<std::size_t>(sites.rows) * static_cast<std::size_t>(sites.columns));
    for (int row = 0; row < sites.rows; ++row) {
        for (int column = 0; column < sites.columns; ++column) {
            const bool named = (sites.places_of(row, column) & plan.held) != HeldEdge::None;
            held.push_back(named && (plan.paper.empty() || sites.has_paper(row, column)) ? 1 : 0);
        }
    }
    for (const std::array<double, 3>& point : plan.held_points)
        hold_point(sites, point, held);
    return held;
}

}  // namespace ember
