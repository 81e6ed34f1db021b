// What the renderer draws of a staged world.
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

}  // namespace
}  // namespace ember
