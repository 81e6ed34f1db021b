#include "render/front_distance.h"

#include <algorithm>
#include <cmath>

namespace ember {
namespace {

struct Sweeper {
    const SiteGrid& grid;
    std::vector<float> distance;
    std::vector<char> fixed;  // next to the front: set once

    [[nodiscard]] Index site(Index row, Index column) const {
        if (grid.closed) row = (row + grid.rows) % grid.rows;
        const bool inside = row >= 0 && row < grid.rows && column >= 0 && column < grid.columns;
        return inside ? row * grid.columns + column : kNone;
    }
    [[nodiscard]] float at(Index row, Index column) const {
        const Index s = site(row, column);
        return s == kNone ? kFarthest : distance[static_cast<std::size_t>(s)];
    }

    // Distance of a site next to the front from the line through its nearest crossings in both
    // directions.
    void touch(std::span<const float> level, Index row, Index column) {
        const auto s = static_cast<std::size_t>(site(row, column));
        const auto crossing = [&](Index dr, Index dc, double spacing) {
            const Index other = site(row + dr, column + dc);
            if (other == kNone) return kFarthest;
            const float a = level[s], b = level[static_cast<std::size_t>(other)];
            if ((a < 0) == (b < 0)) return kFarthest;
            return static_cast<float>(spacing) * a / (a - b);
        };
        const float x = std::min(crossing(0, 1, grid.along), crossing(0, -1, grid.along));
        const float z = std::min(crossing(1, 0, grid.across), crossing(-1, 0, grid.across));
        if (x >= kFarthest && z >= kFarthest) return;
        const auto inverse_square = [](float d) { return d < kFarthest ? 1.0f / (d * d) : 0.0f; };
        fixed[s] = 1;
        distance[s] =
            x <= 0 || z <= 0 ? 0.0f : 1.0f / std::sqrt(inverse_square(x) + inverse_square(z));
    }

    // Godunov's upwind solution of |grad d| = 1.
    void relax(Index row, Index column) {
        const auto s = static_cast<std::size_t>(site(row, column));
        if (fixed[s] != 0) return;
        const double a = std::min(at(row, column - 1), at(row, column + 1));
        const double b = std::min(at(row - 1, column), at(row + 1, column));
        const double h = grid.along, k = grid.across;
        double d = std::min(a + h, b + k);
        const double p = 1 / (h * h), q = 1 / (k * k);
        const double inside = p + q - p * q * (a - b) * (a - b);
        if (inside > 0) {
            const double both = (p * a + q * b + std::sqrt(inside)) / (p + q);
            if (both >= std::max(a, b)) d = std::min(d, both);
        }
        distance[s] = std::min(distance[s], static_cast<float>(d));
    }

    void sweep() {
        const Index last_row = grid.rows - 1, last_column = grid.columns - 1;
        for (int order = 0; order < 4; ++order) {
            for (Index i = 0; i <= last_row; ++i) {
                for (Index j = 0; j <= last_column; ++j) {
                    relax(order < 2 ? i : last_row - i, order % 2 == 0 ? j : last_column - j);
                }
            }
        }
    }
};

}  // namespace

std::vector<float> front_distance(const SiteGrid& grid, std::span<const float> level) {
    Sweeper s{grid, std::vector<float>(level.size(), kFarthest), std::vector<char>(level.size())};
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column)
            s.touch(level, row, column);
    }
    const bool any = std::find(s.fixed.begin(), s.fixed.end(), 1) != s.fixed.end();
    // a second round carries distances across the seam of a tube
    for (int round = 0; any && round < (grid.closed ? 2 : 1); ++round)
        s.sweep();
    for (std::size_t n = 0; n < level.size(); ++n) {
        if (level[n] < 0) s.distance[n] = -s.distance[n];
    }
    return std::move(s.distance);
}

}  // namespace ember
