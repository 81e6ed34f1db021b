// The colour of hot bodies against what is known.
#include <gtest/gtest.h>

#include "render/blackbody.h"

namespace ember {
namespace {

TEST(Blackbody, ChromaticitiesLieOnThePlanckianLocus) {
    // CIE 15: illuminant A is a black body of 2856 K; the others are points of the locus
    const struct {
        double kelvin, x, y;
    } known[] = {{1500, 0.5857, 0.3931}, {2856, 0.4476, 0.4074}, {6500, 0.3135, 0.3237}};
    for (const auto& point : known) {
        const Eigen::Vector2d xy = blackbody_chromaticity(point.kelvin);
        EXPECT_NEAR(xy.x(), point.x, 0.005) << point.kelvin;
        EXPECT_NEAR(xy.y(), point.y, 0.005) << point.kelvin;
    }
}

TEST(Blackbody, FlamesAreOrangeAndTheHotterTheYellower) {
    float green = 0;
    for (double kelvin = 1000; kelvin <= 2800; kelvin += 100) {
        const Colour c = blackbody_colour(kelvin);
        EXPECT_FLOAT_EQ(c.x(), 1.0f);
        EXPECT_GT(c.y(), green) << kelvin;
        EXPECT_LT(c.z(), c.y());
        green = c.y();
    }
    EXPECT_LT(blackbody_colour(1200).y(), 0.25f);
    EXPECT_GT(blackbody_colour(2500).y(), 0.3f);
}

}  // namespace
}  // namespace ember
