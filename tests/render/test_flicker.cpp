// Consecutive pictures of the burning corner: nothing may pop where no flame is.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/fire_sprites.h"
#include "support/burnt_corner.h"
#include "support/gl_rig.h"

namespace ember {
namespace {

constexpr int kWidth = 320, kHeight = 180, kBlock = 16;
constexpr int kAcross = kWidth / kBlock, kDown = (kHeight + kBlock - 1) / kBlock;
constexpr int kFrames = 120, kTicksPerFrame = 2;  // 30 pictures per second
constexpr std::uint64_t kFirstTick = 180;
constexpr double kMost = 12.0;  // of 255: second difference of a block's luma

template <class T>
using Blocks = std::array<T, std::size_t(kAcross* kDown)>;

Blocks<double> mean_luma(const Image& image) {
    Blocks<double> sum{}, count{};
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            const std::uint8_t* p = &image.rgba[4 * static_cast<std::size_t>(y * kWidth + x)];
            const auto block = static_cast<std::size_t>(y / kBlock * kAcross + x / kBlock);
            sum[block] += 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
            ++count[block];
        }
    }
    for (std::size_t b = 0; b < sum.size(); ++b)
        sum[b] /= count[b];
    return sum;
}

// Blocks that a flame, smoke or a spark may reach, and those around.
Blocks<bool> flame_mask(const WorldView& world, const RenderParams& params) {
    const Camera camera = make_camera(params.camera, kWidth, kHeight);
    const LookParams& look = params.look;
    Blocks<bool> mask{};
    for (const FireSprite& s :
         gather_fire_sprites(world, {look.flame_size, look.flame_share, look.smoke, look.sparks},
                             camera)
             .sprites) {
        const Eigen::Vector3f middle = 0.5f * (s.tail + s.head);
        const Eigen::Vector3f at = project(camera, middle, kWidth, kHeight);
        const float depth = -(camera.view * middle.homogeneous()).z();
        const float radius = (0.5f * (s.head - s.tail).norm() + s.half_width) * 0.5f * kHeight /
                                 (camera.tan_half_fov * depth) +
                             kBlock;
        for (int row = 0; row < kDown; ++row) {
            for (int column = 0; column < kAcross; ++column) {
                const float dx = std::abs((float(column) + 0.5f) * kBlock - at.x());
                const float dy = std::abs((float(row) + 0.5f) * kBlock - at.y());
                if (std::max(dx, dy) < radius + 0.5f * kBlock)
                    mask[std::size_t(row * kAcross + column)] = true;
            }
        }
    }
    return mask;
}

// A view whose first tongue of flame burns elsewhere in every picture.
struct Reseeded {
    std::vector<double> x, y;
    std::vector<std::uint64_t> id;

    WorldView of(WorldView world, int frame) {
        ParticleView& p = world.particles;
        x.assign(p.x.begin(), p.x.end());
        y.assign(p.y.begin(), p.y.end());
        id.assign(p.id.begin(), p.id.end());
        for (std::size_t i = 0; i < id.size(); ++i) {
            if (fire_part(id[i], {}) != FirePart::Tongue) continue;
            if (world.time - p.birth[i] < 0.1 || p.death[i] - world.time < 0.2) continue;
            x[i] = -0.25 + 0.5 * (frame * 7 % 19) / 18.0;
            y[i] = 0.15 + 0.3 * (frame * 5 % 13) / 12.0;
            break;
        }
        p.x = x, p.y = y, p.id = id;
        return world;
    }
};

// The largest second difference over three pictures of any block outside the flames of all three.
double worst_jump(bool reseed, int frames) {
    test::GlRig rig;
    test::BurntCorner corner;
    Reseeded reseeded;
    std::vector<Blocks<double>> luma;
    std::vector<Blocks<bool>> mask;
    double worst = 0;
    for (int frame = 0; frame < frames; ++frame) {
        corner.burn_until(kFirstTick + static_cast<std::uint64_t>(frame * kTicksPerFrame));
        const WorldView world = corner.world().view();
        mask.push_back(flame_mask(world, corner.render()));
        const WorldView drawn = reseed ? reseeded.of(world, frame) : world;
        luma.push_back(mean_luma(rig.draw(drawn, corner.render(), kWidth, kHeight)));
        if (frame < 2) continue;
        const auto f = static_cast<std::size_t>(frame);
        for (std::size_t b = 0; b < luma[f].size(); ++b) {
            if (mask[f][b] || mask[f - 1][b] || mask[f - 2][b]) continue;
            worst = std::max(worst, std::abs(luma[f][b] - 2 * luma[f - 1][b] + luma[f - 2][b]));
        }
    }
    return worst;
}

TEST(Flicker, NothingPopsOutsideTheFlames) {
    EXPECT_LT(worst_jump(false, kFrames), kMost);
}

TEST(Flicker, AFlameThatIsSeededAnewInEveryPictureIsFound) {
    EXPECT_GT(worst_jump(true, 12), kMost);
}

}  // namespace
}  // namespace ember
