// From views to vertices, without GL.
#include <gtest/gtest.h>

#include <cmath>

#include "render/palette.h"
#include "render/sheet_vertices.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

std::vector<SheetVertex> pack(const StagedWorld& staged) {
    const WorldView view = staged.view();
    std::vector<SheetVertex> vertices;
    append_vertices(view.sheets[0], view, vertices);
    return vertices;
}

Eigen::Vector3f normal(const SheetVertex& v) {
    return {v.nx, v.ny, v.nz};
}

TEST(SheetVertices, PlaceOnTheSheetIsTheUnburntLatticeInMillimetres) {
    StagedWorld staged = test::hanging_sheet(5, 9);
    for (double& x : staged.x)
        x *= 0.5;  // shrinking moves nodes, not the print on them
    const auto vertices = pack(staged);
    ASSERT_EQ(vertices.size(), 45u);
    EXPECT_FLOAT_EQ(vertices[0].u, 0);
    EXPECT_FLOAT_EQ(vertices[0].v, 0);
    EXPECT_FLOAT_EQ(vertices[staged.node(0, 8)].u, 297);
    EXPECT_FLOAT_EQ(vertices[staged.node(4, 0)].v, 210);
    EXPECT_FLOAT_EQ(vertices[staged.node(1, 2)].u, 297.0f / 4);
    EXPECT_FLOAT_EQ(vertices[staged.node(1, 2)].v, 210.0f / 4);
    EXPECT_FLOAT_EQ(vertices[staged.node(1, 2)].x, static_cast<float>(staged.x[11]));
}

TEST(SheetVertices, ATubeHasOneMoreCellAcrossThanASheet) {
    const StagedWorld staged = test::hanging_sheet(5, 9);
    WorldView view = staged.view();
    view.sheets[0].closed = true;
    std::vector<SheetVertex> vertices;
    append_vertices(view.sheets[0], view, vertices);
    EXPECT_FLOAT_EQ(vertices[staged.node(4, 0)].v, 210.0f * 4 / 5);
}

TEST(SheetVertices, NormalsOfAFlatSheetAreAllTheSame) {
    for (const SheetVertex& v : pack(test::hanging_sheet(4, 6))) {
        EXPECT_NEAR(std::abs(v.nz), 1, 1e-6);
        EXPECT_EQ(std::signbit(v.nz), std::signbit(pack(test::hanging_sheet(4, 6))[0].nz));
    }
}

TEST(SheetVertices, NormalsOfABentSheetAreThoseOfTheSurface) {
    StagedWorld staged = test::hanging_sheet(61, 3);
    constexpr double kRadius = 0.1;
    for (std::size_t n = 0; n < staged.x.size(); ++n) {
        const double angle = staged.x[n] / kRadius;
        staged.x[n] = kRadius * std::sin(angle);
        staged.z[n] = kRadius * std::cos(angle);
    }
    const auto vertices = pack(staged);
    for (int row = 1; row < 60; ++row) {
        const std::size_t n = staged.node(row, 1);
        const Eigen::Vector3f outwards(static_cast<float>(staged.x[n] / kRadius), 0,
                                       static_cast<float>(staged.z[n] / kRadius));
        EXPECT_GT(std::abs(normal(vertices[n]).dot(outwards)), 0.99999f);
    }
}

// Two quads that share an edge of two nodes are cut apart and one is folded up.
TEST(SheetVertices, CopiesOfACutNodeHaveNormalsOfTheirOwn) {
    StagedWorld staged = test::hanging_sheet(3, 2);
    const auto before = pack(staged);
    for (const Index original : {2, 3}) {
        const auto n = static_cast<std::size_t>(original);
        for (auto* array : {&staged.x, &staged.y, &staged.z, &staged.rest, &staged.temperature,
                            &staged.mass, &staged.initial_mass, &staged.burnout_time}) {
            array->push_back((*array)[n]);
        }
        staged.phase.push_back(staged.phase[n]);
        staged.site.push_back(original);
    }
    staged.quads[1] = {6, 7, 5, 4};
    for (const std::size_t folded : {4u, 5u}) {
        staged.z[folded] = staged.x[folded];
        staged.x[folded] = 0;
    }
    const auto after = pack(staged);
    ASSERT_EQ(after.size(), 8u);
    EXPECT_EQ(normal(after[2]), normal(before[2]));
    EXPECT_NEAR(normal(after[2]).dot(normal(after[6])), 0, 1e-5);
    EXPECT_FLOAT_EQ(after[6].u, after[2].u);
    EXPECT_FLOAT_EQ(after[6].v, after[2].v);
}

TEST(SheetVertices, ANodeWithoutQuadsStillHasAUnitNormal) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    staged.quads.clear();
    for (const SheetVertex& v : pack(staged))
        EXPECT_FLOAT_EQ(normal(v).norm(), 1.0f);
}

TEST(SheetVertices, StateIsProgressCelsiusMassLeftAndPhase) {
    StagedWorld staged = test::hanging_sheet(2, 3);
    staged.temperature = {293.15, 700, 1100, 1000, 400, 300};
    staged.phase = {Phase::Unburnt, Phase::Unburnt,  Phase::Burning,
                    Phase::Burning, Phase::BurntOut, Phase::BurntOut};
    staged.mass = {3e-6, 3e-6, 3e-6, 1.8e-6, 0.6e-6, 0.6e-6};
    staged.burnout_time[4] = staged.time;
    staged.burnout_time[5] = staged.time - kAshTime;
    const auto v = pack(staged);
    const double expected[] = {0, (700 - 393.15) / (test::kIgnition - 393.15), 1, 1.5, 2, 3};
    for (std::size_t n = 0; n < 6; ++n) {
        EXPECT_NEAR(v[n].progress, expected[n], 1e-6) << n;
        EXPECT_NEAR(v[n].temperature, staged.temperature[n] - 273.15, 1e-4);
        EXPECT_NEAR(v[n].mass, staged.mass[n] / 3e-6, 1e-6);
        EXPECT_EQ(v[n].phase, static_cast<float>(staged.phase[n]));
    }
}

TEST(SheetTriangles, CoverEveryQuadOnceWithOneSense) {
    const StagedWorld staged = test::hanging_sheet(4, 5);
    const WorldView view = staged.view();
    std::vector<std::uint32_t> indices;
    append_triangles(view.sheets[0], 1000, indices);
    ASSERT_EQ(indices.size(), 6 * staged.quads.size());
    double area = 0;
    for (std::size_t i = 0; i < indices.size(); i += 3) {
        const auto at = [&](std::size_t corner) {
            const std::size_t n = indices[i + corner] - 1000u;
            return Eigen::Vector2d(staged.x[n], staged.y[n]);
        };
        const Eigen::Vector2d a = at(1) - at(0), b = at(2) - at(0);
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    EXPECT_NEAR(std::abs(area), 0.210 * 0.297, 1e-9);
}

TEST(SheetVertices, ASecondSheetIsAppended) {
    const StagedWorld staged = test::burning_sheet(4, 5, 0);
    const WorldView view = staged.view();
    std::vector<SheetVertex> vertices;
    append_vertices(view.sheets[0], view, vertices);
    append_vertices(view.sheets[0], view, vertices);
    ASSERT_EQ(vertices.size(), 40u);
    EXPECT_EQ(vertices[7].x, vertices[27].x);
    EXPECT_EQ(vertices[7].progress, vertices[27].progress);
}

}  // namespace
}  // namespace ember
