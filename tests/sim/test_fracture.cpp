// Which burnt springs break (section 4.4), and what rests afterwards.
#include "sim/fracture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "rig.h"
#include "sim/relief.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

// Part of each sector of the fan of a site: "0011", '.' where there is no quad.
std::string fan(const Rig& rig, Index row, Index column) {
    const Index site = rig.lattice.site(row, column);
    std::string text;
    for (const int part :
         fan_parts(rig.lattice, site, rig.sheet.glue[static_cast<std::size_t>(site)]))
        text += part < 0 ? '.' : static_cast<char>('0' + part);
    return text;
}

// A burnt strip pulled apart: every bending spring along it is too long.
Rig pulled_strip(double stretch) {
    Params p = plain(1, 12);
    p.fracture.relief_radius = 0.025;
    p.fracture.relief_time = 0.1;
    Rig rig(p);
    rig.sheet.phase.assign(rig.sheet.phase.size(), Phase::BurntOut);
    for (double& x : rig.sheet.position.x)
        x *= 1 + stretch;
    return rig;
}

std::int64_t break_strip(Rig& rig, double time) {
    ActiveNodes active;
    find_active(rig.lattice, rig.sheet, active);
    const std::vector<Index> none;
    const auto cuts = break_ash({rig.lattice, rig.params, rig.network, active, 0, time, none},
                                rig.sheet, rig.counters);
    rig.refresh();
    return cuts;
}

TEST(Fracture, NothingBreaksBelowTheThresholdOrUnburnt) {
    Rig below = pulled_strip(0.0119);
    EXPECT_EQ(break_strip(below, 0), 0);
    Rig above = pulled_strip(0.0121);
    EXPECT_GT(break_strip(above, 0), 0);
    Rig burning = pulled_strip(0.1);
    burning.sheet.phase.assign(burning.sheet.phase.size(), Phase::Burning);
    EXPECT_EQ(break_strip(burning, 0), 0);
    Rig never = pulled_strip(0.5);
    never.params.fracture.threshold = std::numeric_limits<double>::infinity();
    EXPECT_EQ(break_strip(never, 0), 0);
}

TEST(Fracture, TheMiddleNodeMustBeBurntUnlessThePaperIsTakenByTheLetter) {
    for (const bool middle_burnt : {true, false}) {
        Rig rig = pulled_strip(0.1);
        rig.params.fracture.middle_burnt = middle_burnt;
        for (Index c = 1; c < 12; c += 2) {
            for (Index r = 0; r < 2; ++r)
                rig.sheet.phase[rig.site(r, c)] = Phase::Burning;
        }
        if (middle_burnt) {
            EXPECT_EQ(break_strip(rig, 0), 0);
        } else {
            EXPECT_GT(break_strip(rig, 0), 0);
        }
    }
}

// At cuts springs are in a list of their own; all others are taken out here.
TEST(Fracture, TheSameIsTrueOfSpringsAtCuts) {
    for (const bool middle : {false, true}) {
        Rig rig = pulled_strip(0.1);
        rig.sheet.phase[rig.site(0, 3)] = middle ? Phase::BurntOut : Phase::Burning;
        std::fill(rig.network.weight.begin(), rig.network.weight.end(), 0.0);
        const Index a = rig.lattice.site(0, 2), b = rig.lattice.site(0, 4);
        rig.network.extra = {{a, b, rig.lattice.slot(Slot::BendMain, a), 1.0}};
        EXPECT_EQ(break_strip(rig, 0) > 0, middle);
    }
}

TEST(Relief, IsADiscAroundTheCut) {
    Rig rig(plain(10, 10));  // cells of 10 mm
    relieve(rig.lattice, rig.lattice.site(5, 5), 0.025, 7.0, rig.sheet);
    for (Index r = 0; r <= 10; ++r) {
        for (Index c = 0; c <= 10; ++c) {
            const bool inside = (r - 5) * (r - 5) + (c - 5) * (c - 5) <= 6;
            EXPECT_EQ(rig.sheet.relief_until[rig.site(r, c)], inside ? 7.0 : 0.0) << r << ", " << c;
        }
    }
}

TEST(Fracture, TheWorstSpringGoesFirstAndItsNeighbourhoodRests) {
    Rig rig = pulled_strip(0.05);
    rig.params.fracture.release_hinges = false;
    for (Index r = 0; r < 2; ++r)
        rig.sheet.position.x[rig.site(r, 7)] += 0.004;
    // the longest spring ends at column 7, its middle is column 6, and sites within 25 mm rest
    break_strip(rig, 0.0);
    EXPECT_EQ(fan(rig, 0, 6), "01..");
    EXPECT_EQ(fan(rig, 0, 5), "00..");
    EXPECT_EQ(fan(rig, 0, 7), "00..");
    EXPECT_EQ(break_strip(rig, 0.05), 0);  // still resting
    EXPECT_GT(break_strip(rig, 0.11), 0);  // rested
}

TEST(Fracture, WithoutReliefEverythingOverStretchedBreaksAtOnce) {
    Rig rig = pulled_strip(0.05);
    rig.params.fracture.relief_time = 0;
    rig.params.fracture.release_hinges = false;
    EXPECT_EQ(break_strip(rig, 0), 2 * 11);
}

}  // namespace
}  // namespace ember
