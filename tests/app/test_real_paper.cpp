// Two grades of paper on short strips: the reduced form of `emberleaf bench validate`.
#include <gtest/gtest.h>

#include "app/bench/bench_run.h"
#include "app/bench/validate_table.h"

namespace ember {
namespace {

constexpr double kCoarse = 0.00625, kFine = 0.003125;  // [m]

StripRun horizontal(const Params& params, double cell) {
    const StripRun run = run_strip(params, Spread::Horizontal, cell);
    EXPECT_EQ(run.failure, "");
    EXPECT_GT(run.front.r_squared, 0.98);
    return run;
}

void expect_like_paper(const StripRun& run) {
    EXPECT_GE(run.spread_rate, kLeastSpreadRate);
    EXPECT_LE(run.spread_rate, kMostSpreadRate);
}

// Office paper that stays flat, so that nothing but fire and heat is measured.
Params flat_office() {
    Params params = bench_params("real/office");
    params.world.gravity = 0;
    params.shrinkage.factor = 0;
    params.springs.stiffness_scale = 0.01;
    params.sheet.imperfection = 0;
    return params;
}

TEST(RealPaper, AHangingA4StretchesByLessThanHalfAPercentAndBendsLittle) {
    Params params = bench_params("real/office");
    params.lighter.on = false;
    params.sheet.width = 0.210, params.sheet.height = 0.297;
    params.sheet.rows = 32, params.sheet.columns = 48;
    World world = make_world(params);
    const double cell = params.sheet.height / params.sheet.columns;
    const Index columns = params.sheet.columns + 1;
    const SheetState& sheet = world.state().sheets[0];
    double most = 0;
    for (int tick = 0; tick < 60; ++tick) {  // it starts unstretched and swings
        ASSERT_TRUE(world.step().ok());
        for (Index site = 0; site < columns * (params.sheet.rows + 1); ++site) {
            if (site % columns == columns - 1) continue;
            const auto n = static_cast<std::size_t>(site);
            const double length = (sheet.position.at(n + 1) - sheet.position.at(n)).norm();
            most = std::max(most, length / cell - 1);
        }
    }
    RecordProperty("strain", std::to_string(most));
    EXPECT_LT(most, 0.005);
    EXPECT_GT(most, 0.0005);  // and is no board
}

TEST(RealPaper, FrontsMoveAtASpeedInverseToTheGrammage) {
    expect_like_paper(horizontal(bench_params("real/office"), kCoarse));
    expect_like_paper(horizontal(bench_params("real/kraft"), kCoarse));
}

TEST(RealPaper, TheSpeedDependsNeitherOnTheLatticeNorOnTheTick) {
    const Params usual = flat_office();
    Params half = usual;
    half.numerics.tick_rate *= 2;
    const double coarse = horizontal(usual, kCoarse).front.speed;
    EXPECT_NEAR(horizontal(usual, kFine).front.speed, coarse, 0.05 * coarse);
    EXPECT_NEAR(horizontal(half, kCoarse).front.speed, coarse, 0.01 * coarse);
}

TEST(RealPaper, FireClimbsFasterThanItCreepsAndCreepsFasterThanItDescends) {
    const Params params = flat_office();
    const double up = run_strip(params, Spread::Up, kCoarse).front.speed;
    const double flat = run_strip(params, Spread::Horizontal, kCoarse).front.speed;
    const double down = run_strip(params, Spread::Down, kCoarse).front.speed;
    EXPECT_GT(up, 2 * flat);
    EXPECT_GT(flat, 1.5 * down);
    EXPECT_GT(down, 0);
}

}  // namespace
}  // namespace ember
