// Flames are where the fire is.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "render/image_difference.h"
#include "support/gl_rig.h"
#include "support/node_pixels.h"

namespace ember {
namespace {

using test::GlRig;
using test::StagedWorld;

constexpr int kWidth = 480, kHeight = 270;

// Pixels that flames make visibly brighter, with the light that they throw turned off.
std::vector<Eigen::Vector2i> flame_pixels(GlRig& rig, const WorldView& world) {
    RenderParams params;
    params.look.flame_light = 0;
    params.look.sparks = params.look.smoke = 0;  // these fly wherever they like, and are no flames
    const Image with = rig.draw(world, params, kWidth, kHeight);
    params.view.flames = false;
    const Image without = rig.draw(world, params, kWidth, kHeight);
    std::vector<Eigen::Vector2i> pixels;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const Colour more =
                test::linear_colour(with, x, y) - test::linear_colour(without, x, y);
            if (more.x() > 0.05f) pixels.emplace_back(x, y);
        }
    }
    return pixels;
}

// Share of `pixels` within a sprite's reach of the place where a particle is seen; `mirrored`: of
// where it would be seen if the picture were mirrored.
double share_near_particles(const std::vector<Eigen::Vector2i>& pixels, const WorldView& world,
                            bool mirrored) {
    const RenderParams params;
    const Camera camera = make_camera(params.camera, kWidth, kHeight);
    // a sprite stretched by flight, and the glow around it
    const double reach = 1.5 * params.look.flame_size;
    int near = 0;
    for (const Eigen::Vector2i& pixel : pixels) {
        bool found = false;
        for (std::size_t i = 0; i < world.particles.x.size() && !found; ++i) {
            const Eigen::Vector3f place =
                Eigen::Vector3d(world.particles.x[i], world.particles.y[i], world.particles.z[i])
                    .cast<float>();
            Eigen::Vector3f seen = project(camera, place, kWidth, kHeight);
            if (mirrored) seen.x() = kWidth - seen.x();
            const float distance = -(camera.view * place.homogeneous()).z();
            const double pixels_per_metre =
                kHeight / (2.0 * static_cast<double>(camera.tan_half_fov * distance));
            const float away = (seen.head<2>() - pixel.cast<float>()).norm();
            found = static_cast<double>(away) < reach * pixels_per_metre;
        }
        near += found ? 1 : 0;
    }
    return static_cast<double>(near) / static_cast<double>(pixels.size());
}

TEST(Fire, FlamePixelsLieNearLiveParticles) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(32, 48, 400);
    const WorldView world = staged.view();
    const auto pixels = flame_pixels(rig, world);
    ASSERT_GT(pixels.size(), 500u);
    EXPECT_GE(share_near_particles(pixels, world, false), 0.99);
    EXPECT_LT(share_near_particles(pixels, world, true), 0.9);
}

TEST(Fire, ACloudOfHotParticlesIsBrightAndOfColdOnesIsNot) {
    GlRig rig;
    const auto brightest = [&](double kelvin) {
        StagedWorld staged = test::hanging_sheet(4, 6);
        for (int i = 0; i < 80; ++i)
            staged.add_particle({0.14 + 0.00025 * i, 0.35, 0}, kelvin);
        const auto pixels = flame_pixels(rig, staged.view());
        return pixels.size();
    };
    EXPECT_GT(brightest(test::kFlame), 100u);
    EXPECT_EQ(brightest(test::kAmbient + 20), 0u);
}

TEST(Fire, FlamesBehindTheSheetAreHiddenByIt) {
    GlRig rig;
    RenderParams params;
    const auto brightened = [&](double z) {
        StagedWorld staged = test::hanging_sheet(4, 6);
        for (int i = 0; i < 160; ++i)  // few of them are drawn as flames
            staged.add_particle({0.000125 * i, 0.30, z}, test::kFlame);
        return flame_pixels(rig, staged.view()).size();
    };
    EXPECT_GT(brightened(0.05), 100u);
    EXPECT_EQ(brightened(-0.05), 0u);
}

TEST(Fire, FlamesLightThePaperNextToThem) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(16, 24);
    for (int i = 0; i < 400; ++i)
        staged.add_particle({0.16, 0.30, 0.05 + 0.0001 * i}, test::kFlame);
    RenderParams params;
    const Image lit = rig.draw(staged.view(), params, kWidth, kHeight);
    params.look.flame_light = 0;
    const Image unlit = rig.draw(staged.view(), params, kWidth, kHeight);
    const int x = kWidth / 2, y = kHeight / 2;  // paper, away from every sprite
    const Colour more = test::linear_colour(lit, x, y) - test::linear_colour(unlit, x, y);
    EXPECT_GT(more.x(), 0.002f);
    EXPECT_GT(more.x(), more.z());
}

// A printed sheet seen through gas that is not itself seen.
RenderParams through_clear_gas(double haze) {
    RenderParams params;
    params.camera.azimuth = params.camera.elevation = 0;
    params.look.flame_light = params.look.flame_brightness = params.look.smoke = 0;
    params.look.haze = haze;
    Image stripes{256, 4, {}};
    for (int i = 0; i < 256 * 4; ++i) {
        const auto ink = static_cast<std::uint8_t>(i / 4 % 2 == 0 ? 0 : 255);
        stripes.rgba.insert(stripes.rgba.end(), {ink, ink, ink, 255});
    }
    params.printed.front = std::make_shared<const PictureFile>(
        PictureFile{"stripes", 256, 4, std::move(stripes.rgba)});
    return params;
}

TEST(Fire, HotGasBendsWhatIsSeenThroughItAndNothingElse) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(16, 24);
    const auto draw = [&](double haze) {
        return rig.draw(staged.view(), through_clear_gas(haze), 960, 540);
    };
    EXPECT_TRUE(compare(draw(0), draw(3)).identical()) << "no gas";
    for (int i = 0; i < 400; ++i)
        staged.add_particle({0.00005 * i, 0.30, 0.05}, test::kFlame);
    const Image straight = draw(0), bent = draw(3);
    double sum = 0, change = 0;
    int near = 0, far = 0;
    for (int y = 0; y < 540; ++y) {
        for (int x = 0; x < 960; ++x) {
            const float more = test::luminance(test::linear_colour(bent, x, y)) -
                               test::luminance(test::linear_colour(straight, x, y));
            sum += static_cast<double>(more);
            change += static_cast<double>(std::abs(more));
            if (std::abs(more) < 0.02f) continue;
            const bool in_reach = std::abs(x - 480) < 150 && std::abs(y - 270) < 200;
            ++(in_reach ? near : far);
        }
    }
    EXPECT_GT(near, 500);
    EXPECT_EQ(far, 0);
    EXPECT_LT(std::abs(sum), 0.1 * change) << "light is moved, not made";
}

}  // namespace
}  // namespace ember
