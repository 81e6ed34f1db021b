// Sheets of any outline: what is there, what is not, and that nothing passes through a hole.
#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "rig.h"
#include "sim/heat.h"
#include "sim/topology.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

// A picture of '#' for paper, one line of the picture each.
std::shared_ptr<const MaskImage> picture(const std::vector<std::string>& lines) {
    auto image = std::make_shared<MaskImage>();
    image->name = "m.png";
    image->width = static_cast<int>(lines[0].size());
    image->height = static_cast<int>(lines.size());
    for (const std::string& line : lines) {
        for (const char c : line)
            image->paper.push_back(c == '#' ? 1 : 0);
    }
    return image;
}

// A lattice with one cell per pixel: x of the picture is across, y is along.
Params masked(const std::vector<std::string>& lines) {
    Params p = plain(static_cast<int>(lines[0].size()), static_cast<int>(lines.size()));
    p.sheet.mask = "m.png";
    p.masks = {picture(lines)};
    return p;
}

const std::vector<std::string> kRing = {"#####", "#...#", "#...#", "#####"};

TEST(Mask, ACellIsPaperWhereHalfOfItIs) {
    const auto whole = picture({"#.", ".#"});
    EXPECT_EQ(paper_cells(*whole, 2, 2), (std::vector<std::uint8_t>{1, 0, 0, 1}));
    EXPECT_EQ(paper_cells(*whole, 1, 1), (std::vector<std::uint8_t>{1})) << "exactly half";
    EXPECT_EQ(paper_cells(*picture({"#.", ".."}), 1, 1), (std::vector<std::uint8_t>{0}));
    const std::vector<std::uint8_t> finer = paper_cells(*whole, 4, 6);
    EXPECT_EQ(std::accumulate(finer.begin(), finer.end(), 0), 12);
    // rows are across, columns along: the picture's upper right corner is row 1, column 0
    EXPECT_EQ(paper_cells(*picture({".#", ".."}), 2, 2), (std::vector<std::uint8_t>{0, 0, 1, 0}));
    // one pixel in three cells: the middle one sees it all
    EXPECT_EQ(paper_cells(*picture({".#."}), 5, 1), (std::vector<std::uint8_t>{0, 0, 1, 0, 0}));
}

TEST(Mask, TheSheetWeighsWhatItsCellsWeigh) {
    for (const Border border : {Border::Tributary, Border::Uniform}) {
        Params p = masked(kRing);
        p.sheet.border = border;
        const Rig rig(p);
        const double mass = std::accumulate(rig.sheet.mass.begin(), rig.sheet.mass.end(), 0.0);
        EXPECT_NEAR(mass, p.paper.grammage * 14 * 1e-4, 1e-16);
        EXPECT_EQ(rig.sheet.quads.size(), 14u);
        for (const Quad& quad : rig.sheet.quads) {
            EXPECT_EQ(std::set<Index>(quad.begin(), quad.end()).size(), 4u);
            for (const Index node : quad)
                EXPECT_GT(rig.sheet.mass[static_cast<std::size_t>(node)], 0);
        }
    }
}

TEST(Mask, WhereThereIsNoPaperNothingIsHeavyTiedOrFree) {
    Rig rig(masked(kRing));
    int bare = 0;
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        if (rig.sheet.mass[n] > 0) continue;
        ++bare;
        EXPECT_EQ(rig.loads.inverse_mass[n], 0.0);
    }
    EXPECT_EQ(bare, 2) << "the nodes in the middle of a hole of 3 x 2 cells";
    for_each_spring(rig.lattice, rig.network, [&](Index a, Index b, Index, double k, double) {
        EXPECT_GT(k, 0.0);
        EXPECT_GT(rig.sheet.mass[static_cast<std::size_t>(a)], 0.0);
        EXPECT_GT(rig.sheet.mass[static_cast<std::size_t>(b)], 0.0);
    });
    EXPECT_GT(rig.fastest().omega, 0.0);
    EXPECT_EQ(find_pieces(rig.sheet), 1);
}

TEST(Mask, ABorderOfTheHoleIsLikeABorderOfTheSheet) {
    const Rig rig(masked(kRing));
    // along the upper rim of the hole, site (2, 1): two quads above it, none below
    EXPECT_NEAR(rig.sheet.mass[rig.site(2, 1)], 0.5 * 0.080 * 1e-4, 1e-18);
    const auto slot =
        static_cast<std::size_t>(rig.lattice.slot(Slot::Cross, rig.lattice.site(1, 1)));
    EXPECT_EQ(rig.network.weight[slot], 0.5);
}

TEST(Mask, WhatTouchesAtACornerAloneIsApart) {
    Rig rig(masked({"#.", ".#"}));
    EXPECT_EQ(rig.sheet.quads.size(), 2u);
    EXPECT_EQ(rig.sheet.mass.size(), 10u) << "the middle has two nodes";
    EXPECT_EQ(find_pieces(rig.sheet), 2);
    EXPECT_NEAR(std::accumulate(rig.sheet.mass.begin(), rig.sheet.mass.end(), 0.0),
                2 * 0.080 * 1e-4, 1e-18);
}

TEST(Mask, APieceThatHangsOnNothingFalls) {
    Params p = masked({"###", "...", "###"});
    p.sheet.held = HeldEdge::MainStart;
    p.sheet.pose = SheetPose::Hanging;
    p.sheet.elevation = 5;
    p.world.gravity = 9.81;
    World world = make_world(p);
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(world.step().ok());
    const SheetState& sheet = world.state().sheets[0];
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (!(sheet.mass[n] > 0)) continue;
        const Index column = sheet.site[n] % 4;
        const double fallen = 5 - 0.01 * column - sheet.position.y[n];
        if (column < 2) {
            EXPECT_LT(fallen, 0.01);
        } else {
            EXPECT_NEAR(fallen, 0.5 * 9.81 * 0.25, 1e-6);
        }
    }
}

TEST(Mask, HeatDoesNotCrossAHole) {
    for (const HeatSolverKind solver :
         {HeatSolverKind::Ftcs, HeatSolverKind::Rkl2, HeatSolverKind::Adi}) {
        Params p = masked({"####", "####", "....", "####", "####"});
        p.heat.convection = 0;
        p.numerics.heat_solver = solver;
        Rig rig(p);
        HeatScratch scratch;
        rebuild_heat(rig.lattice, rig.sheet, rig.network, p.paper, scratch);
        for (Index row = 0; row < 5; ++row)
            rig.sheet.temperature[rig.site(row, 0)] = 900;
        for (int i = 0; i < 200; ++i)
            conduct_heat(rig.sheet, p, 0.1, 1, scratch, rig.counters);
        for (Index row = 0; row < 5; ++row) {
            EXPECT_GT(rig.sheet.temperature[rig.site(row, 2)], p.heat.ambient + 10);
            for (Index column = 3; column < 6; ++column)
                EXPECT_EQ(rig.sheet.temperature[rig.site(row, column)], p.heat.ambient);
        }
    }
}

TEST(Mask, ASymmetricSheetStaysSymmetric) {
    Params p = masked({"#.####.#", "########", "##....##", "##....##", "###..###", "########"});
    p.sheet.pose = SheetPose::Hanging;
    p.sheet.held = HeldEdge::MainStart;
    p.sheet.turn_x = 0.3;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.3;
    p.springs.stiffness_scale = 10;
    World world = make_world(p);
    for (int i = 0; i < 40; ++i)
        ASSERT_TRUE(world.step().ok());
    const SheetState& sheet = world.state().sheets[0];
    double moved = 0;
    for (Index row = 0; row < 9; ++row) {
        for (Index column = 0; column < 7; ++column) {
            const auto a = static_cast<std::size_t>(row * 7 + column);
            const auto b = static_cast<std::size_t>((8 - row) * 7 + column);
            EXPECT_NEAR(sheet.position.x[a], -sheet.position.x[b], 1e-10);
            EXPECT_NEAR(sheet.position.y[a], sheet.position.y[b], 1e-10);
            EXPECT_NEAR(sheet.position.z[a], sheet.position.z[b], 1e-10);
            moved = std::max(moved, sheet.velocity.at(a).norm());
        }
    }
    EXPECT_GT(moved, 0.01);
}

TEST(Mask, AMaskOfPaperAloneIsNoMask) {
    Params p = masked({"####", "####", "####"});
    p.world.gravity = 9.81;
    p.sheet.held = HeldEdge::MainStart;
    World with = make_world(p);
    p.sheet.mask.clear();
    World without = make_world(p);
    for (int i = 0; i < 5; ++i) {
        ASSERT_TRUE(with.step().ok());
        ASSERT_TRUE(without.step().ok());
    }
    EXPECT_EQ(with.hash(), without.hash());
}

}  // namespace
}  // namespace ember
