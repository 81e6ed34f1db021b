// Linked against a build of the library in which every spring pushes back 1 % too hard: the energy
// ledger must notice. Without this test a ledger that never fails would look like a sound one.
#include <gtest/gtest.h>

#include "sim/world.h"

namespace ember {
namespace {

TEST(EnergyLedger, NoticesASpringLawThatBreaksNewtonsThirdByOnePerCent) {
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
#ifdef EMBERLEAF_PLANT_FORCE_ERROR
    EXPECT_EQ(report.status, StepStatus::Diverged);
    EXPECT_EQ(report.stage, Stage::Springs);
    EXPECT_NE(report.reason.find("energy"), std::string::npos) << report.reason;
    EXPECT_GE(report.node, 0);
#else
    EXPECT_TRUE(report.ok()) << report.reason;
    EXPECT_EQ(world.state().totals.retries, 0);
#endif
}

}  // namespace
}  // namespace ember
