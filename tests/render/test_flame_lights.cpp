// The light of the flames, gathered into a few lamps.
#include <gtest/gtest.h>

#include "render/flame_lights.h"
#include "support/staged_world.h"

namespace ember {
namespace {

using test::StagedWorld;

TEST(FlameLights, NoFireIsNoLight) {
    EXPECT_EQ(gather_flame_lights(FireCells(test::hanging_sheet(3, 3).view())).count, 0);
}

TEST(FlameLights, ColdParticlesGiveNoLight) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    staged.add_particle({0, 0.3, 0}, test::kAmbient);
    EXPECT_EQ(gather_flame_lights(FireCells(staged.view())).count, 0);
}

double light_of(const FlameLights& lights) {
    double total = 0;
    for (int i = 0; i < lights.count; ++i)
        total += static_cast<double>(lights.light[static_cast<std::size_t>(i)].w());
    return total;
}

// What the particles add up to, of which the lights show what is not hidden.
double total_strength(const FlameLights& lights) {
    return light_of(lights) / (1 - light_of(lights) / kDeepestFire);
}

TEST(FlameLights, ADeepFireIsNotAsBrightAsAllItsParticles) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    for (int i = 0; i < 40000; ++i)
        staged.add_particle({0.02, 0.32, 0.04}, test::kFlame);
    const double deep = light_of(gather_flame_lights(FireCells(staged.view())));
    EXPECT_LT(deep, kDeepestFire);
    EXPECT_GT(deep, 0.8 * kDeepestFire);
}

TEST(FlameLights, LampsStandWhereTheParticlesAreAndAddThemUp) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    staged.add_particle({0.02, 0.32, 0.04}, test::kFlame);
    const FlameLights one = gather_flame_lights(FireCells(staged.view()));
    ASSERT_GE(one.count, 1);
    for (int i = 0; i < one.count; ++i) {
        EXPECT_NEAR((one.light[static_cast<std::size_t>(i)].head<3>() -
                     Eigen::Vector3f(0.02f, 0.32f, 0.04f))
                        .norm(),
                    0, 1e-6);
    }
    staged.add_particle({0.06, 0.36, 0.04}, test::kFlame);
    const FlameLights two = gather_flame_lights(FireCells(staged.view()));
    EXPECT_NEAR(total_strength(two), 2 * total_strength(one), 1e-6 * total_strength(two));
    EXPECT_GT(total_strength(one), 0);
}

TEST(FlameLights, OfManyTheStrongestAreKeptStrongestFirstAndNoLightIsLost) {
    StagedWorld staged = test::hanging_sheet(3, 3);
    int particles = 0;
    for (int place = 0; place < 30; ++place) {
        for (int i = 0; i <= place; ++i, ++particles)
            staged.add_particle({0.24 * place, 0.32, 0.08}, test::kFlame);  // on a corner of cells
    }
    const FlameLights lights = gather_flame_lights(FireCells(staged.view()));
    ASSERT_EQ(lights.count, kMostFlameLights);
    StagedWorld single = test::hanging_sheet(3, 3);
    single.add_particle({0, 0, 0}, test::kFlame);
    EXPECT_NEAR(
        total_strength(lights) / total_strength(gather_flame_lights(FireCells(single.view()))),
        particles, 1e-3 * particles);
    for (int i = 0; i < lights.count; ++i) {
        EXPECT_NEAR(lights.light[static_cast<std::size_t>(i)].x(), 0.24 * (29 - i), 1e-5);
    }
}

// What the lamps throw on a place may not jump when a particle crosses from cell to cell, nor when
// a lamp takes another's place.
TEST(FlameLights, TheLightOnAPlaceChangesAsSlowlyAsTheParticlesMove) {
    const auto light_at = [](double shift) {
        StagedWorld staged = test::hanging_sheet(3, 3);
        for (int i = 0; i < 300; ++i) {
            staged.add_particle({0.011 * (i % 40) + shift, 0.2 + 0.013 * (i / 17), 0.002 * (i % 9)},
                                test::kFlame);
        }
        const FlameLights lights = gather_flame_lights(FireCells(staged.view()));
        double sum = 0;
        for (int i = 0; i < lights.count; ++i) {
            const Eigen::Vector4f& l = lights.light[static_cast<std::size_t>(i)];
            const Eigen::Vector3f to = l.head<3>() - Eigen::Vector3f(0.1f, 0.3f, 0.1f);
            sum += static_cast<double>(l.w() / (to.squaredNorm() + 0.0025f));
        }
        return sum;
    };
    double before = light_at(0.0);
    for (int step = 1; step <= 400; ++step) {
        const double now = light_at(0.0005 * step);
        EXPECT_NEAR(now / before, 1.0, 0.015) << "moved by " << 0.5 * step << " mm";
        before = now;
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
