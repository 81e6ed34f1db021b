// What acts on nodes besides springs.
#include "sim/loads.h"

#include <gtest/gtest.h>

#include "rig.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

TEST(Loads, PaperWeighsWhatIsLeftOfIt) {
    Params p = plain(2, 2);
    p.world.gravity = 9.81;
    Rig rig(p);
    rig.sheet.mass[4] *= 0.3;
    gather_loads(rig.params, rig.sheet, {}, rig.loads);
    for (std::size_t n = 0; n < 9; ++n) {
        EXPECT_DOUBLE_EQ(rig.loads.force.y[n], -9.81 * rig.sheet.mass[n]);
        EXPECT_DOUBLE_EQ(rig.loads.inverse_mass[n], 1.0 / rig.sheet.mass[n]);
    }
}

TEST(Loads, HeldPiecesFeelAsMuchGravityAsIsSaid) {
    Params p = plain(2, 2);
    p.world.gravity = 9.81;
    p.world.held_gravity = 0.01;
    p.sheet.held = HeldEdge::MainStart;
    Rig rig(p);
    gather_loads(rig.params, rig.sheet, {}, rig.loads);
    for (std::size_t n = 0; n < 9; ++n)
        EXPECT_DOUBLE_EQ(rig.loads.force.y[n], -0.0981 * rig.sheet.mass[n]);
    EXPECT_EQ(rig.loads.inverse_mass[rig.site(1, 0)], 0.0);
}

}  // namespace
}  // namespace ember
