// Cuts by picture. In the pictures `+` is a site, `=` and `‖` the cut, letters are nodes.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "rig.h"
#include "sim/random.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

Index cut(Rig& rig, Index row, Index column, CutLine line) {
    const Index added = cut_site(rig.lattice, rig.sheet, rig.lattice.site(row, column), line);
    rig.refresh();
    return added;
}

Index node(const Rig& rig, Index site, int sector) {
    const Index cell = rig.lattice.sector_cell(site, sector);
    if (cell == kNone) return kNone;
    return rig.sheet.quads[static_cast<std::size_t>(cell)][static_cast<std::size_t>(sector)];
}

// Node of each sector around a site: "0012" means sectors 0 and 1 share the first, ...; '.' no
// quad.
std::string fan(const Rig& rig, Index row, Index column) {
    std::map<Index, char> names;
    std::string text;
    for (int k = 0; k < 4; ++k) {
        const Index n = node(rig, rig.lattice.site(row, column), k);
        if (n == kNone) {
            text += '.';
            continue;
        }
        const auto [it, fresh] = names.try_emplace(n, static_cast<char>('0' + names.size()));
        text += it->second;
    }
    return text;
}

double total_mass(const Rig& rig) {
    double sum = 0;
    for (const double m : rig.sheet.mass)
        sum += m;
    return sum;
}

// Number and total stiffness of springs between two sites, over all copies.
std::pair<int, double> springs_between(const Rig& rig, Index site_a, Index site_b) {
    int count = 0;
    double stiffness = 0;
    for_each_spring(rig.lattice, rig.network, [&](Index a, Index b, Index, double k, double) {
        const Index sa = rig.sheet.site[static_cast<std::size_t>(a)];
        const Index sb = rig.sheet.site[static_cast<std::size_t>(b)];
        if ((sa == site_a && sb == site_b) || (sa == site_b && sb == site_a)) {
            ++count;
            stiffness += k;
        }
    });
    return {count, stiffness};
}

//   + + +        The middle node is cut along the cross direction (z, downwards in the picture):
//   + A‖B +      its left quads keep node A, its right ones get B. The bending spring across the
//   + + +        cut is gone, the one along the cut is shared out, edges on the cut are doubled.
TEST(Cut, AnInteriorSiteOpensInTwo) {
    Rig rig(plain(4, 4));
    const double mass = total_mass(rig), k = springs_between(rig, 12, 17).second;
    EXPECT_EQ(cut(rig, 2, 2, CutLine::AlongCross), 1);
    EXPECT_EQ(fan(rig, 2, 2), "0110");
    EXPECT_EQ(rig.sheet.mass.size(), 26u);
    EXPECT_NEAR(total_mass(rig) / mass, 1.0, 1e-15);
    EXPECT_EQ(rig.sheet.mass[12], rig.sheet.mass[25]);
    EXPECT_EQ(springs_between(rig, 11, 13).first, 0);  // bending across the cut
    EXPECT_EQ(springs_between(rig, 7, 17).first, 1);   // bending along it: same two end nodes
    EXPECT_EQ(springs_between(rig, 12, 17).first, 2);  // edge on the cut, once per copy
    EXPECT_NEAR(springs_between(rig, 12, 17).second / k, 1.0, 1e-14);  // k/2 each
    EXPECT_EQ(springs_between(rig, 12, 13).first, 1);
    EXPECT_EQ(springs_between(rig, 12, 18).first, 1);  // diagonals belong to their quads
    EXPECT_EQ(rig.sheet.quads.size(), 16u);
}

//   A‖B +        On the border only the line into the sheet opens anything ...
//   + + +
TEST(Cut, ABorderSiteOpensAcrossTheBorderAndNotAlongIt) {
    Rig rig(plain(3, 4));
    EXPECT_EQ(fan(rig, 0, 2), "00..");
    EXPECT_EQ(cut(rig, 0, 2, CutLine::AlongMain), 0);
    EXPECT_EQ(fan(rig, 0, 2), "00..");
    EXPECT_EQ(cut(rig, 0, 2, CutLine::AlongCross), 1);
    EXPECT_EQ(fan(rig, 0, 2), "01..");
}

//   A +          ... and a corner, which has one quad, never does.
//   + +
TEST(Cut, ACornerNeverOpens) {
    Rig rig(plain(3, 3));
    EXPECT_EQ(cut(rig, 0, 0, CutLine::AlongMain), 0);
    EXPECT_EQ(cut(rig, 0, 0, CutLine::AlongCross), 0);
    EXPECT_EQ(rig.sheet.mass.size(), 16u);
}

//   + A‖B +      A second cut the same way finds nothing; across the first it makes four copies.
//    ==+==
//   + C‖D +
TEST(Cut, ASecondCutAtTheSameNode) {
    Rig rig(plain(4, 4));
    EXPECT_EQ(cut(rig, 2, 2, CutLine::AlongCross), 1);
    EXPECT_EQ(cut(rig, 2, 2, CutLine::AlongCross), 0);
    EXPECT_EQ(cut(rig, 2, 2, CutLine::AlongMain), 2);
    EXPECT_EQ(fan(rig, 2, 2), "0123");
    std::set<Index> nodes;
    for (int k = 0; k < 4; ++k)
        nodes.insert(node(rig, 12, k));
    for (const Index n : nodes) {
        EXPECT_NEAR(rig.sheet.mass[static_cast<std::size_t>(n)], 0.25 * 0.080 * 1e-4,
                    1e-12);  // a quarter of a cell
    }
    EXPECT_EQ(springs_between(rig, 7, 17).first, 0);
    EXPECT_EQ(springs_between(rig, 11, 13).first, 0);
}

//   + A +        A corner: the path of a crack turns at the node. One quad is cut off from three,
//   A B═==       and both bending springs through the node are gone on its side.
//   + ‖ +
TEST(Cut, ACornerSplitsOneQuadFromThree) {
    for (int k = 0; k < 4; ++k) {
        Rig rig(plain(4, 4));
        const double mass = total_mass(rig);
        EXPECT_EQ(open_site(rig.lattice, rig.sheet, 12, 1u << k | 1u << (k + 1) % 4), 1);
        rig.refresh();
        EXPECT_NEAR(total_mass(rig) / mass, 1.0, 1e-15);
        const Index alone = node(rig, 12, k);
        for (int j = 0; j < 4; ++j)
            EXPECT_EQ(node(rig, 12, j) == alone, j == k);
        EXPECT_NEAR(rig.sheet.mass[static_cast<std::size_t>(alone)], 0.25 * 0.080 * 1e-4,
                    1e-18);                                // a quarter of a cell
        EXPECT_EQ(springs_between(rig, 11, 13).first, 1);  // on the far side of the corner
        EXPECT_EQ(springs_between(rig, 7, 17).first, 1);
        EXPECT_EQ(find_pieces(rig.sheet), 1);
    }
}

//   +  +  +      T: a crack along z at (1,2) runs into one along x at (2,2). At (2,2) the upper
//      ‖         quads hold together by the node alone, as the edge between them is open at its
//   +==+==+      other end. As hinges they stay together; released, the crack goes through.
TEST(Cut, ATCrossingHangsByAHingeUntilReleased) {
    Rig rig(plain(4, 4));
    cut(rig, 1, 2, CutLine::AlongCross);
    cut(rig, 2, 2, CutLine::AlongMain);
    EXPECT_EQ(fan(rig, 2, 2), "0011");
    EXPECT_EQ(release_hinge(rig.lattice, rig.sheet, rig.lattice.site(2, 2)), 1);
    EXPECT_EQ(fan(rig, 2, 2), "0012");
}

//      ‖         X: two straight cracks through (2,2) and its four neighbours separate four quads
//   ===+===      around it completely.
//      ‖
TEST(Cut, AnXCrossingSeparatesFourQuads) {
    Rig rig(plain(4, 4));
    cut(rig, 2, 2, CutLine::AlongCross);
    cut(rig, 1, 2, CutLine::AlongCross);
    cut(rig, 3, 2, CutLine::AlongCross);
    cut(rig, 2, 2, CutLine::AlongMain);
    cut(rig, 2, 1, CutLine::AlongMain);
    cut(rig, 2, 3, CutLine::AlongMain);
    EXPECT_EQ(fan(rig, 2, 2), "0123");
    EXPECT_EQ(fan(rig, 1, 2), "0110");
    EXPECT_EQ(fan(rig, 2, 1), "0011");
    EXPECT_EQ(springs_between(rig, 12, 13).first, 2);  // both copies of the edge, both k/2
    EXPECT_EQ(find_pieces(rig.sheet), 1);              // the border still holds the sheet together
}

//   + A +        A quad cut free on all sides keeps its four edges and two diagonals, at half and
//   ‖Q‖          full stiffness, and is a piece of its own.
//   + + +
TEST(Cut, AnIsolatedQuadIsAFlake) {
    Rig rig(plain(5, 5));
    for (const Index r : {2, 3}) {
        for (const Index c : {2, 3}) {
            cut(rig, r, c, CutLine::AlongCross);
            cut(rig, r, c, CutLine::AlongMain);
        }
    }
    EXPECT_EQ(find_pieces(rig.sheet), 2);
    const Quad flake = rig.sheet.quads[static_cast<std::size_t>(rig.lattice.cell(2, 2))];
    int count = 0;
    for_each_spring(rig.lattice, rig.network, [&](Index a, Index b, Index, double, double) {
        const auto in = [&](Index n) {
            return std::find(flake.begin(), flake.end(), n) != flake.end();
        };
        if (in(a) || in(b)) {
            EXPECT_TRUE(in(a) && in(b));
            ++count;
        }
    });
    EXPECT_EQ(count, 6);
}

TEST(Cut, ACornerQuadHangingByOneNodeLetsGo) {
    //   Q ‖ +      the corner quad (0,0) is cut from both neighbours at (0,1) and (1,0);
    //   == + +     it holds on to (1,1) by a single node
    Rig rig(plain(3, 3));
    cut(rig, 0, 1, CutLine::AlongCross);
    cut(rig, 1, 0, CutLine::AlongMain);
    EXPECT_EQ(find_pieces(rig.sheet), 1);
    EXPECT_EQ(release_hinge(rig.lattice, rig.sheet, rig.lattice.site(1, 1)), 1);
    EXPECT_EQ(find_pieces(rig.sheet), 2);
}

TEST(Cut, CopiesOfAHeldNodeAreHeldAndPiecesKnowWhatHoldsThem) {
    Params p = plain(3, 4);
    p.sheet.held = HeldEdge::MainStart;
    Rig rig(p);
    EXPECT_EQ(cut(rig, 1, 0, CutLine::AlongMain), 1);
    EXPECT_EQ(rig.sheet.held.back(), 1);
    for (Index r = 0; r <= 3; ++r)
        cut(rig, r, 2, CutLine::AlongCross);  // right half comes off
    EXPECT_EQ(find_pieces(rig.sheet), 2);
    EXPECT_EQ(rig.sheet.piece_held[rig.site(1, 1)], 1);
    EXPECT_EQ(rig.sheet.piece_held[rig.site(1, 4)], 0);
}

TEST(Cut, ATubeOpensAtItsSeamLikeAnywhereElse) {
    Params p = plain(6, 4);
    p.sheet.shape = SheetShape::Cylinder;
    Rig rig(p);
    EXPECT_EQ(rig.lattice.row_count, 6);
    EXPECT_EQ(fan(rig, 0, 2), "0000");
    EXPECT_EQ(cut(rig, 0, 2, CutLine::AlongMain), 1);
    EXPECT_EQ(fan(rig, 0, 2), "0011");
    EXPECT_EQ(springs_between(rig, rig.lattice.site(5, 2), rig.lattice.site(1, 2)).first, 0);
}

TEST(Cut, TenThousandRandomCutsKeepQuadsMassAndSprings) {
    for (const Border border : {Border::Tributary, Border::Uniform}) {
        Params p = plain(24, 30);
        p.sheet.border = border;
        p.sheet.held = HeldEdge::CrossStart;
        Rig rig(p);
        const double mass = total_mass(rig);
        const std::size_t quads = rig.sheet.quads.size();
        const auto sites = static_cast<std::uint64_t>(rig.lattice.site_count());
        for (std::uint64_t i = 0; i < 10000; ++i) {
            const std::uint64_t bits = random_bits(5, RandomUse::Particle, 9, i);
            const auto site = static_cast<Index>((bits >> 8) % sites);
            if (i % 7 == 3) {
                release_hinge(rig.lattice, rig.sheet, site);
            } else {
                // two straight cuts and four corners
                constexpr unsigned kPairs[] = {0b0101, 0b1010, 0b0011, 0b0110, 0b1100, 0b1001};
                open_site(rig.lattice, rig.sheet, site, kPairs[bits % 6]);
            }
        }
        rig.refresh();
        const auto nodes = static_cast<Index>(rig.sheet.mass.size());
        EXPECT_GT(nodes, 2 * rig.lattice.site_count());
        EXPECT_EQ(rig.sheet.quads.size(), quads);
        EXPECT_NEAR(total_mass(rig) / mass, 1.0, 1e-12);
        std::set<Index> used;
        for (const Quad& quad : rig.sheet.quads)
            used.insert(quad.begin(), quad.end());
        EXPECT_EQ(static_cast<Index>(used.size()), nodes) << "every node is a corner of some quad";
        std::set<std::pair<Index, Index>> edges;  // node pairs that share a quad
        for (const Quad& q : rig.sheet.quads) {
            for (std::size_t a = 0; a < 4; ++a) {
                for (std::size_t b = 0; b < 4; ++b)
                    edges.insert({q[a], q[b]});
            }
        }
        for_each_spring(rig.lattice, rig.network,
                        [&](Index a, Index b, Index slot, double k, double) {
                            ASSERT_TRUE(a >= 0 && a < nodes && b >= 0 && b < nodes && a != b)
                                << "dangling spring";
                            EXPECT_GT(k, 0);
                            const auto kind = static_cast<Slot>(slot / rig.lattice.site_count());
                            if (spring_kind(kind) == SpringKind::Bending) return;
                            EXPECT_TRUE(edges.contains({a, b}))
                                << "a spring between nodes without a common quad";
                        });
    }
}

}  // namespace
}  // namespace ember
