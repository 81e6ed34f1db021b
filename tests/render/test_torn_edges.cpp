// Cracks are drawn along their curves: known positions, lips that fit.
#include "render/torn_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/sheet_vertices.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

constexpr double kStepX = 0.297 / 8, kStepZ = 0.210 / 8;

// A flat sheet of 9×9 nodes whose site `s` has a crack at (x, z) [m].
struct Torn {
    StagedWorld staged = test::hanging_sheet(9, 9);
    std::vector<double> x = std::vector<double>(81, 0.0), z = std::vector<double>(81, 0.0);

    [[nodiscard]] WorldView view() const {
        WorldView view = staged.view();
        view.sheets[0].crack_x = x;
        view.sheets[0].crack_z = z;
        return view;
    }
};

// One patch per quad of a single piece: its first vertex is the quad's first corner.
struct Drawn {
    std::vector<SheetVertex> vertices;
    std::vector<SheetPoint> points;
    explicit Drawn(const WorldView& view) {
        append_vertices(view.sheets[0], view, 1, {}, vertices);
        append_points(view.sheets[0], 0, 1, points);
    }
};

TEST(TornEdges, NothingMovesWithoutACrack) {
    const StagedWorld staged = test::hanging_sheet(9, 9);
    EXPECT_TRUE(torn_edge_shifts(staged.view().sheets[0]).empty());
    const Torn torn;
    const Drawn without(staged.view()), with(torn.view());
    for (std::size_t n = 0; n < without.points.size(); ++n) {
        EXPECT_EQ(without.vertices[n].x, with.vertices[n].x);
        EXPECT_EQ(without.points[n].u, with.points[n].u);
    }
}

TEST(TornEdges, AStaircaseIsDrawnAsTheLineThatItFollows) {
    // sites (2,2), (2,3), (3,3), (3,4) ... on both sides of a diagonal
    Torn torn;
    for (int i = 2; i < 6; ++i) {
        torn.x[torn.staged.node(i, i)] = 0.25 * kStepX;
        torn.z[torn.staged.node(i, i)] = -0.25 * kStepZ;
        torn.x[torn.staged.node(i, i + 1)] = -0.25 * kStepX;
        torn.z[torn.staged.node(i, i + 1)] = 0.25 * kStepZ;
    }
    const WorldView view = torn.view();
    const Drawn drawn(view);
    const auto number = [](float value) { return static_cast<double>(value); };
    int seen = 0;
    for (std::size_t q = 0; q < view.sheets[0].quads.size(); ++q) {
        const auto corner = static_cast<int>(view.sheets[0].quads[q][0]);
        const int row = corner / 9, column = corner % 9;
        if (row < 2 || row > 5 || (column != row && column != row + 1)) continue;
        ++seen;
        const SheetPoint& p = drawn.points[4 * q];
        EXPECT_NEAR(number(p.u) / (1e3 * kStepX) - number(p.v) / (1e3 * kStepZ), 0.5, 1e-5);
        // and so do the positions: the sheet is flat, x across it and y along
        const SheetVertex &v = drawn.vertices[4 * q], &origin = drawn.vertices[0];
        EXPECT_NEAR(
            number(std::abs(v.y - origin.y)) / kStepX - number(std::abs(v.x - origin.x)) / kStepZ,
            0.5, 1e-5);
    }
    EXPECT_EQ(seen, 8);
}

TEST(TornEdges, ShiftsAreAtMostHalfACellAndKeepTheOutline) {
    Torn torn;
    torn.x.assign(81, 1.0);
    torn.z.assign(81, -1.0);
    const WorldView view = torn.view();
    const auto shifts = torn_edge_shifts(view.sheets[0]);
    for (std::size_t n = 0; n < 81; ++n) {
        EXPECT_EQ(shifts[n][0], n % 9 == 0 || n % 9 == 8 ? 0.0 : 0.5 * kStepX);
        EXPECT_EQ(shifts[n][1], n / 9 == 0 || n / 9 == 8 ? 0.0 : -0.5 * kStepZ);
    }
}

TEST(TornEdges, BothLipsOfAClosedCrackCoincide) {
    Torn torn;
    StagedWorld& s = torn.staged;
    const auto site = s.node(4, 4);
    torn.x[site] = 0.3 * kStepX;
    torn.z[site] = 0.4 * kStepZ;
    // a copy of the node for the quads on one side
    WorldView view = torn.view();
    SheetView& sheet = view.sheets[0];
    std::vector<double> px(sheet.x.begin(), sheet.x.end()), py(sheet.y.begin(), sheet.y.end()),
        pz(sheet.z.begin(), sheet.z.end());
    std::vector<Index> sites(sheet.site.begin(), sheet.site.end());
    std::vector<Quad> quads(sheet.quads.begin(), sheet.quads.end());
    for (std::vector<double>* p : {&px, &py, &pz})
        p->push_back((*p)[site]);
    sites.push_back(static_cast<Index>(site));
    int moved = 0;
    for (Quad& q : quads) {
        if (q[0] == static_cast<Index>(site) || q[3] == static_cast<Index>(site)) {
            for (Index& n : q)
                n = n == static_cast<Index>(site) ? 81 : n;
            ++moved;
        }
    }
    ASSERT_EQ(moved, 2);
    sheet.x = px, sheet.y = py, sheet.z = pz, sheet.site = sites, sheet.quads = quads;
    const auto shifts = torn_edge_shifts(sheet);
    const auto positions = torn_positions(sheet, shifts);
    EXPECT_LT((positions[site] - positions[81]).norm(), 1e-12);
    const Vector3 before(px[site], py[site], pz[site]);
    EXPECT_NEAR((positions[81] - before).norm(),
                std::sqrt(0.09 * kStepX * kStepX + 0.16 * kStepZ * kStepZ), 1e-9);
}

// A sheet of rows × 17 nodes with paper in the cells that `keep` names.
template <class Keep>
StagedWorld cut_out(const Keep& keep, int rows = 17) {
    StagedWorld staged = test::hanging_sheet(rows, 17);
    std::erase_if(staged.quads, [&](const Quad& q) { return !keep(q[0] / 17, q[0] % 17); });
    return staged;
}

TEST(Outlines, ASheetOfWholeCellsKeepsItsBorder) {
    const StagedWorld staged = test::hanging_sheet(17, 17);
    EXPECT_TRUE(outline_shifts(staged.view().sheets[0]).empty());
    EXPECT_TRUE(edge_shifts(staged.view().sheets[0]).empty());
}

TEST(Outlines, AStaircaseBecomesTheLineThatItFollows) {
    // steps of one cell and of three
    for (const int run : {1, 3}) {
        const int rows = 16 * run + 1;
        const StagedWorld staged =
            cut_out([&](int row, int column) { return column >= row / run; }, rows);
        const auto shifts = outline_shifts(staged.view().sheets[0]);
        const double hx = 0.297 / 16, hz = 0.210 / (rows - 1);
        int corners = 0;
        for (int row = 6 * run; row <= 10 * run; ++row) {
            // the staircase's sites of this row, and how far the drawn ones are from a line
            for (const int column : {(row - 1) / run, row / run}) {
                const auto& shift = shifts[staged.node(row, column)];
                const double x = column + shift[0] / hx, z = row + shift[1] / hz;
                EXPECT_NEAR(x, z / run - 0.5, 0.08) << run << ' ' << row << ' ' << column;
                corners += std::abs(column - (1.0 * row / run - 0.5)) > 0.3;
            }
        }
        EXPECT_GT(corners, 4) << "the staircase itself is no line";
    }
}

TEST(Outlines, AHoleKeepsItsSizeAndTheBorderItsPlace) {
    const StagedWorld staged = cut_out([](int row, int column) {
        return (row - 8) * (row - 8) + (column - 8) * (column - 8) > 10;
    });
    const auto shifts = outline_shifts(staged.view().sheets[0]);
    const double hx = 0.297 / 16, hz = 0.210 / 16;
    double outwards = 0;
    int moved = 0;
    for (std::size_t n = 0; n < shifts.size(); ++n) {
        const int row = static_cast<int>(n) / 17, column = static_cast<int>(n) % 17;
        const double x = shifts[n][0] / hx, z = shifts[n][1] / hz;
        if (row == 0 || row == 16 || column == 0 || column == 16) {
            EXPECT_EQ(x * x + z * z, 0.0);
        }
        EXPECT_LE(std::max(std::abs(x), std::abs(z)), 0.5);
        if (x == 0 && z == 0) continue;
        ++moved;
        outwards += (x * (column - 8.5) + z * (row - 8.5)) / std::hypot(column - 8.5, row - 8.5);
    }
    EXPECT_GT(moved, 12);
    EXPECT_NEAR(outwards / moved, 0.0, 0.1) << "cells, on average";
}

}  // namespace
}  // namespace ember
