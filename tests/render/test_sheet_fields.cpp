// Distances from the fronts, in millimetres whatever the lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "render/sheet_fields.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

// Level of a front through (x, z) = (offset, 0) [mm] whose normal has this angle.
std::vector<float> straight_front(const SiteGrid& grid, double angle, double offset) {
    std::vector<float> level;
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            level.push_back(static_cast<float>((grid.along * column - offset) * std::cos(angle) +
                                               grid.across * row * std::sin(angle)));
        }
    }
    return level;
}

TEST(FrontDistance, IsExactForFrontsAlongTheGridAndCloseForSlantedOnes) {
    const SiteGrid grid{20, 30, false, 6.5, 6.2};
    for (const double angle : {0.0, 0.3, 0.8, 1.2}) {
        const std::vector<float> level = straight_front(grid, angle, 80.0);
        const std::vector<float> d = front_distance(grid, level);
        for (std::size_t n = 0; n < d.size(); ++n) {
            // near the border the nearest place of the endless front may not be on the sheet
            const auto row = static_cast<Index>(n) / grid.columns;
            const auto column = static_cast<Index>(n) % grid.columns;
            const bool inside = row >= 4 && row < 16 && column >= 4 && column < 26;
            if (std::abs(level[n]) > 16 || !inside) continue;
            const float allowed = angle == 0 ? 1e-3f : 0.1f * std::abs(level[n]) + 0.4f;
            EXPECT_NEAR(d[n], level[n], allowed) << angle;
        }
    }
}

TEST(FrontDistance, WithoutAFrontEverythingIsFarAway) {
    const SiteGrid grid{3, 4, false, 5, 5};
    EXPECT_EQ(front_distance(grid, std::vector<float>(12, 1.0f)),
              std::vector<float>(12, kFarthest));
    EXPECT_EQ(front_distance(grid, std::vector<float>(12, -1.0f)),
              std::vector<float>(12, -kFarthest));
}

TEST(FrontDistance, GoesAroundTheSeamOfATube) {
    const SiteGrid grid{20, 3, true, 5, 5};
    std::vector<float> level(60, -5.0f);
    for (int column = 0; column < 3; ++column)
        level[static_cast<std::size_t>(column)] = 5.0f;  // row 0
    const std::vector<float> d = front_distance(grid, level);
    for (Index row = 1; row < 20; ++row) {
        const double around = 5.0 * std::min(row, 20 - row) - 2.5;
        EXPECT_NEAR(d[static_cast<std::size_t>(3 * row)], -around, 1e-3) << row;
    }
}

// The staged fronts are circles around the corner where row 0 meets the last column.
double from_corner(const SiteGrid& grid, double row, double column) {
    return std::hypot(grid.across * row, grid.along * (grid.columns - 1 - column));
}

TEST(SiteFields, AreMillimetresBehindBothFrontsOnEveryLattice) {
    for (const auto& [rows, columns] : {std::pair{17, 25}, {33, 49}, {65, 97}}) {
        const StagedWorld staged = test::burning_sheet(rows, columns, 0);
        const WorldView view = staged.view();
        const SiteGrid grid = site_grid(view.sheets[0]);
        const FieldGrid fields = make_field_grid(view.sheets[0], view);
        for (Index row = 0; row + 1 < rows; ++row) {
            for (Index column = 0; column + 1 < columns; ++column) {
                const SiteFields f = smooth_fields(fields, row, column, 0.5f, 0.5f);
                const double r = from_corner(grid, row + 0.5, column + 0.5);
                const double charred = 1e3 * test::kFront - r, burnt = 1e3 * test::kBurntOut - r;
                const double allowed = 0.2 * grid.along;
                if (std::abs(charred) < 15) {
                    EXPECT_NEAR(f.charred, charred, allowed) << rows;
                }
                if (std::abs(burnt) < 15) {
                    EXPECT_NEAR(f.burnt, burnt, allowed) << rows;
                }
            }
        }
    }
}

// Where a field is 0 along lines across a slanted front, less the straight line through these
// places: how much of its variation repeats with the lattice.
template <class Field>
double lattice_amplitude(double cell, Field&& field) {
    std::complex<double> sum = 0;
    int count = 0;
    for (double z = 5 * cell; z < 13 * cell; z += cell / 16, ++count) {
        double low = 0, high = 25 * cell;  // the field rises with x
        for (int i = 0; i < 40; ++i) {
            const double middle = 0.5 * (low + high);
            (field(middle, z) < 0 ? low : high) = middle;
        }
        const double straight = 16 * cell - 0.55 * z;
        sum += (low - straight) * std::polar(1.0, 2 * 3.141592653589793 * z / cell);
    }
    return 2 * std::abs(sum) / count;
}

// A front through a lattice of 6 mm, as times of ignition behind it and warmth ahead: the line
// where paper chars must not show the lattice. The burn progress of the nodes, interpolated, does.
TEST(SmoothFields, NoEdgeShowsTheGrid) {
    constexpr double kCell = 6.0, kSlope = 0.55;
    const SiteGrid grid{20, 26, false, kCell, kCell};
    const double across = std::sqrt(1 + kSlope * kSlope);
    std::vector<float> level, progress;
    FieldGrid fields{grid.columns + 2 * kFieldBorder, {}};
    fields.fields.resize(static_cast<std::size_t>((grid.rows + 2 * kFieldBorder) * fields.columns));
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            const double behind = (kCell * column + kSlope * kCell * row - 16 * kCell) / across;
            level.push_back(static_cast<float>(behind));
            progress.push_back(static_cast<float>(behind < 0 ? std::exp(behind / 6) - 0.9 : 0.1));
        }
    }
    const std::vector<float> distance = front_distance(grid, level);
    for (Index row = 0; row < grid.rows; ++row) {
        for (Index column = 0; column < grid.columns; ++column) {
            fields
                .fields[static_cast<std::size_t>((row + kFieldBorder) * fields.columns + column +
                                                 kFieldBorder)]
                .charred = distance[static_cast<std::size_t>(row * grid.columns + column)];
        }
    }
    const auto smooth = [&](double x, double z) {
        const auto column = static_cast<Index>(x / kCell), row = static_cast<Index>(z / kCell);
        return smooth_fields(fields, row, column, static_cast<float>(x / kCell - column),
                             static_cast<float>(z / kCell - row))
            .charred;
    };
    const auto bilinear = [&](double x, double z) {
        const auto column = static_cast<Index>(x / kCell), row = static_cast<Index>(z / kCell);
        const double s = x / kCell - column, t = z / kCell - row;
        const auto at = [&](Index r, Index c) {
            return static_cast<double>(progress[static_cast<std::size_t>(r * grid.columns + c)]);
        };
        return (1 - t) * ((1 - s) * at(row, column) + s * at(row, column + 1)) +
               t * ((1 - s) * at(row + 1, column) + s * at(row + 1, column + 1));
    };
    const double shown = lattice_amplitude(kCell, smooth);  // [mm]
    const double replaced = lattice_amplitude(kCell, bilinear);
    EXPECT_LT(shown, 0.03);
    EXPECT_GT(replaced, 0.15);
}

}  // namespace
}  // namespace ember
