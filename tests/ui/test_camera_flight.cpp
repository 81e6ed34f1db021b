#include "ui/camera_flight.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ember {
namespace {

constexpr double kTurn = 2 * 3.141592653589793;

TEST(CameraFlight, EndsExactlyAtItsGoalAndThenIsOver) {
    CameraParams from, to;
    to.azimuth = 1.1;
    to.distance = 0.3;
    to.target_x = 0.07;
    CameraFlight flight;
    EXPECT_FALSE(flight.at(0.0));
    flight.begin(from, to, 5.0);
    const auto begun = flight.at(5.0);
    ASSERT_TRUE(begun);
    EXPECT_NEAR(begun->distance, from.distance, 1e-12);
    EXPECT_EQ(begun->azimuth, from.azimuth);
    const auto half = flight.at(5.0 + 0.5 * CameraFlight::kDuration);
    EXPECT_NEAR(half->azimuth, 0.5 * (from.azimuth + to.azimuth), 1e-12);
    EXPECT_NEAR(half->distance, std::sqrt(from.distance * to.distance), 1e-12);
    const auto arrived = flight.at(5.01 + CameraFlight::kDuration);
    EXPECT_EQ(arrived->azimuth, to.azimuth);
    EXPECT_EQ(arrived->distance, to.distance);
    EXPECT_EQ(arrived->target_x, to.target_x);
    EXPECT_FALSE(flight.at(9.0));
}

TEST(CameraFlight, TurnsTheShortWayRound) {
    CameraParams from, to;
    from.azimuth = 0.45 * kTurn;
    to.azimuth = -0.45 * kTurn;
    CameraFlight flight;
    flight.begin(from, to, 0);
    EXPECT_NEAR(flight.at(0.5 * CameraFlight::kDuration)->azimuth, 0.5 * kTurn, 1e-12);
}

TEST(CameraFlight, KeepsTheSizeOfThingsWhileTheLensChanges) {
    CameraParams from, to;
    to.field_of_view = 0.04;
    to.distance = from.distance * std::tan(0.5 * from.field_of_view) / std::tan(0.02);
    CameraFlight flight;
    flight.begin(from, to, 0);
    const auto half = flight.at(0.5 * CameraFlight::kDuration);
    EXPECT_NEAR(half->distance * std::tan(0.5 * half->field_of_view),
                from.distance * std::tan(0.5 * from.field_of_view), 1e-12);
}

}  // namespace
}  // namespace ember
