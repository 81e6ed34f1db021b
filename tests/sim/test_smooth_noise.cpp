// Smooth random numbers: bounded, continuous, and closed where they must be.
#include "sim/smooth_noise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/world.h"

namespace ember {
namespace {

TEST(SmoothNoise, IsBoundedContinuousAndRepeatsAfterItsPeriod) {
    const SmoothNoise noise{3, RandomUse::AshStrength, 0, 12, 5};
    double least = 1, most = -1;
    for (double y = 0; y < 5; y += 0.05) {
        for (double x = 0; x < 10; x += 0.05) {
            const double value = noise.at(x, y);
            least = std::min(least, value), most = std::max(most, value);
            EXPECT_LE(std::abs(noise.at(x + 0.01, y) - value), 2 * 1.5 * 0.01 + 1e-12);
            EXPECT_NEAR(noise.at(x, y + 5), value, 1e-12);  // y + 5 is rounded
        }
    }
    EXPECT_GE(least, -1);
    EXPECT_LT(least, -0.8);
    EXPECT_LE(most, 1);
    EXPECT_GT(most, 0.8);
}

TEST(SmoothNoise, IsAnotherForAnotherSeedAndAnotherStream) {
    const SmoothNoise noise{3, RandomUse::Waviness, 0, 12, 0},
        seed{4, RandomUse::Waviness, 0, 12, 0}, stream{3, RandomUse::Waviness, 1, 12, 0};
    for (const auto& [x, y] : {std::pair(0.5, 0.5), {3.1, 2.2}, {7.9, 4.4}}) {
        EXPECT_NE(noise.at(x, y), seed.at(x, y));
        EXPECT_NE(noise.at(x, y), stream.at(x, y));
    }
}

TEST(SmoothNoise, ATubesWavinessClosesAndIsNoMirrorImage) {
    Params p;
    p.sheet.shape = SheetShape::Cylinder;
    p.sheet.rows = 60;
    p.sheet.imperfection = 0.01;
    const World tube = make_world(p);
    const SheetState& sheet = tube.state().sheets[0];
    const auto at = [&](Index r) {
        return sheet.position.at(static_cast<std::size_t>((r + 60) % 60 * 49 + 7));
    };
    Vector3 middle = Vector3::Zero();
    for (Index r = 0; r < 60; ++r)
        middle += at(r) / 60;
    const auto radius = [&](Index row) { return (at(row) - middle).norm(); };
    double step = 0, mirror = 0;
    for (Index r = 1; r < 60; ++r) {
        step = std::max(step, std::abs(radius(r) - radius(r - 1)));
        mirror = std::max(mirror, std::abs(radius(r) - radius(60 - r)));
    }
    EXPECT_LE(std::abs(radius(0) - radius(-1)), step);
    EXPECT_GT(mirror, 0.002);
}

}  // namespace
}  // namespace ember
