// The light of the flames, gathered into a few lamps.
#include <gtest/gtest.h>

#include "render/flame_lights.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

TEST(FlameLights, NoFireIsNoLight) {
    EXPECT_EQ(gather_flame_lights(test::hanging_sheet(3, 3).view()).count, 0);
}

TEST(FlameLights, ColdParticlesGiveNoLight) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    staged.add_particle({0, 0.3, 0}, test::kAmbient);
    EXPECT_EQ(gather_flame_lights(staged.view()).count, 0);
}

TEST(FlameLights, ALampStandsInTheMiddleOfItsParticlesAndAddsThemUp) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    staged.add_particle({0.02, 0.32, 0.04}, test::kFlame);
    const FlameLights one = gather_flame_lights(staged.view());
    staged.add_particle({0.06, 0.36, 0.04}, test::kFlame);
    const FlameLights two = gather_flame_lights(staged.view());
    ASSERT_EQ(one.count, 1);
    ASSERT_EQ(two.count, 1);
    EXPECT_NEAR((two.light[0].head<3>() - Eigen::Vector3f(0.04f, 0.34f, 0.04f)).norm(), 0, 1e-6);
    EXPECT_FLOAT_EQ(two.light[0].w(), 2 * one.light[0].w());
    EXPECT_GT(one.light[0].w(), 0);
}

TEST(FlameLights, OfManyTheStrongestAreKeptStrongestFirst) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (int place = 0; place < 12; ++place) {
        for (int i = 0; i <= place; ++i)
            staged.add_particle({0.2 * place + 0.05, 0.35, 0.05}, test::kFlame);
    }
    const FlameLights lights = gather_flame_lights(staged.view());
    ASSERT_EQ(lights.count, kMostFlameLights);
    for (int i = 0; i < lights.count; ++i) {
        EXPECT_NEAR(lights.light[static_cast<std::size_t>(i)].x(), 0.2 * (11 - i) + 0.05, 1e-5);
    }
}

TEST(FlameLights, HeatIsOneAtBirthNoughtAtAmbientAndNeverBeyond) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (const double kelvin :
         {test::kFlame, test::kAmbient, 0.5 * (test::kFlame + test::kAmbient), 2000.0, 100.0}) {
        staged.add_particle({0, 0, 0}, kelvin);
    }
    const WorldView view = staged.view();
    const double expected[] = {1, 0, 0.5, 1, 0};
    for (std::size_t i = 0; i < 5; ++i)
        EXPECT_DOUBLE_EQ(particle_heat(view, i), expected[i]);
}

}  // namespace
}  // namespace ember
