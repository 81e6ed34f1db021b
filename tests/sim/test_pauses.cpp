// Leapfrog steps that pause for contact and resume without evaluating the springs anew.
#include <gtest/gtest.h>

#include <cmath>

#include "small_swing.h"

namespace ember {
namespace {

using test::distance;
using test::Rig;
using test::small_swing;

constexpr IntegratorKind kLeapfrogs[] = {IntegratorKind::SemiImplicitEuler,
                                         IntegratorKind::VelocityVerlet};

// A tick in four calls, the last three of which resume when `paused`; the sum of their work.
TickWork swing_in_parts(Rig& rig, IntegratorKind integrator, bool paused) {
    constexpr int kParts = 4;
    TickWork sum;
    for (int part = 0; part < kParts; ++part) {
        const TickWork work = rig.run({.integrator = integrator,
                                       .dt = 0.01,
                                       .substeps = 20,
                                       .pauses = paused && part + 1 < kParts,
                                       .resumes = paused && part > 0});
        sum.damping += work.damping;
        sum.scheme += work.scheme;
    }
    return sum;
}

TEST(Integrators, APauseChangesNothingAndCostsNoEvaluation) {
    for (const IntegratorKind integrator : kLeapfrogs) {
        SCOPED_TRACE(static_cast<int>(integrator));
        Params p = small_swing();
        p.world.air_drag = 0;  // a resumed call takes it at another velocity
        Rig whole(p), parts(p), apart(p);
        const TickWork at_once = whole.run(0.04, 80, integrator);
        const TickWork in_parts = swing_in_parts(parts, integrator, true);
        EXPECT_EQ(whole.counters.right_hand_sides, 81);
        EXPECT_EQ(parts.counters.right_hand_sides, 81);
        EXPECT_LT(distance(whole.sheet.position, parts.sheet.position), 1e-15);
        EXPECT_LT(distance(whole.sheet.velocity, parts.sheet.velocity), 1e-12);
        EXPECT_NEAR(in_parts.damping, at_once.damping, 1e-9 * at_once.damping);
        EXPECT_NEAR(in_parts.scheme, at_once.scheme, 1e-9 * std::abs(at_once.scheme));
        (void)swing_in_parts(apart, integrator, false);
        EXPECT_EQ(apart.counters.right_hand_sides, 84);
    }
}

TEST(Integrators, AResumedCallFeelsItsOwnLoadsAndTheSpringsOfTheLast) {
    for (const IntegratorKind integrator : kLeapfrogs) {
        SCOPED_TRACE(static_cast<int>(integrator));
        Rig rig(small_swing());
        double lost = 0, scheme = 0, left = 0;
        for (int part = 0; part < 40; ++part) {
            rig.params.world.gravity = part % 2 == 0 ? 20 : -5;
            const double start = rig.energy().total();
            const TickWork work = rig.run({.integrator = integrator,
                                           .dt = 0.0025,
                                           .substeps = 10,
                                           .pauses = true,
                                           .resumes = part > 0});
            lost += work.damping + work.drag;
            scheme += work.scheme;
            left += start - rig.energy().total();
        }
        EXPECT_GT(lost, 0);
        EXPECT_NEAR(left + scheme, lost, 2e-3 * lost);
    }
}

}  // namespace
}  // namespace ember
