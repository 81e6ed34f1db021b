// What the renderer draws, and that it draws nothing else, on a staged world.
#include <glad/gl.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cmath>

#include "render/image_difference.h"
#include "render/lighting.h"
#include "support/gl_rig.h"
#include "support/node_pixels.h"

namespace ember {
namespace {

using test::GlRig;
using test::in_mode;
using test::NodePixel;
using test::StagedWorld;

constexpr ViewMode kModes[] = {ViewMode::Beauty,   ViewMode::Lattice, ViewMode::Temperature,
                               ViewMode::Mass,     ViewMode::State,   ViewMode::Stress,
                               ViewMode::Stiffness};

std::vector<std::vector<SpringSegment>> edges_of(const StagedWorld& staged) {
    std::vector<SpringSegment> springs;
    for (const Quad& q : staged.quads) {
        springs.push_back({q[0], q[1], SpringKind::Structural});
        springs.push_back({q[0], q[3], SpringKind::Structural});
        springs.push_back({q[0], q[2], SpringKind::Diagonal});
    }
    return {springs};
}

TEST(Passes, APassWithNothingToDrawIsNotRun) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().sheets, 1);
    EXPECT_EQ(rig.renderer.counters().fire, 0) << "no particles";

    for (int i = 0; i < 40; ++i)
        staged.add_particle({0, 0.3, 0}, test::kFlame);
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty, false));
    (void)rig.draw(staged.view(), in_mode(ViewMode::State));
    EXPECT_EQ(rig.renderer.counters().fire, 0) << "flames off, or no picture";
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().fire, 1);

    const int sheets = rig.renderer.counters().sheets;
    (void)rig.draw(staged.view(), in_mode(ViewMode::Lattice));
    EXPECT_EQ(rig.renderer.counters().lattice, 0) << "no springs";
    EXPECT_EQ(rig.renderer.counters().sheets, sheets) << "springs instead of paper";
    staged.quads.clear();
    staged.topology_version = 2;
    (void)rig.draw(staged.view(), in_mode(ViewMode::Beauty));
    EXPECT_EQ(rig.renderer.counters().sheets, sheets) << "no quads";
    EXPECT_EQ(rig.renderer.counters().frames, 6);
}

TEST(Passes, ColdPaperDoesNotBloomAndPaperOutsideThePictureIsNotDrawn) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().bloom, 0);
    staged.temperature[3] = 1000;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().bloom, 1);
    RenderParams away;
    away.camera.target_x = 8;
    const int sheets = rig.renderer.counters().sheets;
    for (int i = 0; i < 40; ++i)
        staged.add_particle({0, 0.3, 0}, test::kFlame);
    (void)rig.draw(staged.view(), away);
    EXPECT_EQ(rig.renderer.counters().sheets, sheets);
    EXPECT_EQ(rig.renderer.counters().fire, 0);
}

TEST(Passes, WhatHasNotChangedIsNotUploadedAgain) {
    GlRig rig;
    StagedWorld staged = test::burning_sheet(8, 12, 300);
    (void)rig.draw(staged.view(), {});
    const int first = rig.renderer.counters().uploads;
    EXPECT_EQ(first, 3) << "triangles, vertices and sprites";
    RenderParams brighter;
    brighter.look.exposure = 2;
    (void)rig.draw(staged.view(), brighter);
    EXPECT_EQ(rig.renderer.counters().uploads, first);
    staged.x[5] += 0.001;  // in the same tick
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 1);
    for (int i = 0; i < 300; ++i)
        staged.fire_x[static_cast<std::size_t>(i)] += 0.001;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 2);
    staged.topology_version = 2;
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(rig.renderer.counters().uploads, first + 3);
}

TEST(Passes, EachTellsTheObserverWhenItIsDone) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(8, 12, 300);
    std::vector<std::string> passes;
    rig.renderer.observe_passes([&](std::string_view pass) { passes.emplace_back(pass); });
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(passes, (std::vector<std::string>{"vertices", "shadow", "background", "sheets",
                                                "resolve", "fire", "bloom", "film"}));
    rig.renderer.observe_passes({});
    (void)rig.draw(staged.view(), {});
    EXPECT_EQ(passes.size(), 8u);
}

TEST(Renderer, PreviewKeepsTheLook) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(16, 24, 400);
    RenderParams params;
    const Image full = rig.draw(staged.view(), params);
    params.look.quality = Quality::Preview;
    const Image preview = rig.draw(staged.view(), params);
    double difference = 0;
    for (std::size_t i = 0; i < full.rgba.size(); ++i)
        difference += std::abs(full.rgba[i] - preview.rgba[i]);
    EXPECT_GT(difference, 0);
    EXPECT_LT(difference / static_cast<double>(full.rgba.size()), 3.0) << "of 255, on average";
}

TEST(Renderer, DrawsTheSameBitsAgainAndInANewContext) {
    const StagedWorld staged = test::burning_sheet(16, 24, 300);
    Image first;
    {
        GlRig rig;
        first = rig.draw(staged.view(), {});
        EXPECT_TRUE(compare(first, rig.draw(staged.view(), {})).identical());
        // other sizes and views in between leave no trace; odd sizes have half and quarter buffers
        (void)rig.draw(staged.view(), {}, 161, 97);
        (void)rig.draw(staged.view(), in_mode(ViewMode::Mass), 400, 100);
        EXPECT_TRUE(compare(first, rig.draw(staged.view(), {})).identical());
    }
    GlRig fresh;
    EXPECT_TRUE(compare(first, fresh.draw(staged.view(), {})).identical());
}

TEST(Renderer, RaisesNoGlErrorInAnyMode) {
    GlRig rig;
    StagedWorld staged = test::burning_sheet(16, 24, 300);
    staged.lighter_lit = true;
    const WorldView world = staged.view();
    const auto springs = edges_of(staged);
    for (const ViewMode mode : kModes) {
        (void)rig.renderer.draw_image({&world, springs}, in_mode(mode), 161, 97);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << static_cast<int>(mode);
    }
}

TEST(DebugOutput, AMistakeMakesTheTestFail) {
    EXPECT_NONFATAL_FAILURE(
        {
            GlRig rig;
            ASSERT_NE(GLAD_GL_KHR_debug, 0);
            glEnable(0xFFFF);
            static_cast<void>(glGetError());
        },
        "OpenGL says: GL_INVALID_ENUM");
}

TEST(Renderer, ACutIsDrawnAlthoughTheIndicesOfTheWholeSheetWereUploaded) {
    StagedWorld staged = test::hanging_sheet(8, 12);
    GlRig used;
    const Image whole = used.draw(staged.view(), in_mode(ViewMode::State));
    staged.quads.erase(staged.quads.begin() + 30, staged.quads.begin() + 40);
    staged.topology_version = 2;
    const Image cut = used.draw(staged.view(), in_mode(ViewMode::State));
    GlRig fresh;
    EXPECT_GT(compare(whole, cut).pixels, 100);
    EXPECT_TRUE(compare(cut, fresh.draw(staged.view(), in_mode(ViewMode::State))).identical());
}

TEST(Renderer, TheSheetIsLitOnBothFacesAndWarmWhite) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(16, 24);
    for (const double azimuth : {0.0, 3.141592653589793}) {
        RenderParams params;
        params.camera.azimuth = azimuth;
        const Image image = rig.draw(staged.view(), params);
        const Colour c = test::linear_colour(image, 160, 90);
        EXPECT_GT(c.minCoeff(), 0.15f) << azimuth;
        EXPECT_GE(c.x(), c.z()) << azimuth;
    }
}

TEST(Renderer, TheGroundCanBeLeftOut) {
    GlRig rig;
    RenderParams params;
    params.camera.elevation = 0.6;
    params.view.ground = false;
    StagedWorld staged = test::hanging_sheet(4, 6);
    const Image without = rig.draw(staged.view(), params);
    params.view.ground = true;
    EXPECT_GT(compare(rig.draw(staged.view(), params), without).pixels, 1000);
    staged.ground = false;  // a world without a floor
    EXPECT_TRUE(compare(rig.draw(staged.view(), params), without).identical());
}

TEST(Renderer, PaperThrowsAShadowOnTheGround) {
    GlRig rig;
    RenderParams params = in_mode(ViewMode::Beauty);
    params.camera.elevation = 1.2;
    StagedWorld staged = test::hanging_sheet(9, 13);
    const Image shadowed = rig.draw(staged.view(), params);
    EXPECT_EQ(rig.renderer.counters().shadow, 1);
    // where the lamp's ray through the middle of the sheet meets the ground
    const Eigen::Vector3f lamp = lighting_of(LightingPreset::Studio).key_direction;
    const Eigen::Vector3f middle(0, 0.3f, 0);
    const Eigen::Vector3f below = middle - lamp * (middle.y() / lamp.y());
    const Eigen::Vector3f seen = project(make_camera(params.camera, 320, 180), below, 320, 180);
    const auto light_there = [&](const Image& image) {
        return test::linear_colour(image, int(seen.x()), int(seen.y())).sum();
    };
    staged.quads.clear();
    staged.topology_version = 2;
    const Image open = rig.draw(staged.view(), params);
    EXPECT_EQ(rig.renderer.counters().shadow, 1) << "no paper, no shadow";
    EXPECT_LT(light_there(shadowed), 0.75f * light_there(open));
}

TEST(Renderer, AtNightOnlyTheFireLights) {
    GlRig rig;
    RenderParams params = in_mode(ViewMode::Beauty);
    params.look.lighting = LightingPreset::Night;
    const StagedWorld dark = test::hanging_sheet(16, 24), lit = test::burning_sheet(16, 24, 400);
    EXPECT_LT(test::linear_colour(rig.draw(dark.view(), params), 160, 90).maxCoeff(), 0.08f);
    const Colour fire = test::linear_colour(rig.draw(lit.view(), params), 160, 90);
    EXPECT_GT(fire.x(), 2 * fire.z());
}

TEST(Renderer, ALitLighterIsSeen) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    const Image dark = rig.draw(staged.view(), {});
    staged.lighter_lit = true;
    EXPECT_GT(compare(rig.draw(staged.view(), {}), dark).pixels, 20);
}

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
