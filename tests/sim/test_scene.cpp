// What a scene may consist of, and what of it cannot be built.
#include <gtest/gtest.h>

#include <set>

#include "sim/lighter.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember {
namespace {

TEST(Scene, EdgesAndCornersAreHeldTogether) {
    const auto held = [](HeldEdge places) {
        Params p;
        p.sheet.rows = 2;
        p.sheet.columns = 3;
        p.sheet.held = places;
        const World world = make_world(p);
        std::string nodes;
        for (const std::uint8_t h : world.state().sheets[0].held)
            nodes += h != 0 ? 'x' : '.';
        return nodes;
    };
    EXPECT_EQ(held(HeldEdge::None), "............");
    EXPECT_EQ(held(HeldEdge::MainStart), "x...x...x...");
    EXPECT_EQ(held(HeldEdge::MainEnd), "...x...x...x");
    EXPECT_EQ(held(HeldEdge::BothMainEnds), "x..xx..xx..x");
    EXPECT_EQ(held(HeldEdge::BothCrossEnds), "xxxx....xxxx");
    EXPECT_EQ(held(HeldEdge::CornerMainStartCrossStart), "x...........");
    EXPECT_EQ(held(HeldEdge::CornerMainStartCrossEnd), "........x...");
    EXPECT_EQ(held(HeldEdge::CornerMainEndCrossStart), "...x........");
    EXPECT_EQ(held(HeldEdge::CornerMainEndCrossEnd), "...........x");
    EXPECT_EQ(held(HeldEdge::CrossStart | HeldEdge::MainEnd | HeldEdge::CornerMainStartCrossEnd),
              "xxxx...xx..x");
}

// The sheets of a scene that differ from the group as `overrides` say, key by key.
void add_sheet(Params& p, const std::vector<std::pair<std::string, ParamValue>>& overrides) {
    ParamOverrides& element = p.sheets.emplace_back();
    for (const auto& [key, value] : overrides)
        put_override(element, *find_param(sim_param_rows(), "sheet." + key), value);
}

std::string refusal(const Params& p) {
    try {
        (void)make_world(p);
    } catch (const SceneError& e) {
        return e.what();
    }
    return {};
}

Params small() {
    Params p;
    p.sheet.rows = 4;
    p.sheet.columns = 6;
    p.sheet.width = 0.04;
    p.sheet.height = 0.06;
    p.sheet.imperfection = 0;
    return p;
}

TEST(Scene, EverySheetHasItsOwnAndSharesTheRest) {
    Params p = small();
    add_sheet(p, {});
    add_sheet(p, {{"rows", 5.0}, {"x", 0.3}, {"held", 2.0}, {"name", std::string("second")}});
    World world = make_world(p);
    ASSERT_EQ(world.view().sheets.size(), 2u);
    EXPECT_EQ(world.view().sheets[0].row_count, 5);
    EXPECT_EQ(world.view().sheets[1].row_count, 6);
    EXPECT_EQ(world.view().sheets[1].column_count, 7);
    EXPECT_NEAR(world.view().sheets[1].x[0] - world.view().sheets[0].x[0], 0.3, 1e-15);
    EXPECT_EQ(world.scene().sheets[1].held, HeldEdge::MainEnd);
    p.sheet.columns = 8;  // shared, so it reaches both
    EXPECT_EQ(make_world(p).view().sheets[1].column_count, 9);
}

TEST(Scene, ATurnedSheetIsTheSameSheet) {
    Params p = small();
    const World straight = make_world(p);
    p.sheet.turn_x = 0.3;
    p.sheet.turn_y = 3.141592653589793 / 6;
    p.sheet.turn_z = -1.1;
    const World turned = make_world(p);
    const SheetState &a = straight.state().sheets[0], &b = turned.state().sheets[0];
    Vector3 middle_a = Vector3::Zero(), middle_b = Vector3::Zero();
    for (std::size_t n = 0; n < a.mass.size(); ++n) {
        middle_a += a.position.at(n) / 35.0;
        middle_b += b.position.at(n) / 35.0;
    }
    EXPECT_NEAR((middle_a - middle_b).norm(), 0, 1e-14);
    for (const SpringSegment& s : straight.springs(0)) {
        const auto length = [&](const SheetState& sheet) {
            return (sheet.position.at(static_cast<std::size_t>(s.a)) -
                    sheet.position.at(static_cast<std::size_t>(s.b)))
                .norm();
        };
        EXPECT_NEAR(length(a), length(b), 1e-14);
    }
    EXPECT_GT((a.position.at(0) - b.position.at(0)).norm(), 0.01);
}

TEST(Scene, TurnsGoAroundXThenYThenZ) {
    Params p = small();
    p.sheet.turn_x = 3.141592653589793 / 2;  // the upper edge comes to the viewer ...
    p.sheet.turn_y = 3.141592653589793 / 2;  // ... then turns to the right
    const SheetPlan plan = make_scene(p).sheets[0];
    EXPECT_NEAR((plan.main - Vector3(-1, 0, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((plan.cross - Vector3(0, 0, -1)).norm(), 0, 1e-15);
}

TEST(Scene, PointsHoldTheNearestNodeAndAllWithinTheirRadius) {
    Params p = small();  // nodes 10 mm apart
    p.sheet.held = HeldEdge::None;
    p.sheet.held_points = {{0.021, 0.019, 0}, {0.06, 0.0, 0.0101}};
    const World world = make_world(p);
    std::set<std::size_t> held;
    for (std::size_t n = 0; n < 35; ++n) {
        if (world.state().sheets[0].held[n] != 0) held.insert(n);
    }
    EXPECT_EQ(held, (std::set<std::size_t>{2 * 7 + 2, 6, 5, 7 + 6}));
    p.sheet.held_points = {{0.061, 0, 0}};
    EXPECT_EQ(refusal(p), "sheet.held_points: a point lies beyond the sheet");
}

TEST(Scene, SheetsThatCannotBeBuiltAreRefusedByName) {
    const auto message = [](Params p) {
        try {
            (void)make_world(p);
        } catch (const std::invalid_argument& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    Params zero;
    zero.sheet.width = 0;
    EXPECT_NE(message(zero).find("sheet.width"), std::string::npos);
    Params tube;
    tube.sheet.shape = SheetShape::Cylinder;
    tube.sheet.rows = 2;
    EXPECT_NE(message(tube).find("cylinder"), std::string::npos);
    tube.sheet.rows = 3;
    tube.sheet.held = HeldEdge::MainStart | HeldEdge::CrossEnd;
    EXPECT_NE(message(tube).find("sheet.held"), std::string::npos);
    Params huge;
    huge.sheet.rows = huge.sheet.columns = 1000000;
    EXPECT_NE(message(huge).find("4096"), std::string::npos);
}

TEST(Scene, SheetsInEachOtherAreRefusedByName) {
    Params p = small();
    add_sheet(p, {{"name", std::string("wall")}});
    add_sheet(p, {{"name", std::string("shelf")}, {"pose", 1.0}, {"elevation", 0.42}});
    EXPECT_EQ(refusal(p), "sheets.2: \"wall\" and \"shelf\" are in each other at the start");
    add_sheet(p, {});
    p.sheets.erase(p.sheets.begin() + 1);
    EXPECT_EQ(refusal(p), "sheets.2: \"wall\" and sheet 2 are in each other at the start");
    const ParamInfo& z = *find_param(sim_param_rows(), "sheet.z");
    put_override(p.sheets[1], z, 1e-4);
    EXPECT_EQ(refusal(p), "") << "1e-4 m apart, and half as thick";
    put_override(p.sheets[1], z, 5e-5);
    EXPECT_NE(refusal(p), "");
}

TEST(Scene, StacksAndTubesInTubesAreNotInEachOther) {
    Params p = small();
    p.sheet.count = 5;
    p.sheet.gap = 0.001;
    EXPECT_EQ(refusal(p), "");
    p.sheet.turn_x = 0.7;
    EXPECT_EQ(refusal(p), "");
    p.sheet.gap = 0;
    EXPECT_NE(refusal(p), "");
    Params tubes = small();
    tubes.sheet.shape = SheetShape::Cylinder;
    tubes.sheet.rows = 12;
    add_sheet(tubes, {});
    add_sheet(tubes, {{"width", 0.08}, {"x", 0.02}});
    EXPECT_EQ(refusal(tubes), "") << "one in the other, about the same axis";
    put_override(tubes.sheets[1], *find_param(sim_param_rows(), "sheet.x"), 0.012);
    EXPECT_NE(refusal(tubes), "") << "touching its side";
}

TEST(Scene, AHugeLatticeIsRefusedBeforeItIsMade) {
    Params p = small();
    p.sheet.rows = p.sheet.columns = 4095;
    p.sheet.count = 60;
    EXPECT_EQ(refusal(p), "sheet.rows: more than 4096 x 4096 nodes in all, here 60 x 4096 x 4096");
    p.sheet.count = 1;
    p.sheet.rows = 1 << 30;
    EXPECT_NE(refusal(p).find("more than 4096 x 4096 nodes"), std::string::npos);
    Params many = small();
    add_sheet(many, {});
    add_sheet(many, {{"rows", 4096.0}, {"columns", 4095.0}});
    EXPECT_EQ(refusal(many).find("sheets.2.rows: more than 4096 x 4096 nodes"), 0u);
}

TEST(Scene, AMaskWithoutAPictureOrWithoutPaperIsRefused) {
    Params p = small();
    p.sheet.mask = "m.png";
    EXPECT_EQ(refusal(p), "sheet.mask: no picture \"m.png\" has been read");
    auto image = std::make_shared<MaskImage>();
    *image = {"m.png", 8, 8, std::vector<std::uint8_t>(64, 0)};
    image->paper[9] = 1;
    p.masks = {image};
    EXPECT_EQ(refusal(p), "sheet.mask: \"m.png\" leaves no paper on a lattice of 4 x 6 cells");
}

TEST(Lighter, OnAPathItPassesWhereItShouldWhenItShould) {
    LighterParams lighter;
    lighter.path = {{1, 0, 0, 0}, {2, 0.1, 0.2, 0}, {4, 0.1, 0.2, 0.4}};
    const auto at = [&](double time) { return lighter_position(lighter, time); };
    EXPECT_EQ(at(0), Vector3(0, 0, 0));
    EXPECT_NEAR((at(1.5) - Vector3(0.05, 0.1, 0)).norm(), 0, 1e-16);
    EXPECT_EQ(at(2), Vector3(0.1, 0.2, 0));
    EXPECT_NEAR((at(3) - Vector3(0.1, 0.2, 0.2)).norm(), 0, 1e-16);
    EXPECT_EQ(at(9), Vector3(0.1, 0.2, 0.4));
}

TEST(Lighter, EveryLighterBurnsInItsOwnTimeAndPlace) {
    Params p = small();
    const ParamInfo& start = *find_param(sim_param_rows(), "lighter.start");
    const ParamInfo& x = *find_param(sim_param_rows(), "lighter.x");
    const ParamInfo& path = *find_param(sim_param_rows(), "lighter.path");
    p.lighter.y = 1;
    p.lighter.duration = 0.5;
    p.lighter.radius = 0;
    p.lighters.resize(2);
    put_override(p.lighters[0], x, -1.0);
    put_override(p.lighters[1], start, 1.0);
    put_override(p.lighters[1], path, std::vector<double>{1, 1, 1, 0, 1.5, 2, 1, 0});
    World world = make_world(p);
    std::size_t left = 0, right = 0;
    for (int i = 0; i < 90; ++i) {
        ASSERT_TRUE(world.step().ok());
        const WorldView view = world.view();
        ASSERT_EQ(view.lighters.size(), 2u);
        for (std::size_t k = 0; k < view.particles.x.size(); ++k) {
            const double born = view.particles.birth[k];
            // born where the lighter was at that moment; 0.7 m to either side is not flown
            const double from = born < 0.5 ? -1.0 : 1 + 2 * (born - 1.0);
            EXPECT_NEAR(view.particles.x[k], from, 0.3);
            (born < 0.5 ? left : right) += 1;
            EXPECT_TRUE(born < 0.5 || born >= 1.0);
        }
    }
    EXPECT_GT(left, 100u);
    EXPECT_GT(right, 100u);
    EXPECT_FALSE(world.view().lighters[0].lit);
}

TEST(Lighter, EditingTheFirstReachesItAlone) {
    Params p;
    p.lighters.resize(2);
    LighterParams first = lighters_of(p)[0];
    first.x = 0.5;
    first.path = {{0, 1, 2, 3}};
    set_lighter(p, 0, first);
    EXPECT_EQ(lighters_of(p)[0].x, 0.5);
    EXPECT_EQ(lighters_of(p)[0].path, first.path);
    EXPECT_EQ(lighters_of(p)[1].x, Params().lighter.x);
    World world = make_world(small());
    Params live = small();
    live.lighters.resize(1);
    EXPECT_TRUE(world.apply(live)) << "lighters are live";
    live.sheets.resize(1);
    EXPECT_FALSE(world.apply(live)) << "sheets are not";
}

}  // namespace
}  // namespace ember
