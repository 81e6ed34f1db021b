// Runs that the energy ledger must be content with. That it notices errors is seen with mutants
// (tests/mutants): springs that push back 1 % too hard make this fail.
#include <gtest/gtest.h>

#include "sim/world.h"

namespace ember {
namespace {

TEST(EnergyLedger, AccountsForTheSwingOfASoftSheetWithoutARetry) {
    Params p;  // the paper's soft sheet, swinging: the benchmark without its fire
    p.sheet.pose = SheetPose::Horizontal;
    p.springs.stiffness_scale = 1;
    p.world.air_drag = 0;
    p.world.ground = false;
    p.lighter.on = false;
    World world = make_world(p);
    StepReport report;
    for (int i = 0; i < 240 && report.ok(); ++i)
        report = world.step();
    EXPECT_TRUE(report.ok()) << "stage " << kStageNames[static_cast<std::size_t>(report.stage)]
                             << ", node " << report.node << ": " << report.reason;
    EXPECT_EQ(world.state().totals.retries, 0);
}

}  // namespace
}  // namespace ember
