// Which particles are drawn as what, without GL.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <map>

#include "render/fire_sprites.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

constexpr double kLife = 0.5;  // [s]

FireSprites sprites_of(const WorldView& world, const FireLook& look, const Camera& camera) {
    return gather_fire_sprites(world, FireCells(world), look, camera);
}

Camera default_camera() {
    return make_camera(CameraParams{}, 640, 360);
}

// So much of a fire around all places that the particles below come to that flames are at their
// highest.
const FireCells& great_fire() {
    static const FireCells cells = [] {
        StagedWorld staged = test::hanging_sheet(3, 3);
        for (int i = 0; i < 300 * 28; ++i) {
            const Vector3 corner(i % 2, 3 + i / 4 % 7, i / 2 % 2);
            staged.add_particle(FireCells::kSize * corner, test::kFlame);
        }
        return FireCells(staged.view());
    }();
    return cells;
}

// One particle `age` seconds after its birth, rising as fire does.
StagedWorld flying(std::uint64_t id, double age) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    const double cooled = std::exp(-age / 0.5);
    staged.add_particle({0.02, 0.30 + 0.9 * age * age, 0.03},
                        test::kAmbient + cooled * (test::kFlame - test::kAmbient));
    staged.fire_vy.back() = 1.8 * age;
    staged.fire_vx.back() = 0.05;
    staged.fire_id.back() = id;
    staged.fire_birth.back() = staged.time - age;
    staged.fire_death.back() = staged.time - age + kLife;
    return staged;
}

// All that a sprite shows: its place, size and amounts, amounts weighing most.
Eigen::VectorXd shown(const FireSprite& s) {
    Eigen::VectorXd v(13);
    const auto amount = static_cast<double>(s.flame + s.blue + s.smoke);
    v << s.tail.cast<double>(), s.head.cast<double>(), double(s.half_width), 0.1 * double(s.row),
        0.01 * double(s.frame), 0.1 * double(s.mirror), double(s.flame), double(s.blue),
        double(s.smoke);
    v.head<10>() *= amount;  // what is hardly there may be anywhere
    return v;
}

Eigen::VectorXd shown_of(std::uint64_t id, double age) {
    const StagedWorld staged = flying(id, age);
    const FireSprites fire = gather_fire_sprites(staged.view(), great_fire(), {}, default_camera());
    return fire.sprites.empty() ? Eigen::VectorXd(Eigen::VectorXd::Zero(13))
                                : shown(fire.sprites.front());
}

std::uint64_t some_id(std::uint64_t k) {
    return (k + 1) * 0x9E3779B97F4A7C15ull;
}

TEST(FireSprites, PartsHaveTheirShares) {
    std::map<FirePart, int> count;
    constexpr int kIds = 100000;
    for (std::uint64_t k = 0; k < kIds; ++k)
        ++count[fire_part(some_id(k), {})];
    const double tongues = count[FirePart::Tongue] / double(kIds);
    EXPECT_NEAR(tongues, FireLook{}.share, 4 * std::sqrt(0.055 / kIds));
    EXPECT_GT(count[FirePart::Spark], 50);
    EXPECT_LT(count[FirePart::Spark], 1000) << "few";
    FireLook none;
    none.share = none.sparks = 0;
    for (std::uint64_t k = 0; k < 1000; ++k) {
        EXPECT_NE(fire_part(some_id(k), none), FirePart::Tongue);
        EXPECT_NE(fire_part(some_id(k), none), FirePart::Spark);
    }
}

// The rule against flicker: from birth to death nothing that a sprite shows jumps, whatever its
// part, and it comes and goes unseen.
TEST(FireSprites, NothingPopsInTheLifeOfAParticle) {
    constexpr double kStep = 1.0 / 480.0;
    int seen = 0;
    for (std::uint64_t k = 0; k < 300; ++k) {
        Eigen::VectorXd before = shown_of(some_id(k), 0.0);
        EXPECT_LT(before.norm(), 0.02) << "at birth";
        for (double age = kStep; age < kLife; age += kStep) {
            const Eigen::VectorXd now = shown_of(some_id(k), age);
            EXPECT_LT((now - before).norm(), 0.16) << "particle " << k << " at " << age << " s";
            if (now.norm() > 0.1) ++seen;
            before = now;
        }
        EXPECT_LT(before.norm(), 0.02) << "at death";
    }
    EXPECT_GT(seen, 1000);
}

TEST(FireSprites, AReseededParticleDoesPop) {
    int jumps = 0;
    for (std::uint64_t k = 0; k < 300; ++k) {
        const Eigen::VectorXd before = shown_of(some_id(k), 0.20);
        const Eigen::VectorXd other = shown_of(some_id(k + 5000), 0.20 + 1.0 / 480.0);
        if ((other - before).norm() > 0.16) ++jumps;
    }
    EXPECT_GT(jumps, 15);
}

std::uint64_t tongue_id() {
    std::uint64_t tongue = 0;
    while (fire_part(some_id(tongue), {}) != FirePart::Tongue)
        ++tongue;
    return some_id(tongue);
}

// Share of its life for which a tongue is seen, and how much gas is around it then.
struct Seen {
    double share = 0, gas = 0;
};

Seen seen_until(const FireCells& fire) {
    double low = 0.1, high = 1.0;
    while (high - low > 1e-3) {
        const double middle = 0.5 * (low + high);
        const StagedWorld staged = flying(tongue_id(), middle * kLife);
        const FireSprites all = gather_fire_sprites(staged.view(), fire, {}, default_camera());
        const bool seen = !all.sprites.empty() && all.sprites.front().flame > 0.01f;
        (seen ? low : high) = middle;
    }
    const StagedWorld staged = flying(tongue_id(), low * kLife);
    return {low, fire.gas_at({staged.fire_x[0], staged.fire_y[0], staged.fire_z[0]})};
}

TEST(FireSprites, SmallFiresHaveLowFlames) {
    EXPECT_NEAR(seen_until(test::fire_at({0, 0, 0}, 0)).share, 0.4, 0.03);
    EXPECT_GT(seen_until(great_fire()).share, 0.95);
    for (const int particles : {500, 600, 700}) {
        const Seen seen = seen_until(test::fire_at({0.02, 0.36, 0.03}, particles));
        EXPECT_GT(seen.share, 0.45) << particles;
        EXPECT_LT(seen.share, 0.95) << particles;
        EXPECT_NEAR(seen.share, std::sqrt(seen.gas / 240), 0.05) << particles;
    }
}

TEST(FireSprites, TheSameFireIsTheSameWhateverElseBurns) {
    StagedWorld one = flying(tongue_id(), 0.1);
    const auto alone = sprites_of(one.view(), {}, default_camera());
    for (int i = 0; i < 200; ++i)
        one.add_particle({0.001 * i, 0.3, -0.17}, test::kFlame);  // more than two cells away
    const auto among = sprites_of(one.view(), {}, default_camera());
    ASSERT_EQ(alone.sprites.size(), 1u);
    ASSERT_GT(among.sprites.size(), 5u);
    EXPECT_EQ(shown(alone.sprites.front()), shown(among.sprites.front()));
    EXPECT_LE(among.flames, among.sprites.size());
}

// A staged fire of so many particles that differ in number, place and age.
StagedWorld crowd(int particles) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (int i = 0; i < particles; ++i)
        staged.add_particle({-0.1 + 0.2 * (i % 97) / 97, 0.3 + 0.1 * (i % 53) / 53, 0},
                            test::kFlame);
    return staged;
}

TEST(FireSprites, OfACrowdNoMoreAreDrawnAndNoneComesOrGoesAtOnce) {
    const auto drawn = [](int particles) {
        const StagedWorld staged = crowd(particles);
        return sprites_of(staged.view(), {}, default_camera());
    };
    const double few = static_cast<double>(drawn(2000).sprites.size());
    const double many = static_cast<double>(drawn(40000).sprites.size());
    EXPECT_GT(few, 100);
    EXPECT_LT(many, 3.5 * few) << "rather than 20 times";
    // one particle more takes little from each of the others
    const FireSprites before = drawn(9000), after = drawn(9001);
    std::size_t k = 0;
    float most = 0;
    for (const FireSprite& s : before.sprites) {
        while (k < after.sprites.size() && after.sprites[k].tail != s.tail)
            ++k;
        if (k == after.sprites.size()) break;
        most = std::max(most, std::abs(after.sprites[k].flame - s.flame));
    }
    EXPECT_GT(k, before.sprites.size() / 2);
    EXPECT_LT(most, 0.01f);
}

TEST(FireSprites, WhatIsOutsideThePictureIsNotDrawn) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (int i = 0; i < 400; ++i)
        staged.add_particle({0, 0.3, 0}, test::kFlame);
    Camera camera = default_camera();
    EXPECT_GT(sprites_of(staged.view(), {}, camera).sprites.size(), 20u);
    CameraParams away;
    away.target_x = 5.0;
    EXPECT_EQ(sprites_of(staged.view(), {}, make_camera(away, 640, 360)).sprites.size(), 0u);
}

TEST(FireSprites, ATongueThatComesCloseStopsGrowing) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (int i = 0; i < 100; ++i)
        staged.add_particle({0, 0.31, 0}, test::kFlame);
    CameraParams close;
    close.distance = 0.05;
    const Camera camera = make_camera(close, 640, 360);
    for (const FireSprite& s : sprites_of(staged.view(), {}, camera).sprites) {
        const Eigen::Vector3f middle = 0.5f * (s.tail + s.head);
        const float half_view = camera.tan_half_fov * (middle - camera.eye).norm();
        EXPECT_LT(s.half_width, 0.7f * half_view);
        EXPECT_LT(0.5f * (s.head - s.tail).norm(), 0.7f * half_view);
    }
}

}  // namespace
}  // namespace ember
