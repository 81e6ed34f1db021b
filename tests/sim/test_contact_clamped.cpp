// Contact where nothing can give way: sheets that are held closer than they would keep.
#include <gtest/gtest.h>

#include <cmath>

#include "rig.h"
#include "sim/world.h"

namespace ember {
namespace {

Params clamped() {
    Params p = test::plain(6, 9);
    p.springs.stiffness_scale = 40;
    p.sheet.held = HeldEdge::MainStart;
    p.contact.thickness = 0.005;
    return p;
}

void run(World& world, double seconds) {
    std::int64_t contacts = 0;
    while (world.state().time < seconds) {
        const StepReport report = world.step();
        ASSERT_TRUE(report.ok()) << cause_text(report);
        contacts += report.counters.contacts;
    }
    EXPECT_GT(contacts, 0);
}

// What is asked for near the clips cannot be had.
TEST(ContactClamped, SheetsThatAreHeldTooCloseAreNotTornApart) {
    for (const double friction : {0.0, 0.4}) {
        Params p = clamped();
        p.contact.friction = friction;
        Scene scene;
        for (const double height : {0.0, 1e-4, 2e-4}) {
            scene.sheets.push_back(make_scene(p).sheets[0]);
            scene.sheets.back().origin = Vector3(0, height, 0);
        }
        World world(scene, p, 1);
        run(world, 0.3);
        const double reach = 1.2 * std::hypot(p.sheet.width, p.sheet.height);
        for (const SheetState& sheet : world.state().sheets) {
            for (std::size_t n = 0; n < sheet.mass.size(); ++n)
                EXPECT_LT(sheet.position.at(n).norm(), reach);
        }
    }
}

TEST(ContactClamped, TheLeavesOfAPadLieAsCloseAsTheyWereStacked) {
    Params p = clamped();
    p.sheet.count = 3;
    p.sheet.gap = 2e-4;
    World world(make_scene(p), p, 1);
    run(world, 0.3);
    EXPECT_LT(world.state().energy.kinetic, 1e-12);
}

}  // namespace
}  // namespace ember
