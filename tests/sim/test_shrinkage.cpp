// Burning springs shrink: eq. 4 by hand, and that it does not know the step.
#include <gtest/gtest.h>

#include "rig.h"
#include "sim/active_nodes.h"
#include "sim/shrinkage.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

ActiveNodes active_in(const Rig& rig) {
    ActiveNodes active;
    find_active(rig.lattice, rig.sheet, active);
    return active;
}

// A sheet whose nodes (2,2) and (2,3) burn at 900 and 700 degC.
Rig two_burning() {
    Rig rig(plain(4, 6));
    rig.sheet.phase[rig.site(2, 2)] = rig.sheet.phase[rig.site(2, 3)] = Phase::Burning;
    rig.sheet.temperature[rig.site(2, 2)] = 273.15 + 900;
    rig.sheet.temperature[rig.site(2, 3)] = 273.15 + 700;
    return rig;
}

double rest_ratio(const Rig& rig, Slot kind, Index row, Index column) {
    const auto slot =
        static_cast<std::size_t>(rig.lattice.slot(kind, rig.lattice.site(row, column)));
    return rig.sheet.rest_length[slot] / rig.lattice.initial_length[slot];
}

TEST(Shrinkage, IsEquation4ByHand) {
    Rig rig = two_burning();
    shrink_burning_springs(rig.lattice, rig.params, 1.0 / 60, active_in(rig), rig.sheet,
                           rig.counters);
    // one application: factor (T_a + T_b) / (k_s c_s), with k_s = 7e3 G A_ref
    const double k_s = 7e3 * 0.080 * 0.21 * 0.297 / (33 * 49);
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::Main, 2, 2), 5e-12 * 1600 / (k_s * 2e-4), 1e-12);
    EXPECT_EQ(rest_ratio(rig, Slot::Main, 2, 3), 1.0);      // one end burns: not structural
    EXPECT_EQ(rest_ratio(rig, Slot::DiagDown, 2, 2), 1.0);  // nor diagonal
    // bending springs with one burning end shrink by half; the cold end is at 20 degC
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::BendMain, 2, 0), 0.5 * 5e-12 * 920 / (k_s * 2e-4), 1e-12);
    EXPECT_NEAR(1 - rest_ratio(rig, Slot::BendCross, 2, 3), 0.5 * 5e-12 * 720 / (k_s * 2e-4),
                1e-12);
    EXPECT_EQ(rig.counters.springs_shrunk, 1 + 8);
}

TEST(Shrinkage, DoesNotDependOnTheStep) {
    Rig once = two_burning(), often = two_burning();
    shrink_burning_springs(once.lattice, once.params, 0.5, active_in(once), once.sheet,
                           once.counters);
    for (int i = 0; i < 8; ++i) {
        shrink_burning_springs(often.lattice, often.params, 0.0625, active_in(often), often.sheet,
                               often.counters);
    }
    EXPECT_NEAR(rest_ratio(once, Slot::Main, 2, 2), rest_ratio(often, Slot::Main, 2, 2), 1e-14);
    EXPECT_LT(rest_ratio(once, Slot::Main, 2, 2), 0.999);
}

TEST(Shrinkage, StopsAtTheFloorAndHasTheRulesOfTheTable) {
    Rig floor = two_burning();
    shrink_burning_springs(floor.lattice, floor.params, 1e6, active_in(floor), floor.sheet,
                           floor.counters);
    EXPECT_EQ(rest_ratio(floor, Slot::Main, 2, 2), 0.7);
    Rig half = two_burning();
    half.params.shrinkage.rule = ShrinkRule::Half;
    shrink_burning_springs(half.lattice, half.params, 1.0 / 60, active_in(half), half.sheet,
                           half.counters);
    EXPECT_LT(rest_ratio(half, Slot::Main, 2, 3), 1.0);
    Rig literal = two_burning();
    literal.params.shrinkage.literal_stiffness = true;
    shrink_burning_springs(literal.lattice, literal.params, 1.0 / 60, active_in(literal),
                           literal.sheet, literal.counters);
    Rig usual = two_burning();
    shrink_burning_springs(usual.lattice, usual.params, 1.0 / 60, active_in(usual), usual.sheet,
                           usual.counters);
    EXPECT_NEAR((1 - rest_ratio(usual, Slot::BendMain, 2, 0)) /
                    (1 - rest_ratio(literal, Slot::BendMain, 2, 0)),
                2e4 / 7e3, 1e-9);
    Rig none = two_burning();
    none.params.shrinkage.factor = 0;
    shrink_burning_springs(none.lattice, none.params, 1.0, active_in(none), none.sheet,
                           none.counters);
    EXPECT_EQ(none.counters.springs_shrunk, 0);
}

}  // namespace
}  // namespace ember
