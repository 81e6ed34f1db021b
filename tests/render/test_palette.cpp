// Colours of paper, fire and quantities.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/palette.h"

namespace ember {
namespace {

constexpr double kIgnition = 1041.15;  // [K]

double luminance(const Colour& c) {
    return 0.2126 * static_cast<double>(c.x()) + 0.7152 * static_cast<double>(c.y()) +
           0.0722 * static_cast<double>(c.z());
}

double unburnt(double celsius) {
    return burn_progress(Phase::Unburnt, celsius + 273.15, kIgnition, 0, 0);
}

TEST(BurnProgress, RunsThroughThePhasesWithoutAJump) {
    EXPECT_EQ(unburnt(20), 0.0);
    EXPECT_EQ(unburnt(120), 0.0);
    EXPECT_GT(unburnt(200), 0.0);
    EXPECT_DOUBLE_EQ(unburnt(768), 1.0);
    EXPECT_DOUBLE_EQ(burn_progress(Phase::Burning, 1200, kIgnition, 0, 0), 1.0);
    EXPECT_DOUBLE_EQ(burn_progress(Phase::Burning, 1200, kIgnition, 0.25, 0), 1.25);
    EXPECT_DOUBLE_EQ(burn_progress(Phase::Burning, 1200, kIgnition, 1, 0), 2.0);
    EXPECT_DOUBLE_EQ(burn_progress(Phase::BurntOut, 300, kIgnition, 1, 0), 2.0);
    EXPECT_DOUBLE_EQ(burn_progress(Phase::BurntOut, 300, kIgnition, 1, kAshTime), 3.0);
    EXPECT_EQ(burn_progress(Phase::BurntOut, 300, kIgnition, 1, 1e6), kBurnProgressEnd);
}

TEST(BurnProgress, StaysInItsPhaseWhateverTheNumbers) {
    EXPECT_LE(unburnt(5000), 1.0);  // hot, but not yet ignited by the tick's bookkeeping
    EXPECT_EQ(burn_progress(Phase::Burning, 300, kIgnition, -0.1, 0), 1.0);
    EXPECT_EQ(burn_progress(Phase::Burning, 300, kIgnition, 1.1, 0), 2.0);
}

TEST(PaperAlbedo, DarkensFromWarmWhiteToBlackWhilePaperHeats) {
    const Colour white = paper_albedo(0);
    EXPECT_GT(luminance(white), 0.75);
    EXPECT_GT(white.x(), white.z());
    for (double p = 0; p < 1; p += 0.02) {
        EXPECT_LE(luminance(paper_albedo(p + 0.02)), luminance(paper_albedo(p)) + 1e-6) << p;
    }
    const Colour scorch = paper_albedo(0.4);
    EXPECT_GT(scorch.x(), 1.8f * scorch.z());  // brown, not grey
}

TEST(PaperAlbedo, CharIsBlackAndAshIsPaleGrey) {
    for (double p = 1.0; p <= 2.0; p += 0.05)
        EXPECT_LT(luminance(paper_albedo(p)), 0.03) << p;
    const Colour ash = paper_albedo(kBurnProgressEnd);
    EXPECT_GT(luminance(ash), 5 * luminance(paper_albedo(2.0)));
    EXPECT_LT(luminance(ash), 0.6 * luminance(paper_albedo(0)));
    EXPECT_LT(ash.maxCoeff() - ash.minCoeff(), 0.1f * ash.maxCoeff());
}

TEST(PaperGlow, IsAnOrangeRimAtIgnitionThatIsDarkOnBothSides) {
    EXPECT_EQ(paper_glow(0.0), Colour::Zero());
    EXPECT_EQ(paper_glow(0.8), Colour::Zero());
    EXPECT_EQ(paper_glow(kBurnProgressEnd), Colour::Zero());
    double brightest = 0, half_width = 0;
    for (double p = 0; p < kBurnProgressEnd; p += 0.005) {
        if (luminance(paper_glow(p)) > luminance(paper_glow(brightest))) brightest = p;
    }
    for (double p = 0; p < kBurnProgressEnd; p += 0.005) {
        const Colour c = paper_glow(p);
        EXPECT_GE(c.x(), c.y()) << p;
        EXPECT_GE(c.y(), c.z()) << p;
        if (luminance(c) > 0.5 * luminance(paper_glow(brightest))) half_width += 0.005;
    }
    EXPECT_NEAR(brightest, 1.0, 0.1);
    EXPECT_LT(half_width, 0.25) << "the rim is a line, not a band";
    EXPECT_GT(paper_glow(brightest).x(), 1.0f) << "brighter than lit white paper";
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
    const ColourTable table = tabulate(paper_albedo, kBurnProgressEnd);
    EXPECT_EQ(table.front(), paper_albedo(0));
    EXPECT_EQ(table.back(), paper_albedo(kBurnProgressEnd));
    EXPECT_EQ(table[51], paper_albedo(kBurnProgressEnd * 51 / 255));
}

}  // namespace
}  // namespace ember
