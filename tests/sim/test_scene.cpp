// What a scene may consist of, and what of it cannot be built.
#include <gtest/gtest.h>

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

}  // namespace
}  // namespace ember
