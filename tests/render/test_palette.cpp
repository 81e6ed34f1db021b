// Colours of paper, fire and quantities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/palette.h"

namespace ember {
namespace {

double luminance(const Colour& c) {
    return 0.2126 * static_cast<double>(c.x()) + 0.7152 * static_cast<double>(c.y()) +
           0.0722 * static_cast<double>(c.z());
}

double encoded(float linear) {  // sRGB, 0 to 255
    const auto c = static_cast<double>(linear);
    return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055);
}

TEST(ScorchedAlbedo, RunsFromBlackCharThroughANarrowBrownToWarmWhite) {
    const Colour white = scorched_albedo(kScorchEnd), black = scorched_albedo(0);
    EXPECT_GT(luminance(white), 0.75);
    EXPECT_GT(white.x(), white.z());
    EXPECT_NEAR(encoded(black.x()), 22, 1.5) << "char is black, not brown";
    EXPECT_NEAR(encoded(black.y()), 20, 1.5);
    EXPECT_NEAR(encoded(black.z()), 18, 1.5);
    double brown = 0;
    for (double mm = 0; mm < kScorchEnd; mm += 0.1) {
        const Colour c = scorched_albedo(mm);
        EXPECT_LE(luminance(c), luminance(scorched_albedo(mm + 0.1)) + 1e-6) << mm;
        if (c.x() > 1.8f * c.z() && luminance(c) > 0.01) brown += 0.1;
    }
    EXPECT_GT(brown, 2);
    EXPECT_LT(brown, 6) << "mm";
}

TEST(CharAndAsh, AshPalesFromNearBlackToLightGreyWithoutColour) {
    EXPECT_EQ(char_albedo(), scorched_albedo(0));
    for (double pale = 0; pale < 1; pale += 0.05) {
        EXPECT_LT(luminance(ash_albedo(pale)), luminance(ash_albedo(pale + 0.05))) << pale;
    }
    const Colour ash = ash_albedo(1);
    EXPECT_GT(luminance(ash), 20 * luminance(char_albedo()));
    EXPECT_LT(luminance(ash), 0.65 * luminance(scorched_albedo(kScorchEnd)));
    EXPECT_LT(ash.maxCoeff() - ash.minCoeff(), 0.1f * ash.maxCoeff());
}

TEST(EmberLight, IsAThinLineFourToEightTimesAsBrightAsPaper) {
    EXPECT_EQ(ember_light(0), Colour::Zero());
    EXPECT_EQ(ember_light(kEmberEnd), Colour::Zero());
    Colour brightest = Colour::Zero();
    double wide = 0;
    for (double mm = 0; mm < kEmberEnd; mm += 0.01) {
        const Colour c = ember_light(mm);
        EXPECT_GE(c.x(), c.y()) << mm;
        EXPECT_GE(c.y(), c.z()) << mm;
        if (c.x() > brightest.x()) brightest = c;
    }
    for (double mm = 0; mm < kEmberEnd; mm += 0.01)
        wide += ember_light(mm).x() > 0.5f * brightest.x() ? 0.01 : 0;
    const float white = scorched_albedo(kScorchEnd).x();
    EXPECT_GE(brightest.x(), 4 * white);
    EXPECT_LE(brightest.x(), 8 * white);
    EXPECT_GE(wide, 0.3) << "mm";
    EXPECT_LE(wide, 1.0) << "mm";
}

TEST(FlameColour, RisesFromNothingThroughRedToYellow) {
    EXPECT_EQ(flame_colour(0), Colour::Zero());
    for (double u = 0; u < 1; u += 0.02) {
        EXPECT_LE(luminance(flame_colour(u)), luminance(flame_colour(u + 0.02)) + 1e-6) << u;
        const Colour c = flame_colour(u + 0.02);
        EXPECT_GE(c.x(), c.y());
        EXPECT_GE(c.y(), c.z());
    }
    const auto yellowness = [](double u) { return flame_colour(u).y() / flame_colour(u).x(); };
    EXPECT_LT(yellowness(0.3), 0.25f);
    EXPECT_GT(yellowness(1.0), 0.45f);
}

// CIE lightness, 0 to 100.
double lightness(const Colour& c) {
    const double y = luminance(c);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(ColourMaps, LightnessRisesFromEndToEndWithoutFlatOrSteepStretches) {
    for (const auto map : {heat_map, mass_map}) {
        const double span = lightness(map(1)) - lightness(map(0));
        EXPECT_GT(span, 60);
        for (double x = 0; x < 0.95; x += 0.05) {
            const double slope = (lightness(map(x + 0.05)) - lightness(map(x))) / 0.05;
            EXPECT_GT(slope, 0.25 * span) << x;
            EXPECT_LT(slope, 2.5 * span) << x;
        }
    }
}

TEST(ColourMaps, StressIsLightestWhereThereIsNoneAndDarkensAlikeToBothSides) {
    for (double x = 0; x < 0.46; x += 0.05) {
        EXPECT_LT(lightness(stress_map(x)), lightness(stress_map(x + 0.05))) << x;
        EXPECT_LT(lightness(stress_map(1 - x)), lightness(stress_map(0.95 - x))) << x;
        EXPECT_NEAR(lightness(stress_map(x)), lightness(stress_map(1 - x)), 12) << x;
        EXPECT_GT(stress_map(x).z(), stress_map(x).x()) << "pushed is blue";
        EXPECT_GT(stress_map(1 - x).x(), stress_map(1 - x).z()) << "pulled is red";
    }
}

TEST(PhaseColours, AreFarApart) {
    const Phase phases[] = {Phase::Unburnt, Phase::Burning, Phase::BurntOut};
    for (const Phase a : phases) {
        for (const Phase b : phases) {
            if (a == b) continue;
            EXPECT_GT((phase_colour(a) - phase_colour(b)).norm(), 0.4f);
        }
    }
}

TEST(Tables, HoldTheFunctionTheyAreMadeFrom) {
    const ColourTable table = tabulate(scorched_albedo, kScorchEnd);
    EXPECT_EQ(table.front(), scorched_albedo(0));
    EXPECT_EQ(table.back(), scorched_albedo(kScorchEnd));
    EXPECT_EQ(table[51], scorched_albedo(kScorchEnd * 51 / 255));
}

}  // namespace
}  // namespace ember
