// Where the lighter goes.
#include <gtest/gtest.h>

#include "sim/world.h"
#include "ui/lighter_placement.h"
#include "ui/pick.h"

namespace ember {
namespace {

TEST(LighterPlacement, CornersAreBelowTheLowerRimOfAHangingSheet) {
    const Params params;
    const World world = make_world(params);
    const SheetView sheet = world.view().sheets.front();
    const auto left = lighter_below(sheet, LighterSpot::LeftCorner);
    const auto middle = lighter_below(sheet, LighterSpot::Middle);
    const auto right = lighter_below(sheet, LighterSpot::RightCorner);
    ASSERT_TRUE(left && middle && right);
    const double below = params.sheet.elevation - params.sheet.height - 0.020;
    EXPECT_NEAR(left->y(), below, 1e-3);
    EXPECT_NEAR(left->x(), -0.5 * params.sheet.width + 0.005, 1e-3);
    EXPECT_NEAR(middle->x(), 0.0, 1e-3);
    EXPECT_NEAR(right->x(), 0.5 * params.sheet.width - 0.005, 1e-3);
}

TEST(LighterPlacement, NothingIsOfferedWhenEverythingHasBurntOut) {
    World world = make_world(Params{});
    WorldState state = world.snapshot();
    for (Phase& phase : state.sheets[0].phase)
        phase = Phase::BurntOut;
    world.restore(state);
    EXPECT_FALSE(lighter_below(world.view().sheets.front(), LighterSpot::Middle).has_value());
}

TEST(LighterPlacement, ARayMeetsThePaperWhereItHangs) {
    const Params params;
    const World world = make_world(params);
    const Vector3 eye(0.03, 0.3, 1.0), towards(0, 0, -1);
    const auto hit = pick(world.view(), params, eye, towards);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->x(), 0.03, 1e-12);
    EXPECT_NEAR(hit->y(), 0.3, 1e-12);
    EXPECT_NEAR(hit->z(), 0.0, 2 * params.sheet.imperfection);
}

TEST(LighterPlacement, ARayBesideThePaperMeetsItsPlane) {
    const Params params;
    const World world = make_world(params);
    const auto hit = pick(world.view(), params, {0.5, 0.3, 1.0}, Vector3(0, 0, -1));
    ASSERT_TRUE(hit);
    EXPECT_NEAR((*hit - Vector3(0.5, 0.3, 0.0)).norm(), 0.0, 1e-12);
    EXPECT_FALSE(pick(world.view(), params, {0.5, 0.3, 1.0}, Vector3(0, 0, 1)).has_value());
}

TEST(LighterPlacement, AMovedLighterBurnsFromNowOnUnlessItDoesAlready) {
    LighterParams lighter;
    lighter.on = false;
    move_lighter(lighter, {0.01, 0.02, 0.03}, false, 7.0);
    EXPECT_TRUE(lighter.on);
    EXPECT_EQ(lighter.start, 7.0);
    EXPECT_DOUBLE_EQ(lighter.x, 0.01);
    move_lighter(lighter, {0.04, 0.02, 0.03}, true, 8.0);
    EXPECT_EQ(lighter.start, 7.0) << "a burning lighter is only carried";
    EXPECT_DOUBLE_EQ(lighter.x, 0.04);
}

TEST(LighterPath, HoldsItsPlaceUntilJustBeforeAndForgetsTheFuture) {
    LighterParams lighter;
    lighter.x = 1;
    extend_path(lighter, 2.0, 0.1);
    lighter.x = 3;
    extend_path(lighter, 5.0, 0.1);
    ASSERT_EQ(lighter.path.size(), 3u);
    EXPECT_DOUBLE_EQ(lighter.path[1][0], 4.9);
    EXPECT_EQ(lighter.path[1][1], 1);
    EXPECT_EQ(lighter.path[2][1], 3);
    lighter.x = 7;
    extend_path(lighter, 2.05, 0.1);
    ASSERT_EQ(lighter.path.size(), 2u) << "what came later is given up";
    EXPECT_EQ(lighter.path[1][1], 7);
}

}  // namespace
}  // namespace ember
