// Views of quantities and of the lattice have the colours that their legends say.
#include <gtest/gtest.h>

#include <cmath>

#include "support/gl_rig.h"
#include "support/node_pixels.h"

namespace ember {
namespace {

using test::GlRig;
using test::in_mode;
using test::NodePixel;
using test::StagedWorld;

// In a quantity's view every visible node has the colour that its map gives the quantity, and has
// not when the two maps are exchanged.
TEST(ColourMappedViews, NodesHaveTheColourOfTheirQuantity) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(32, 48, 0);
    constexpr int kWidth = 960, kHeight = 540;
    const RenderParams params;
    const WorldView world = staged.view();
    const auto nodes =
        test::visible_nodes(world, make_camera(params.camera, kWidth, kHeight), kWidth, kHeight);
    ASSERT_GT(nodes.size(), 1000u);
    const auto fitting = [&](ViewMode mode, Colour (*map)(double), const auto& quantity) {
        const Image image = rig.draw(world, in_mode(mode), kWidth, kHeight);
        return share(
            nodes, [](std::size_t) { return true; },
            [&](const NodePixel& n) {
                const Colour seen = test::linear_colour(image, n.x, n.y);
                return test::distance_from_shaded(seen, map(quantity(n.node))) < 0.15f;
            });
    };
    const auto heat = [&](std::size_t n) { return (staged.temperature[n] - 273.15) / 1100.0; };
    const auto mass = [&](std::size_t n) { return staged.mass[n] / staged.initial_mass[n]; };
    EXPECT_GE(fitting(ViewMode::Temperature, heat_map, heat), 0.9);
    EXPECT_GE(fitting(ViewMode::Mass, mass_map, mass), 0.9);
    EXPECT_LT(fitting(ViewMode::Temperature, mass_map, heat), 0.5);
    EXPECT_LT(fitting(ViewMode::Mass, heat_map, mass), 0.5);
}

// Stress that rises from column to column, over a scale of ±2 kPa.
TEST(ColourMappedViews, NodesHaveTheMeanStressOfTheirStructuralSprings) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(9, 13);
    std::vector<std::vector<SpringSegment>> springs(1);
    for (Index row = 0; row < 9; ++row) {
        for (Index column = 0; column + 1 < 13; ++column) {
            const Index n = row * 13 + column;
            springs[0].push_back({n, n + 1, SpringKind::Structural, 1.0, 300.0 * (column - 5.5)});
            springs[0].push_back({n, n + 1, SpringKind::Bending, 1.0, 1e9});
        }
    }
    RenderParams params = in_mode(ViewMode::Stress);
    params.camera.azimuth = params.camera.elevation = 0;
    params.view.stress_range = 2e3;
    const WorldView world = staged.view();
    const Image image = rig.renderer.draw_image({&world, springs}, params, 960, 540);
    const Camera camera = make_camera(params.camera, 960, 540);
    for (int column = 1; column < 12; ++column) {
        const std::size_t n = staged.node(4, column);
        const Eigen::Vector3f place(static_cast<float>(staged.x[n]),
                                    static_cast<float>(staged.y[n]), 0.0f);
        const Eigen::Vector3f p = project(camera, place, 960, 540);
        const Colour seen = test::linear_colour(image, int(p.x()), int(p.y()));
        const Colour expected = stress_map(0.5 + 300.0 * (column - 6) / 4e3);
        EXPECT_LT(test::distance_from_shaded(seen, expected), 0.08f) << column;
    }
}

TEST(LatticeView, SpringsHaveTheColourOfTheirKind) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(2, 2);
    RenderParams params = in_mode(ViewMode::Lattice);
    params.camera.azimuth = params.camera.elevation = 0;
    const WorldView world = staged.view();
    const Camera camera = make_camera(params.camera, 960, 540);
    // the colour half-way along a spring between two nodes, of the brightest pixel of three by
    // three
    const auto colour = [&](const SpringSegment& spring) {
        const std::vector<std::vector<SpringSegment>> springs{{spring}};
        const Image image = rig.renderer.draw_image({&world, springs}, params, 960, 540);
        const auto place = [&](Index node) {
            const auto n = static_cast<std::size_t>(node);
            return Eigen::Vector3d(staged.x[n], staged.y[n], staged.z[n]).cast<float>().eval();
        };
        const Eigen::Vector3f middle =
            project(camera, 0.5f * (place(spring.a) + place(spring.b)), 960, 540);
        Colour brightest = Colour::Zero();
        for (int i = 0; i < 9; ++i) {
            const Colour c = test::linear_colour(image, int(middle.x()) + i % 3 - 1,
                                                 int(middle.y()) + i / 3 - 1);
            if (c.sum() > brightest.sum()) brightest = c;
        }
        return brightest;
    };
    const Colour along = colour({0, 1, SpringKind::Structural});
    const Colour across = colour({0, 2, SpringKind::Structural});
    const Colour diagonal = colour({0, 3, SpringKind::Diagonal});
    const Colour bending = colour({0, 1, SpringKind::Bending});
    EXPECT_GT(along.z(), 2 * along.x()) << "blue";
    EXPECT_GT(across.x(), 1.5f * across.z()) << "pink";
    EXPECT_GT(across.z(), 1.5f * across.y()) << "pink";
    EXPECT_GT(diagonal.y(), 3 * diagonal.z()) << "yellow";
    EXPECT_LT(bending.maxCoeff(), 1.6f * bending.minCoeff()) << "grey";

    staged.phase.assign(4, Phase::BurntOut);
    EXPECT_LT(colour({0, 1, SpringKind::Structural}).z(), 0.6f * along.z()) << "dimmed";
}

}  // namespace
}  // namespace ember
