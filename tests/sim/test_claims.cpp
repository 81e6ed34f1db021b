// What the corner scene must do: ignite, spread, crumple, burn, crack. Statistics of whole runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>

#include "sim/world.h"
#include "small_sheet.h"

namespace ember {
namespace {

struct Burn {
    World world;
    double first_ignition = -1;  // [s]
    double burnt_share = 0;      // of sites
    double out_of_plane = 0;     // [m] RMS distance from the mean plane z = const, unburnt sheet
    bool finite = true;
    StepReport last;

    explicit Burn(const Params& params, double seconds) : world(make_world(params, 1)) {
        const auto ticks = static_cast<int>(std::lround(seconds * params.numerics.tick_rate));
        for (int i = 0; i < ticks && last.ok(); ++i) {
            last = world.step();
            const WorldState& s = world.state();
            if (first_ignition < 0 && s.totals.ignitions > 0) first_ignition = s.time;
            finite = finite &&
                     std::isfinite(s.energy.kinetic + s.energy.elastic + s.energy.gravitational);
        }
        const SheetState& sheet = world.state().sheets[0];
        const std::size_t sites = sheet.glue.size();
        double mean = 0, square = 0;
        for (std::size_t n = 0; n < sites; ++n) {
            burnt_share += sheet.phase[n] == Phase::BurntOut ? 1.0 : 0.0;
            mean += sheet.position.z[n];
        }
        burnt_share /= static_cast<double>(sites);
        mean /= static_cast<double>(sites);
        for (std::size_t n = 0; n < sites; ++n) {
            square += std::pow(sheet.position.z[n] - mean, 2);
        }
        out_of_plane = std::sqrt(square / static_cast<double>(sites));
    }
};

std::vector<double> ranks(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    std::vector<double> rank(values.size());
    for (std::size_t i = 0; i < order.size();) {  // ties share their mean rank
        std::size_t j = i;
        while (j < order.size() && values[order[j]] == values[order[i]])
            ++j;
        for (std::size_t k = i; k < j; ++k)
            rank[order[k]] = 0.5 * static_cast<double>(i + j - 1);
        i = j;
    }
    return rank;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    const auto n = static_cast<double>(a.size());
    const double ma = std::accumulate(a.begin(), a.end(), 0.0) / n;
    const double mb = std::accumulate(b.begin(), b.end(), 0.0) / n;
    double ab = 0, aa = 0, bb = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return ab / std::sqrt(aa * bb);
}

// Nodes put back onto the ground used to strain what had fallen, so that it broke up: 1264 cuts.
TEST(Corner, WhatHasFallenLiesOnTheGroundAndDoesNotTurnToPowder) {
    const Burn burn(Params{}, 20);
    ASSERT_TRUE(burn.last.ok()) << burn.last.reason;
    const SheetState& sheet = burn.world.state().sheets[0];
    double lowest = 1;
    int fallen = 0, sunk = 0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        lowest = std::min(lowest, sheet.position.y[n]);
        fallen += sheet.position.y[n] < 0.02 ? 1 : 0;
        sunk += sheet.position.y[n] < 0 ? 1 : 0;
    }
    std::printf("cuts at 20 s: %d, nodes on the ground: %d, %d sunk, lowest %.3f mm\n",
                static_cast<int>(burn.world.state().totals.cuts), fallen, sunk, 1e3 * lowest);
    EXPECT_GT(fallen, 500);
    EXPECT_GT(lowest, 0.0);
    EXPECT_LT(burn.world.state().totals.cuts, 900);
}

TEST(Corner, IgnitesBurnsAndCracksWithinTenSeconds) {
    const Burn burn(Params{}, 10);
    ASSERT_TRUE(burn.last.ok()) << burn.last.reason;
    EXPECT_GE(burn.first_ignition, 0.1);
    EXPECT_LE(burn.first_ignition, 2.0);
    EXPECT_GT(burn.burnt_share, 0.5);
    EXPECT_GT(burn.world.state().totals.cuts, 0);
    EXPECT_EQ(burn.world.state().sheets[0].quads.size(), 32u * 48u);
    EXPECT_TRUE(burn.finite);
    RecordProperty("burnt_share", std::to_string(burn.burnt_share));
}

TEST(Corner, TheFireSpreadsFromTheLighter) {
    const Params params;
    const Burn burn(params, 10);
    const SheetState& sheet = burn.world.state().sheets[0];
    // distance on the unburnt sheet, which hangs with its first row on the left
    std::vector<double> time, distance;
    for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
        if (!std::isfinite(sheet.ignition_time[n])) continue;
        const double row = static_cast<double>(n / 49), column = static_cast<double>(n % 49);
        const double x = -0.105 + row * 0.210 / 32,
                     y = params.sheet.elevation - column * 0.297 / 48;
        time.push_back(sheet.ignition_time[n]);
        distance.push_back(std::hypot(x - params.lighter.x, y - params.lighter.y));
    }
    ASSERT_GT(time.size(), 800u);
    const double r = correlation(ranks(time), ranks(distance));
    RecordProperty("rank_correlation", std::to_string(r));
    EXPECT_GE(r, 0.9);
}

TEST(Corner, WithoutALighterNothingIgnites) {
    Params params;
    params.lighter.on = false;
    EXPECT_EQ(Burn(params, 3).world.state().totals.ignitions, 0);
}

TEST(Corner, WithoutFireFromTheBurningNodesItGoesOutOrSlows) {
    Params params;
    params.fire.emission = 0;
    EXPECT_LT(Burn(params, 6).burnt_share, 0.5 * Burn(Params{}, 6).burnt_share);
}

TEST(Corner, WithoutShrinkingTheSheetStaysFlat) {
    Params params;
    params.shrinkage.factor = 0;
    EXPECT_LT(Burn(params, 4).out_of_plane, 0.2 * Burn(Params{}, 4).out_of_plane);
}

TEST(Corner, WithAnInfiniteThresholdNothingCracks) {
    Params params;
    params.fracture.threshold = std::numeric_limits<double>::infinity();
    const Burn burn(params, 8);
    EXPECT_EQ(burn.world.state().totals.cuts, 0);
    EXPECT_EQ(burn.world.state().sheets[0].mass.size(), 33u * 49u);
}

// Length of all cracks by burnt area [1/m], over three seeds: each cut is about one edge long.
double crack_density(double tick_rate, int rows, int columns) {
    double length = 0, area = 0;
    for (const std::int64_t seed : {1, 2, 3}) {
        Params p = test::small_sheet();
        p.fracture.rule = FractureRule::Stress;
        p.fracture.threshold = 0.025;
        p.fracture.ash_strength = 0.05;
        p.fracture.ash_time = 1;
        p.fracture.strength_noise = 0.3;
        p.sheet.rows = rows;
        p.sheet.columns = columns;
        p.numerics.tick_rate = tick_rate;
        p.numerics.seed = seed;
        const Burn burn(p, 5);
        EXPECT_TRUE(burn.last.ok()) << burn.last.reason;
        const double spacing = std::sqrt(p.sheet.width / rows * p.sheet.height / columns);
        length += spacing * static_cast<double>(burn.world.state().totals.cuts);
        area += burn.burnt_share * p.sheet.width * p.sheet.height;
    }
    return length / area;
}

TEST(StressCracks, TheirDensityDependsNeitherOnTheTickNorMuchOnTheLattice) {
    const double base = crack_density(60, 18, 24);
    const double ticks = crack_density(120, 18, 24), fine = crack_density(60, 27, 36);
    std::printf(
        "  cracks per burnt area [1/m]: %.1f, at 120 ticks per second %.1f, on a lattice "
        "1.5 times as fine %.1f\n",
        base, ticks, fine);
    EXPECT_GT(base, 5);
    EXPECT_NEAR(ticks / base, 1.0, 0.3);
    EXPECT_GT(fine / base, 1 / 1.6);
    EXPECT_LT(fine / base, 1.6);
}

}  // namespace
}  // namespace ember
