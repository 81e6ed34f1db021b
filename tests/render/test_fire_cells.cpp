// How much fire is where.
#include <gtest/gtest.h>

#include <cmath>

#include "render/fire_cells.h"
#include "support/staged_world.h"

namespace ember {
namespace {

constexpr double kSize = FireCells::kSize;

TEST(FireCells, AParticleIsSharedByTheCornersOfItsCellAndNothingIsLost) {
    const FireCells fire = test::fire_at({0.25 * kSize, 0.5 * kSize, -0.125 * kSize}, 1);
    ASSERT_EQ(fire.corners().size(), 8u);
    double gas = 0, light = 0, x = 0, y = 0, z = 0;
    for (const auto& [at, corner] : fire.corners()) {
        gas += corner.gas;
        light += corner.light;
        x += at[0] * corner.gas;
        y += at[1] * corner.gas;
        z += at[2] * corner.gas;
    }
    EXPECT_NEAR(gas, 1, 1e-14);
    EXPECT_NEAR(light, 1, 1e-14);
    EXPECT_NEAR(x, 0.25, 1e-14);
    EXPECT_NEAR(y, 0.5, 1e-14);
    EXPECT_NEAR(z, -0.125, 1e-14);
}

TEST(FireCells, GasIsCountedWhereItIsAndNotBeyondTwoCells) {
    const FireCells at_corner = test::fire_at({0, 0, 0}, 10);
    EXPECT_NEAR(at_corner.gas_at({0, 0, 0}), 10, 1e-13);
    EXPECT_NEAR(at_corner.gas_at({0.5 * kSize, 0, 0}), 5, 1e-13);
    EXPECT_EQ(at_corner.gas_at({1.01 * kSize, 0, 0}), 0);
    const FireCells in_the_middle = test::fire_at({0.5 * kSize, 0.5 * kSize, 0.5 * kSize}, 16);
    EXPECT_NEAR(in_the_middle.gas_at({0.5 * kSize, 0.5 * kSize, 0.5 * kSize}), 2, 1e-13);
    EXPECT_EQ(in_the_middle.gas_at({0.5 * kSize, 2.01 * kSize, 0.5 * kSize}), 0);
}

TEST(FireCells, NothingJumpsWhereOneCellEndsAndTheNextBegins) {
    const double before = test::fire_at({kSize - 1e-9, 0.3 * kSize, 0}, 1).gas_at({kSize, 0, 0});
    const double after = test::fire_at({kSize + 1e-9, 0.3 * kSize, 0}, 1).gas_at({kSize, 0, 0});
    EXPECT_NEAR(before, 0.7, 1e-6);
    EXPECT_NEAR(before, after, 1e-6);
}

}  // namespace
}  // namespace ember
