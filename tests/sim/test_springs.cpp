// The lattice and its motion: spring constants, closed forms, order, momentum.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "rig.h"
#include "sim/random.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;
constexpr double kPi = std::numbers::pi;

double random_in(double low, double high, std::uint64_t index) {
    return low + (high - low) * random_uniform(99, RandomUse::Waviness, 0, index);
}

// Two parallel chains along the main direction, both ends held: structural springs only.
Params chain(int links) {
    Params p = plain(1, links);
    p.sheet.border = Border::Uniform;
    p.sheet.held = HeldEdge::BothMainEnds;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.springs.diagonal = 0;
    p.springs.bending = 0;
    p.springs.damping = 0;
    return p;
}

TEST(Lattice, HasThePapersMassesLengthsAndStiffness) {
    Params p;
    p.springs.stiffness_scale = 1;
    p.springs.variation = 0;
    p.sheet.border = Border::Uniform;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    Rig rig(p);
    EXPECT_EQ(rig.lattice.site_count(), 33 * 49);
    EXPECT_NEAR(rig.lattice.row_spacing, 0.210 / 32, 1e-15);     // M d1 = z
    EXPECT_NEAR(rig.lattice.column_spacing, 0.297 / 48, 1e-15);  // N d2 = x
    const double m = 0.080 * 0.210 * 0.297 / (33 * 49);
    EXPECT_NEAR(rig.sheet.mass[0], m, 1e-18);
    const auto constants = [&](Slot kind) {
        const auto slot = static_cast<std::size_t>(rig.lattice.slot(kind, rig.lattice.site(3, 3)));
        return std::array{rig.lattice.stiffness[slot] / m, rig.lattice.damping[slot] / m,
                          rig.lattice.initial_length[slot]};
    };
    const double d1 = 0.210 / 32, d2 = 0.297 / 48;
    EXPECT_NEAR(constants(Slot::Main)[0], 7e3, 1e-6);
    EXPECT_NEAR(constants(Slot::DiagUp)[0], 7e3, 1e-6);
    EXPECT_NEAR(constants(Slot::BendCross)[0], 2e4, 1e-6);
    EXPECT_NEAR(constants(Slot::BendMain)[1], 5.0, 1e-9);
    EXPECT_NEAR(constants(Slot::DiagDown)[2], std::hypot(d1, d2), 1e-15);
    EXPECT_NEAR(constants(Slot::BendMain)[2], 2 * d2, 1e-15);
    EXPECT_NEAR(constants(Slot::BendCross)[2], 2 * d1, 1e-15);
}

TEST(Lattice, PerAreaStiffnessEqualsThePapersOnItsOwnLatticeAndScalesWithTheCell) {
    Params p;
    p.springs.stiffness_scale = 1;
    p.springs.variation = 0;
    const auto stiffness = [](const Params& params, Slot kind) {
        Rig rig(params);
        return rig.lattice.stiffness[static_cast<std::size_t>(rig.lattice.slot(kind, 0))];
    };
    const double paper = 7e3 * 0.080 * 0.21 * 0.297 / (33 * 49);
    EXPECT_NEAR(stiffness(p, Slot::Main) / paper, 1.0, 1e-12);
    EXPECT_NEAR(stiffness(p, Slot::DiagUp) / paper, 1.0, 1e-12);
    p.sheet.rows *= 2;
    p.sheet.columns *= 2;
    EXPECT_NEAR(stiffness(p, Slot::Main) / paper, 1.0, 1e-12);
    p.sheet.rows *= 2;  // cells half as wide: each main fibre carries half
    EXPECT_NEAR(stiffness(p, Slot::Main) / paper, 0.5, 1e-12);
    EXPECT_NEAR(stiffness(p, Slot::Cross) / paper, 2.0, 1e-12);
}

TEST(Lattice, EveryFibreHasItsOwnStiffnessWithinTenPerCent) {
    Params p = plain(8, 8);
    p.springs.variation = 0.1;
    Rig rig(p);
    const auto k = [&](Slot kind, Index r, Index c) {
        return rig.lattice
            .stiffness[static_cast<std::size_t>(rig.lattice.slot(kind, rig.lattice.site(r, c)))];
    };
    const Rig unvaried(plain(8, 8));
    const auto mean = [&](Slot kind) {
        return unvaried.lattice.stiffness[static_cast<std::size_t>(unvaried.lattice.slot(kind, 0))];
    };
    for (const Slot kind : {Slot::Main, Slot::Cross}) {
        EXPECT_EQ(k(kind, 2, 0), k(kind, 2, 5));  // the same along a row
        EXPECT_NE(k(kind, 2, 0), k(kind, 3, 0));  // another one in the next
        for (Index r = 0; r < 8; ++r)
            EXPECT_NEAR(k(kind, r, 0) / mean(kind), 1.0, 0.1);
    }
    EXPECT_EQ(k(Slot::BendMain, 2, 0), k(Slot::BendMain, 3, 0));
    Params many = plain(400, 1);  // uniform: mean 1, standard deviation 0.1/sqrt(3)
    many.springs.variation = 0.1;
    const Rig varied(many), even(plain(400, 1));
    double sum = 0;
    for (Index r = 0; r <= 400; ++r) {
        const auto slot = static_cast<std::size_t>(varied.lattice.slot(Slot::Main, 2 * r));
        sum += varied.lattice.stiffness[slot] / even.lattice.stiffness[slot];
    }
    EXPECT_NEAR(sum / 401, 1.0, 4 * 0.058 / 20);
    p.springs.variation_pattern = VariationPattern::PerSpring;
    Rig each(p);
    EXPECT_NE(each.lattice.stiffness[0], each.lattice.stiffness[1]);
}

TEST(Lattice, MassesSumToGrammageTimesAreaForBothBorders) {
    for (const Border border : {Border::Tributary, Border::Uniform}) {
        Params p = plain(5, 7);
        p.sheet.border = border;
        Rig rig(p);
        double sum = 0;
        for (const double m : rig.sheet.mass)
            sum += m;
        EXPECT_NEAR(sum / (0.080 * 0.05 * 0.07), 1.0, 1e-13);
    }
}

TEST(Springs, AStretchedSpringPullsBothEndsAlike) {
    // one quad, its edge (0,0)-(0,1) pulled to twice its length
    Params p = plain(1, 1);
    p.springs.diagonal = 0;
    p.springs.damping = 0;
    Rig rig(p);
    rig.sheet.position.x[1] += 0.01;
    rig.sheet.position.x[3] += 0.01;
    Motion motion;
    motion.read(rig.sheet);
    std::vector<double> a(12);
    (void)accelerate(rig.mechanics(), motion.x.data(), motion.v.data(), a.data());
    const double fx[] = {a[0] * rig.sheet.mass[0], a[1] * rig.sheet.mass[1]};
    const double k = 0.5 * rig.lattice.stiffness[0];  // half a spring on the border
    EXPECT_NEAR(fx[0], k * 0.01, 1e-15);
    EXPECT_EQ(fx[1], -fx[0]);
    EXPECT_NEAR(rig.energy().elastic, k * 0.01 * 0.01, 1e-16);
}

TEST(RungeKutta, AChainFollowsTheDiscreteClosedForm) {
    // a mode p of a chain of n links oscillates at 2 sqrt(k/m) sin(p π / 2n); RK4 multiplies it by
    // R(i ω h) in every step, R being its stability polynomial
    constexpr int kLinks = 10, kMode = 3, kSteps = 200;
    Rig rig(chain(kLinks));
    constexpr double kAmplitude = 1e-4;
    for (Index r = 0; r < 2; ++r) {
        for (Index c = 0; c <= kLinks; ++c) {
            rig.sheet.position.x[rig.site(r, c)] += kAmplitude * std::sin(kMode * kPi * c / kLinks);
        }
    }
    const double omega = 2 * std::sqrt(7e3) * std::sin(kMode * kPi / (2.0 * kLinks));
    const double h = 0.4 / omega;
    const double start = rig.sheet.position.x[rig.site(0, 2)] - (-0.05 + 0.02);
    (void)rig.run(kSteps * h, kSteps);
    const std::complex<double> z(0, omega * h);
    const auto growth =
        std::pow(1.0 + z + z * z / 2.0 + z * z * z / 6.0 + z * z * z * z / 24.0, kSteps);
    const double moved = rig.sheet.position.x[rig.site(0, 2)] - (-0.05 + 0.02);
    EXPECT_NEAR(moved / start, growth.real(), 1e-9);
    EXPECT_NEAR(rig.sheet.position.x[rig.site(1, 2)], rig.sheet.position.x[rig.site(0, 2)], 1e-15);
}

TEST(RungeKutta, IsOfFourthOrderOnASmoothSwing) {
    Params p = plain(6, 8);
    p.sheet.held = HeldEdge::MainStart;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.05;
    const auto run = [&](int substeps) {
        Rig rig(p);
        // normals and thus drag are taken once per tick: one tick, smooth loads
        (void)rig.run(0.05, substeps);
        return rig.sheet.position;
    };
    const Vector3Array reference = run(1024);
    const auto error = [&](int substeps) {
        const Vector3Array got = run(substeps);
        double sum = 0;
        for (std::size_t n = 0; n < got.size(); ++n) {
            sum += (got.at(n) - reference.at(n)).squaredNorm();
        }
        return std::sqrt(sum / static_cast<double>(got.size()));
    };
    const double e16 = error(16), e32 = error(32), e64 = error(64);
    ASSERT_GT(e64, 1e-15);
    EXPECT_NEAR(std::log2(e16 / e32), 4.0, 0.25);
    EXPECT_NEAR(std::log2(e32 / e64), 4.0, 0.25);
}

TEST(Springs, AHangingChainStretchesByTheWeightBelowEachLink) {
    Params p = chain(6);
    p.sheet.held = HeldEdge::MainStart;
    p.sheet.pose = SheetPose::Hanging;
    p.world.gravity = 0.5;
    p.springs.damping = 60;
    Rig rig(p);
    for (int i = 0; i < 400; ++i)
        (void)rig.run(0.05, 12);
    const double stiffness = 7e3;  // per mass
    for (Index c = 0; c < 6; ++c) {
        const double length =
            rig.sheet.position.y[rig.site(0, c)] - rig.sheet.position.y[rig.site(0, c + 1)];
        const double below = 6 - c;  // nodes
        EXPECT_NEAR(length, 0.01 + 0.5 * below / stiffness, 1e-10) << c;
    }
}

TEST(Springs, AFreeSheetKeepsItsMomentum) {
    Params p = plain(6, 8);
    p.springs.variation = 0.1;
    Rig rig(p);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        rig.sheet.velocity.set(
            n, {random_in(-1, 1, 3 * n), random_in(-1, 1, 3 * n + 1), random_in(-1, 1, 3 * n + 2)});
    }
    const auto momentum = [&] {
        Vector3 linear = Vector3::Zero(), angular = Vector3::Zero();
        for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
            const Vector3 mv = rig.sheet.mass[n] * rig.sheet.velocity.at(n);
            const Vector3 x = rig.sheet.position.at(n);
            linear += mv;
            angular += Vector3(x.y() * mv.z() - x.z() * mv.y(), x.z() * mv.x() - x.x() * mv.z(),
                               x.x() * mv.y() - x.y() * mv.x());
        }
        return std::pair(linear, angular);
    };
    const auto before = momentum();
    const double scale = before.first.norm();
    for (int i = 0; i < 60; ++i)
        (void)rig.run(1.0 / 60, 64);
    const auto after = momentum();
    EXPECT_LE((after.first - before.first).norm() / scale, 1e-12);
    // exact for the forces, of the order of the method for the motion
    EXPECT_LE((after.second - before.second).norm() / before.second.norm(), 1e-6);
}

TEST(Springs, AreAsWeakAsTheWeakerOfTheirEnds) {
    Rig rig(plain(6, 6));
    const std::vector<double> whole = rig.network.stiffness;
    rig.sheet.mass[rig.site(3, 3)] *= 0.5;
    rig.sheet.mass[rig.site(3, 4)] *= 0.25;
    rig.refresh();
    const auto left = [&](Slot kind, Index r, Index c) {
        const auto s = static_cast<std::size_t>(rig.lattice.slot(kind, rig.lattice.site(r, c)));
        return rig.network.stiffness[s] / whole[s];
    };
    EXPECT_EQ(left(Slot::Main, 3, 1), 1.0);
    EXPECT_EQ(left(Slot::Main, 3, 2), 0.5) << "the second end has burnt";
    EXPECT_EQ(left(Slot::Cross, 3, 3), 0.5) << "the first end has burnt";
    EXPECT_EQ(left(Slot::Main, 3, 3), 0.25) << "the second end has burnt more";
    EXPECT_EQ(left(Slot::BendCross, 1, 3), 0.5);
    EXPECT_EQ(left(Slot::DiagDown, 3, 4), 0.25);
}

// A sheet stretched by 0.2 % along its main direction: strain times stiffness over the paper that a
// spring stands for, and nothing across.
TEST(SpringSegments, StressAndStiffnessAreThoseOfThePaperThatASpringStandsFor) {
    Params p;
    p.sheet.rows = 4;
    p.sheet.columns = 6;
    p.sheet.imperfection = 0;
    p.sheet.border = Border::Uniform;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.springs.variation = 0;
    World world = make_world(p);
    WorldState state = world.snapshot();
    auto& y = state.sheets[0].position.y;  // the main direction of a hanging sheet
    for (double& height : y)
        height = p.sheet.elevation + 1.002 * (height - p.sheet.elevation);
    world.restore(state);
    const double main = p.sheet.height / p.sheet.columns, cross = p.sheet.width / p.sheet.rows;
    const double node_weight = p.paper.grammage * p.sheet.width * p.sheet.height / (5 * 7);
    const double k = node_weight * p.springs.structural * p.springs.stiffness_scale;
    const double caliper = p.paper.grammage / p.paper.density;
    int along = 0;
    for (const SpringSegment& spring : world.springs(0)) {
        EXPECT_NEAR(spring.stiffness, 1.0, 1e-12);
        const bool is_main = spring.kind == SpringKind::Structural && spring.b == spring.a + 1;
        along += is_main ? 1 : 0;
        const double expected = is_main ? k * 0.002 * main / (cross * caliper) : 0.0;
        EXPECT_NEAR(spring.stress, expected, 1e-6 * k / caliper);
    }
    EXPECT_EQ(along, 5 * 6);
}

}  // namespace
}  // namespace ember
