// The longest stable steps of explicit integrators.
#include <gtest/gtest.h>

#include "sim/stability.h"
#include "small_swing.h"

namespace ember {
namespace {

using test::distance;
using test::plain;
using test::Rig;

constexpr IntegratorKind kExplicit[] = {IntegratorKind::SemiImplicitEuler,
                                        IntegratorKind::VelocityVerlet,
                                        IntegratorKind::Rk4,
                                        IntegratorKind::Dopri5,
                                        IntegratorKind::Rkf78,
                                        IntegratorKind::AdamsBashforthMoulton};

// Two rows of nodes with both ends held.
Params chain(int links, double damping) {
    Params p = plain(1, links);
    p.sheet.border = Border::Uniform;
    p.sheet.held = HeldEdge::BothMainEnds;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.springs.damping = damping;
    return p;
}

// Amplitude after many steps of length h [s] over that at the start.
double growth(IntegratorKind integrator, Rig& rig, double h) {
    const SheetState rest = rig.sheet;
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
        rig.sheet.position.x[n] += rig.sheet.held[n] != 0 ? 0.0 : n % 2 == 0 ? 1e-9 : -1e-9;
    const double before = distance(rig.sheet.position, rest.position);
    (void)rig.run(3000 * h, 3000, integrator);
    return distance(rig.sheet.position, rest.position) / before;
}

// With steps of length `share` of the bound.
double growth(IntegratorKind integrator, double damping, double share) {
    Rig rig(chain(8, damping));
    return growth(integrator, rig, share * stable_step(integrator, rig.fastest()));
}

TEST(Integrators, AreStableUpToTheirStepBoundAtAnyDamping) {
    for (const IntegratorKind integrator : kExplicit) {
        for (const double damping : {0.0, 5.0, 40.0, 100.0, 300.0, 3000.0}) {
            EXPECT_LT(growth(integrator, damping, 0.999), 20)
                << static_cast<int>(integrator) << " damping " << damping;
        }
    }
}

TEST(Integrators, AreUnstableNotFarBeyondTheirStepBound) {
    // so that the test above can fail; what is left is the pessimism of the bound
    for (const auto integrator : {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet,
                                  IntegratorKind::Rk4, IntegratorKind::AdamsBashforthMoulton}) {
        EXPECT_FALSE(growth(integrator, 0.0, 1.6) < 1e3);
    }
}

TEST(Integrators, AdamsIsStableInLessThanItsRegion) {
    for (const double damping : {0.0, 5.0, 20.0, 60.0, 120.0, 600.0, 6000.0}) {
        Params p = chain(2, damping);  // one node that oscillates in each row, at a known rate
        p.springs.diagonal = p.springs.bending = 0;
        // diagonal springs damp still, at 45 degrees
        const FastestMotion motion{std::sqrt(2 * p.springs.structural), 3 * damping};
        const auto growth_at = [&](double share) {
            constexpr auto kAdams = IntegratorKind::AdamsBashforthMoulton;
            Rig rig(p);
            return growth(kAdams, rig, share * stable_step(kAdams, motion));
        };
        EXPECT_LT(growth_at(0.5), 1.001) << damping;
        EXPECT_LT(growth_at(0.999), 1.001) << damping;
        EXPECT_FALSE(growth_at(1.34) < 1e3) << damping;
    }
}

}  // namespace
}  // namespace ember
