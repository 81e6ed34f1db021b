// The stress bench itself, as people run it: nothing fails far outside what is usual.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/bench/state_oracle.h"
#include "app/bench/stress_case.h"
#include "app/bench/stress_run.h"
#include "child.h"
#include "temporary_folder.h"

namespace ember {
namespace {

TEST(Stress, TwoHundredCasesAndAllCornersEndWell) {
    const TemporaryFolder folder;
    ChildOptions options;
    options.folder = folder.path();
    const ChildResult result = run_emberleaf(
        {"bench", "stress", "--cases", "200", "--seed", "1", "--threads", "2"}, options);
    EXPECT_EQ(result.code, 0) << result.out << result.err;
    EXPECT_EQ(folder.files(), (std::set<std::string>{"out", "out/bench", "out/bench/stress.csv",
                                                     "out/bench/stress.svg"}));
    const std::string table = folder.read("out/bench/stress.csv");
    EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 480) << "corners, faults, random cases";
}

TEST(Stress, TheOracleSeesEveryPlantedError) {
    Params params;
    params.sheet.rows = 4;
    params.sheet.columns = 6;
    World world = make_world(params);
    ASSERT_TRUE(world.step().ok());
    const WorldState good = world.snapshot();
    const auto problem = [&](auto spoil) {
        WorldState bad = good;
        spoil(bad, bad.sheets.front());
        return StateOracle(params, good).problem(params, bad);
    };
    EXPECT_EQ(problem([](WorldState&, SheetState&) {}), "");
    EXPECT_NE(problem([](WorldState&, SheetState& s) { s.position.x[3] /= 0.0; }), "");
    EXPECT_NE(problem([](WorldState& w, SheetState&) { w.energy.loss_drag /= 0.0; }), "");
    EXPECT_NE(problem([](WorldState&, SheetState& s) { s.temperature[3] = 200; }), "");
    EXPECT_NE(problem([](WorldState&, SheetState& s) { s.temperature[3] = 1e4; }), "");
    EXPECT_NE(problem([](WorldState&, SheetState& s) { s.mass[3] *= 1.001; }), "");
    EXPECT_NE(problem([](WorldState&, SheetState& s) { s.velocity.y[3] += 1; }), "");
    EXPECT_NE(problem([](WorldState& w, SheetState&) { w.energy.kinetic += 1e-3; }), "");
    EXPECT_NE(problem([](WorldState& w, SheetState&) { w.heat.lost_air += 1e-6; }), "");
}

TEST(Stress, CasesDependOnTheSeedAloneAndAreWithinTheHardRanges) {
    const std::vector<StressCase> once = random_cases(50, 3), again = random_cases(50, 3),
                                  other = random_cases(50, 4);
    ASSERT_EQ(once.size(), 50u);
    for (std::size_t i = 0; i < once.size(); ++i) {
        EXPECT_EQ(once[i].sets, again[i].sets);
        EXPECT_NE(once[i].sets, other[i].sets);
        EXPECT_NO_THROW(static_cast<void>(stress_params(once[i])));
    }
    EXPECT_GE(corner_cases().size(), 40u);
}

TEST(Stress, AnUnnoticedFaultFailsTheCase) {
    StressCase harmless = corner_cases().front();
    ASSERT_EQ(run_stress(harmless, false).end, StressEnd::Ran);
    harmless.demand = StressDemand::Stops;
    EXPECT_EQ(run_stress(harmless, false).end, StressEnd::Failed);
}

TEST(FloatTraps, NoteADivisionByZeroAndLetItGoOn) {
    if (!FloatTraps::available()) GTEST_SKIP() << "only on x86-64 Linux";
    FloatTraps watch;
    volatile double zero = 0.0, one = 1.0;
    watch.begin(Stage::Heat);
    const volatile double quotient = one / zero;
    watch.end(Stage::Heat);
    EXPECT_GT(quotient, 1e300);
    const std::vector<FloatTrap> traps = watch.take();
    ASSERT_EQ(traps.size(), 1u);
    EXPECT_EQ(traps[0].stage, Stage::Heat);
    watch.begin(Stage::Heat);
    const volatile double fine = one / one;
    watch.end(Stage::Heat);
    EXPECT_EQ(fine, 1.0);
    EXPECT_TRUE(watch.take().empty());
}

}  // namespace
}  // namespace ember
