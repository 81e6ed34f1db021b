#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "sim/math.h"
#include "sim/random.h"

namespace ember {
namespace {

TEST(Math, ExpAgreesWithTheLibraryToTwoUlp) {
    for (double x = -700; x <= 700; x += 0.37) {
        EXPECT_NEAR(ember::exp(x) / std::exp(x), 1.0, 5e-16) << x;
    }
    EXPECT_EQ(ember::exp(0.0), 1.0);
    EXPECT_EQ(ember::exp(-800.0), 0.0);
    EXPECT_TRUE(std::isinf(ember::exp(800.0)));
    EXPECT_TRUE(std::isnan(ember::exp(std::numeric_limits<double>::quiet_NaN())));
}

TEST(Math, LogAgreesWithTheLibrary) {
    for (double x = 1e-300; x < 1e300; x *= 3.7) {
        EXPECT_NEAR(ember::log(x), std::log(x), 4e-16 * std::abs(std::log(x)) + 1e-16) << x;
    }
    EXPECT_EQ(ember::log(1.0), 0.0);
    EXPECT_TRUE(std::isnan(ember::log(-1.0)));
}

TEST(Math, SinAndCosAgreeWithTheLibrary) {
    for (double x = -20; x <= 20; x += 0.013) {
        EXPECT_NEAR(ember::sin(x), std::sin(x), 2e-15) << x;
        EXPECT_NEAR(ember::cos(x), std::cos(x), 2e-15) << x;
    }
}

TEST(Math, PowersOfTwoAndRootsComeOut) {
    EXPECT_NEAR(ember::pow(2.0, 10.0), 1024.0, 1e-11);
    EXPECT_NEAR(ember::pow(0.2, 0.25), std::pow(0.2, 0.25), 1e-15);
}

TEST(Random, IsAPureFunctionOfItsFourArguments) {
    const auto draw = [](std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
        return random_bits(seed, RandomUse::Particle, stream, index);
    };
    EXPECT_EQ(draw(1, 2, 3), draw(1, 2, 3));
    const std::set<std::uint64_t> distinct = {draw(1, 2, 3), draw(2, 2, 3), draw(1, 3, 3),
                                              draw(1, 2, 4),
                                              random_bits(1, RandomUse::Waviness, 2, 3)};
    EXPECT_EQ(distinct.size(), 5u);
}

TEST(Random, UniformAndBellHaveTheirMoments) {
    double sum = 0, square = 0, bell = 0, bell_square = 0;
    constexpr int kCount = 100000;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        const std::uint64_t bits = random_bits(7, RandomUse::Particle, 1, i);
        const double u = uniform_from(bits), b = bell_from(bits);
        ASSERT_GE(u, 0.0);
        ASSERT_LT(u, 1.0);
        sum += u, square += u * u, bell += b, bell_square += b * b;
    }
    EXPECT_NEAR(sum / kCount, 0.5, 0.004);
    EXPECT_NEAR(square / kCount, 1.0 / 3.0, 0.004);
    EXPECT_NEAR(bell / kCount, 0.0, 0.015);
    EXPECT_NEAR(bell_square / kCount, 1.0, 0.02);
}

}  // namespace
}  // namespace ember
