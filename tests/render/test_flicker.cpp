// Consecutive pictures of the burning corner: nothing may pop where no flame is and where paper
// moves so little from one to the next that a picture between them would look like both.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "render/fire_sprites.h"
#include "support/burnt_corner.h"
#include "support/gl_rig.h"

namespace ember {
namespace {

constexpr int kWidth = 320, kHeight = 180, kBlock = 16;
constexpr int kAcross = kWidth / kBlock, kDown = (kHeight + kBlock - 1) / kBlock;
// Every tick is a picture, 60 per second: what moves makes the less of a difference the closer
// pictures are together, what pops makes the same. In these two seconds pieces tear off, flakes of
// ash fall, turn and come to rest, and the last fire goes out.
constexpr int kFrames = 120, kMutantFrames = 20;
constexpr std::uint64_t kFirstTick = 330;
constexpr double kMost = 6.0;  // of 255: second difference of a block's luma

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
         gather_fire_sprites(world, FireCells(world),
                             {look.flame_size, look.flame_share, look.smoke, look.sparks}, camera)
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

// Blocks around paper that moves by more than a quarter of one between pictures.
void add_fast_paper(const WorldView& world, const RenderParams& params, Blocks<bool>& mask) {
    const Camera camera = make_camera(params.camera, kWidth, kHeight);
    const auto at = [&](double x, double y, double z) {
        const auto p = project(camera, Eigen::Vector3d(x, y, z).cast<float>(), kWidth, kHeight);
        return Eigen::Vector2f(p.x(), p.y());
    };
    for (const SheetView& s : world.sheets) {
        for (std::size_t n = 0; n < s.x.size(); ++n) {
            const Eigen::Vector2f now = at(s.x[n], s.y[n], s.z[n]);
            const Eigen::Vector2f then =
                at(s.x[n] - s.vx[n] / 60, s.y[n] - s.vy[n] / 60, s.z[n] - s.vz[n] / 60);
            if ((now - then).norm() < 0.25f * kBlock) continue;
            const int row = int(now.y()) / kBlock, column = int(now.x()) / kBlock;
            for (int r = std::max(0, row - 1); r < std::min(kDown, row + 2); ++r) {
                for (int c = std::max(0, column - 1); c < std::min(kAcross, column + 2); ++c)
                    mask[std::size_t(r * kAcross + c)] = true;
            }
        }
    }
}

// A view in which one sprite is seeded anew in every picture: the hottest grown tongue of flame
// gets another random number, and with it another shape and another place, beside and before the
// paper.
struct Reseeded {
    std::vector<double> x, y, z;
    std::vector<std::uint64_t> id;

    static bool is_drawn(std::uint64_t id) {
        return fire_part(id, {}) == FirePart::Tongue && fire_rank(id, {}) < 0.3;
    }
    WorldView of(WorldView world, const Camera& camera, int frame) {
        ParticleView& p = world.particles;
        x.assign(p.x.begin(), p.x.end());
        y.assign(p.y.begin(), p.y.end());
        z.assign(p.z.begin(), p.z.end());
        id.assign(p.id.begin(), p.id.end());
        std::size_t hottest = id.size();
        for (std::size_t i = 0; i < id.size(); ++i) {
            const double life = (world.time - p.birth[i]) / (p.death[i] - p.birth[i]);
            if (!is_drawn(id[i]) || life < 0.2 || life > 0.4) continue;
            if (hottest == id.size() || p.temperature[i] > p.temperature[hottest]) hottest = i;
        }
        if (hottest == id.size()) return world;
        std::uint64_t& seed = id[hottest];
        do {
            seed = seed * std::uint64_t{0xD6E8FEB86659FD93} + static_cast<std::uint64_t>(frame);
        } while (!is_drawn(seed));
        const Eigen::Vector3f beside(frame % 2 == 0 ? -0.31f : 0.31f, 0.26f, 0);
        const Eigen::Vector3f near = camera.eye + 0.55f * (beside - camera.eye);
        x[hottest] = static_cast<double>(near.x());
        y[hottest] = static_cast<double>(near.y());
        z[hottest] = static_cast<double>(near.z());
        p.x = x, p.y = y, p.z = z, p.id = id;
        return world;
    }
};

// The largest second difference over three consecutive pictures of any block outside the masks of
// all three.
class Watch {
  public:
    void see(const Image& image, const Blocks<bool>& mask) {
        luma_[2] = luma_[1], luma_[1] = luma_[0], luma_[0] = mean_luma(image);
        mask_[2] = mask_[1], mask_[1] = mask_[0], mask_[0] = mask;
        if (++seen_ < 3) return;
        for (std::size_t b = 0; b < mask.size(); ++b) {
            if (mask_[0][b] || mask_[1][b] || mask_[2][b]) continue;
            ++looked_at_;
            worst_ = std::max(worst_, std::abs(luma_[0][b] - 2 * luma_[1][b] + luma_[2][b]));
        }
    }
    [[nodiscard]] double worst() const { return worst_; }
    [[nodiscard]] int looked_at() const { return looked_at_; }

  private:
    std::array<Blocks<double>, 3> luma_{};
    std::array<Blocks<bool>, 3> mask_{};
    int seen_ = 0, looked_at_ = 0;
    double worst_ = 0;
};

TEST(Flicker, NothingPopsOutsideTheFlamesAndAFlameThatIsSeededAnewIsFound) {
    test::GlRig rig;
    test::BurntCorner corner;
    Reseeded reseeded;
    Watch real, mutant;
    const Camera camera = make_camera(corner.render().camera, kWidth, kHeight);
    for (int frame = 0; frame < kFrames; ++frame) {
        corner.burn_until(kFirstTick + static_cast<std::uint64_t>(frame));
        const WorldView world = corner.world().view();
        Blocks<bool> mask = flame_mask(world, corner.render());
        add_fast_paper(world, corner.render(), mask);
        real.see(rig.draw(world, corner.render(), kWidth, kHeight), mask);
        if (frame >= kMutantFrames) continue;
        const WorldView other = reseeded.of(world, camera, frame);
        mutant.see(rig.draw(other, corner.render(), kWidth, kHeight), mask);
    }
    RecordProperty("worst", std::to_string(real.worst()));
    RecordProperty("mutant", std::to_string(mutant.worst()));
    std::printf("second difference of luma: %.2f, mutant %.2f of 255\n", real.worst(),
                mutant.worst());
    EXPECT_GT(real.looked_at(), kFrames * kAcross * kDown / 2);
    EXPECT_LT(real.worst(), kMost);
    EXPECT_GT(mutant.worst(), kMost);
}

}  // namespace
}  // namespace ember
