// From views to vertices, without GL.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "render/sheet_vertices.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using Eigen::Vector3f;
using test::StagedWorld;

std::vector<SheetVertex> pack(const StagedWorld& staged, int level = 1) {
    const WorldView view = staged.view();
    std::vector<SheetVertex> vertices;
    append_vertices(view.sheets[0], view, level, {}, vertices);
    return vertices;
}

std::vector<SheetPoint> points(const WorldView& view, int level = 1) {
    std::vector<SheetPoint> all;
    append_points(view.sheets[0], 0, level, all);
    return all;
}

Vector3f place(const SheetVertex& v) {
    return {v.x, v.y, v.z};
}
Vector3f normal(const SheetVertex& v) {
    return {v.nx, v.ny, v.nz};
}

StagedWorld cylinder(int rows, double radius) {
    StagedWorld staged = test::hanging_sheet(rows, 4);
    for (std::size_t n = 0; n < staged.x.size(); ++n) {
        const double angle = staged.x[n] / radius;
        staged.x[n] = radius * std::sin(angle);
        staged.z[n] = radius * std::cos(angle);
    }
    return staged;
}

TEST(SheetShells, ThinPaperIsOneAndThickPaperHasNoGapsOfMoreThanAPixel) {
    EXPECT_EQ(shell_count(0), 1);
    EXPECT_EQ(shell_count(1.4), 1);
    for (double pixels = 1.5; pixels <= 15; pixels += 0.25)
        EXPECT_LE(pixels / (shell_count(pixels) - 1), 1.0) << pixels;
    EXPECT_EQ(shell_count(1e9), 16);
}

TEST(SheetPoints, PlaceOnTheSheetIsInMillimetresOfTheUnburntSheet) {
    const StagedWorld staged = test::hanging_sheet(5, 9);
    const auto p = points(staged.view());
    ASSERT_EQ(p.size(), 4 * staged.quads.size());
    EXPECT_FLOAT_EQ(p[0].u, 0);
    EXPECT_FLOAT_EQ(p[0].v, 0);
    EXPECT_FLOAT_EQ(p[1].u, 297.0f / 8);
    EXPECT_FLOAT_EQ(p[2].v, 210.0f / 4);
    EXPECT_FLOAT_EQ(p.back().u, 297);
    EXPECT_FLOAT_EQ(p.back().v, 210);
    EXPECT_FLOAT_EQ(p.back().right, 1);
    EXPECT_FLOAT_EQ(p.back().down, 1);
}

TEST(SheetPoints, ATubeHasOneMoreCellAcrossThanASheet) {
    const StagedWorld staged = test::hanging_sheet(5, 9);
    WorldView view = staged.view();
    view.sheets[0].closed = true;
    EXPECT_FLOAT_EQ(points(view).back().v, 210.0f * 4 / 5);
}

// A cut along one edge inside a sheet of 3 × 2 cells: both quads get nodes of their own there.
TEST(SheetPoints, SidesInsideTheSheetWithoutTheirNeighbourAreTornAndOthersBorder) {
    StagedWorld staged = test::hanging_sheet(4, 3);
    const unsigned top = kBorderSide, right = kBorderSide << 1, bottom = kBorderSide << 2,
                   left = kBorderSide << 3;
    const auto whole = points(staged.view());
    const unsigned borders[] = {top | left, top | right,   left,
                                right,      bottom | left, bottom | right};
    for (std::size_t i = 0; i < whole.size(); ++i)
        EXPECT_EQ(static_cast<unsigned>(whole[i].edges), borders[i / 4]) << i;
    staged.quads.erase(staged.quads.begin() + 2);  // row 1, column 0
    const auto p = points(staged.view());
    const auto torn = [&](std::size_t quad) {
        return static_cast<unsigned>(p[4 * quad].edges) % kBorderSide;
    };
    EXPECT_EQ(torn(0), kTornSide << 2) << "row 0, column 0";
    EXPECT_EQ(torn(1), kTornCorner << 3) << "row 0, column 1 touches the hole with a corner";
    EXPECT_EQ(torn(2), kTornSide << 3) << "row 1, column 1";
    EXPECT_EQ(torn(3), kTornSide << 0) << "row 2, column 0";
}

TEST(SheetVertices, APatchKeepsItsNodesAndSharesItsSidesWithItsNeighbours) {
    const StagedWorld staged = cylinder(9, 0.05);
    constexpr int kLevel = 4, kSide = kLevel + 1;
    const auto v = pack(staged, kLevel);
    ASSERT_EQ(v.size(), kSide * kSide * staged.quads.size());
    EXPECT_FLOAT_EQ(v[0].x, static_cast<float>(staged.x[0]));
    EXPECT_FLOAT_EQ(v[kSide * kSide - 1].x, static_cast<float>(staged.x[staged.node(1, 1)]));
    for (int i = 0; i < kSide; ++i) {  // row 0, columns 0 and 1
        const std::size_t right = static_cast<std::size_t>(i * kSide + kLevel);
        const std::size_t left = static_cast<std::size_t>(kSide * kSide + i * kSide);
        EXPECT_NEAR((place(v[right]) - place(v[left])).norm(), 0, 1e-7);
    }
}

// A chord of this lattice is up to 0.76 mm inside of the cylinder, a patch 0.02 mm.
TEST(SheetVertices, APatchFollowsTheCurveThatItsNodesLieOn) {
    constexpr double kRadius = 0.05;
    for (const SheetVertex& v : pack(cylinder(13, kRadius), 4)) {
        if (std::abs(std::atan2(v.x, v.z)) > 1.7f) continue;  // one-sided normals at the border
        EXPECT_NEAR(std::hypot(v.x, v.z), kRadius, 2e-5);
    }
}

TEST(SheetVertices, NormalsOfABentSheetAreThoseOfTheSurface) {
    for (const SheetVertex& v : pack(cylinder(61, 0.1))) {
        if (std::abs(std::atan2(v.x, v.z)) > 1.0f) continue;
        const Vector3f outwards = Vector3f(v.x, 0, v.z).normalized();
        EXPECT_GT(std::abs(normal(v).dot(outwards)), 0.99999f);
    }
}

TEST(SheetVertices, NormalsOfAFlatSheetFaceTheViewer) {
    for (const SheetVertex& v : pack(test::hanging_sheet(4, 6), 2))
        EXPECT_NEAR(v.nz, 1, 1e-6);
}

TEST(SheetVertices, QuantitiesAreThoseOfTheNodesAndLinearInBetween) {
    const StagedWorld staged = test::hanging_sheet(2, 2);
    const WorldView view = staged.view();
    const float values[] = {1, 2, 5, 8};
    std::vector<SheetVertex> v;
    append_vertices(view.sheets[0], view, 2, values, v);
    ASSERT_EQ(v.size(), 9u);
    EXPECT_FLOAT_EQ(v[0].quantity, 1);
    EXPECT_FLOAT_EQ(v[2].quantity, 2);
    EXPECT_FLOAT_EQ(v[6].quantity, 5);
    EXPECT_FLOAT_EQ(v[8].quantity, 8);
    EXPECT_FLOAT_EQ(v[4].quantity, 4);
}

TEST(SheetTriangles, CoverEveryQuadOnceWithOneSense) {
    const StagedWorld staged = test::hanging_sheet(4, 5);
    const auto v = pack(staged, 3);
    std::vector<std::uint32_t> indices;
    append_triangles(staged.quads.size(), 3, 1000, indices);
    ASSERT_EQ(indices.size(), 9 * 6 * staged.quads.size());
    double area = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) { return place(v[indices[i + corner] - 1000u]); };
        const double part = static_cast<double>((at(1) - at(0)).cross(at(2) - at(0)).z()) / 2;
        EXPECT_GT(part * area, -1e-12);
        area += part;
    }
    EXPECT_NEAR(std::abs(area), 0.210 * 0.297, 1e-6);
}

}  // namespace
}  // namespace ember
