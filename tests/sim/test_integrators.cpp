// Every integrator against what is known about it: order, energy, stability, tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rig.h"
#include "sim/energy.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;
constexpr double kPi = std::numbers::pi;

constexpr IntegratorKind kAll[] = {IntegratorKind::SemiImplicitEuler,
                                   IntegratorKind::VelocityVerlet,
                                   IntegratorKind::Rk4,
                                   IntegratorKind::Dopri5,
                                   IntegratorKind::Rkf78,
                                   IntegratorKind::AdamsBashforthMoulton,
                                   IntegratorKind::Rosenbrock};

// A small sheet that swings, damped in its springs and by the air.
Params small_swing() {
    Params p = plain(5, 6);
    p.sheet.held = HeldEdge::MainStart;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.1;
    return p;
}

double distance(const Vector3Array& p, const Vector3Array& q) {
    double sum = 0;
    for (std::size_t n = 0; n < p.size(); ++n)
        sum += (p.at(n) - q.at(n)).squaredNorm();
    return std::sqrt(sum / static_cast<double>(p.size()));
}

Vector3Array swing_for(double duration, const StepControl& wanted) {
    Rig rig(small_swing());
    StepControl control = wanted;
    control.dt = duration;
    const TickWork work = rig.run(control);
    EXPECT_EQ(work.failure, nullptr);
    return rig.sheet.position;
}

const Vector3Array& swing_reference() {
    static const Vector3Array reference =
        swing_for(0.05, {.integrator = IntegratorKind::Rkf78, .substeps = 400});
    return reference;
}

double error_of(IntegratorKind integrator, std::int64_t substeps) {
    return distance(swing_for(0.05, {.integrator = integrator, .substeps = substeps}),
                    swing_reference());
}

// Order from the slope over five numbers of sub-steps, each 1.5 times the last.
double measured_order(IntegratorKind integrator, double first) {
    double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    constexpr int kCount = 5;
    for (int i = 0; i < kCount; ++i) {
        const auto substeps = static_cast<std::int64_t>(first * std::pow(1.5, i) + 0.5);
        const double error = error_of(integrator, substeps);
        EXPECT_GT(error, 1e-15) << "rounding, not the method";
        const double x = std::log(static_cast<double>(substeps)), y = -std::log(error);
        sum_x += x, sum_y += y, sum_xx += x * x, sum_xy += x * y;
    }
    return (kCount * sum_xy - sum_x * sum_y) / (kCount * sum_xx - sum_x * sum_x);
}

TEST(Integrators, TwoReferencesAgree) {
    const Vector3Array other =
        swing_for(0.05, {.integrator = IntegratorKind::AdamsBashforthMoulton, .substeps = 4000});
    EXPECT_LT(distance(other, swing_reference()), 1e-14);
}

TEST(Integrators, HaveTheOrderThatTheyClaim) {
    EXPECT_NEAR(measured_order(IntegratorKind::SemiImplicitEuler, 60), 1.0, 0.1);
    EXPECT_NEAR(measured_order(IntegratorKind::VelocityVerlet, 60), 2.0, 0.1);
    EXPECT_NEAR(measured_order(IntegratorKind::Rk4, 20), 4.0, 0.15);
    EXPECT_NEAR(measured_order(IntegratorKind::Dopri5, 20), 5.0, 0.2);
    EXPECT_NEAR(measured_order(IntegratorKind::Rkf78, 6), 8.0, 0.4);
    EXPECT_NEAR(measured_order(IntegratorKind::AdamsBashforthMoulton, 26), 7.0, 0.4);
    EXPECT_NEAR(measured_order(IntegratorKind::Rosenbrock, 60), 2.0, 0.15);
}

TEST(Integrators, ErrorControlKeepsToTheTolerance) {
    for (const auto integrator : {IntegratorKind::Dopri5, IntegratorKind::Rkf78}) {
        double last = 1;
        for (const double tolerance : {1e-5, 1e-7, 1e-9, 1e-11}) {
            const double error =
                distance(swing_for(0.05, {.integrator = integrator, .tolerance = tolerance}),
                         swing_reference());
            EXPECT_LT(error, 20 * tolerance);  // some steps, none worse than the tolerance
            EXPECT_LT(error, 0.2 * last);
            last = error;
        }
    }
}

TEST(Integrators, FreeFallIsExact) {
    for (const IntegratorKind integrator : kAll) {
        if (integrator == IntegratorKind::SemiImplicitEuler) continue;  // of first order
        Params p = plain(3, 4);
        p.world.gravity = 9.81;
        Rig rig(p);
        const double height = rig.sheet.position.y[7];
        (void)rig.run(0.3, 30, integrator);
        EXPECT_NEAR(rig.sheet.position.y[7] - height, -0.5 * 9.81 * 0.09, 1e-12);
        EXPECT_NEAR(rig.sheet.velocity.y[7], -9.81 * 0.3, 1e-12);
    }
}

double energy_of(Rig& rig) {
    return rig.energy().total();
}

TEST(Integrators, TheirLossesAccountForTheirEnergy) {
    for (const IntegratorKind integrator : kAll) {
        Rig rig(small_swing());
        const double before = energy_of(rig);
        const TickWork work =
            rig.run(0.1, integrator == IntegratorKind::Rosenbrock ? 1600 : 400, integrator);
        const double lost = work.damping + work.drag;
        EXPECT_GT(work.damping, 0);
        EXPECT_GT(work.drag, 0);
        EXPECT_NEAR(energy_of(rig) - before - work.scheme, -lost, 2e-3 * lost)
            << static_cast<int>(integrator);
    }
}

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
            const double start = energy_of(rig);
            const TickWork work = rig.run({.integrator = integrator,
                                           .dt = 0.0025,
                                           .substeps = 10,
                                           .pauses = true,
                                           .resumes = part > 0});
            lost += work.damping + work.drag;
            scheme += work.scheme;
            left += start - energy_of(rig);
        }
        EXPECT_GT(lost, 0);
        EXPECT_NEAR(left + scheme, lost, 2e-3 * lost);
    }
}

// A chain that oscillates in one mode of the given angular frequency; undamped.
Rig ringing_chain(double& omega) {
    constexpr int kLinks = 10, kMode = 4;
    Params p = plain(1, kLinks);
    p.sheet.border = Border::Uniform;
    p.sheet.held = HeldEdge::BothMainEnds;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.springs.diagonal = p.springs.bending = p.springs.damping = 0;
    Rig rig(p);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        const int column = rig.lattice.column_of(static_cast<Index>(n));
        rig.sheet.position.x[n] += 1e-4 * std::sin(kMode * kPi * column / kLinks);
    }
    omega = 2 * std::sqrt(7e3) * std::sin(kMode * kPi / (2.0 * kLinks));
    return rig;
}

TEST(Integrators, RungeKuttaLosesEnergyAtItsKnownRate) {
    // |R(iz)|² = 1 - z⁶/72 + z⁸/576 per step
    double omega = 0;
    Rig rig = ringing_chain(omega);
    constexpr double kZ = 0.5;
    constexpr int kSteps = 400;
    const double before = energy_of(rig);
    (void)rig.run(kSteps * kZ / omega, kSteps);
    const double loss = 1 - energy_of(rig) / before;
    const double each = std::pow(kZ, 6) / 72 - std::pow(kZ, 8) / 576;
    EXPECT_NEAR(loss / (1 - std::pow(1 - each, kSteps)), 1.0, 0.05);
}

TEST(Integrators, LeapfrogEnergyDoesNotDrift) {
    for (const auto integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet}) {
        double omega = 0;
        Rig rig = ringing_chain(omega);
        const double before = energy_of(rig), h = 0.25 / omega;
        double scheme = 0, worst = 0;
        for (int run = 0; run < 100; ++run) {
            scheme += rig.run(100 * h, 100, integrator).scheme;
            // exactly conserved but for rounding: linear forces
            worst = std::max(worst, std::abs(energy_of(rig) - scheme - before) / before);
        }
        EXPECT_LT(worst, 1e-9);
        EXPECT_LT(std::abs(scheme) / before, 0.2);  // bounded: z/2 and z²/4 of the energy
    }
}

// Largest amplitude after many steps of length `share` of the bound, over that at the start.
double growth(IntegratorKind integrator, double damping, double share) {
    Params p = plain(1, 8);
    p.sheet.border = Border::Uniform;
    p.sheet.held = HeldEdge::BothMainEnds;
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    p.springs.damping = damping;
    Rig rig(p);
    const SheetState rest = rig.sheet;
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
        rig.sheet.position.x[n] += rig.sheet.held[n] != 0 ? 0.0 : n % 2 == 0 ? 1e-9 : -1e-9;
    const double before = distance(rig.sheet.position, rest.position);
    const double step = share * stable_step(integrator, rig.fastest());
    (void)rig.run(3000 * step, 3000, integrator);
    return distance(rig.sheet.position, rest.position) / before;
}

TEST(Integrators, AreStableUpToTheirStepBoundAtAnyDamping) {
    for (const IntegratorKind integrator : kAll) {
        if (integrator == IntegratorKind::Rosenbrock) continue;  // has none
        for (const double damping : {0.0, 5.0, 40.0, 100.0, 300.0, 3000.0}) {
            EXPECT_LT(growth(integrator, damping, 0.999), 20)
                << static_cast<int>(integrator) << " damping " << damping;
        }
    }
}

TEST(Integrators, AreUnstableNotFarBeyondTheirStepBound) {
    // so that the test above can fail; what is left is the pessimism of the bound
    for (const auto integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet, IntegratorKind::Rk4}) {
        EXPECT_FALSE(growth(integrator, 0.0, 1.6) < 1e3);
    }
}

TEST(Integrators, RosenbrockChoosesItsStepsAndComputesTheSameBitsOnAnyNumberOfThreads) {
    Params p = small_swing();
    p.sheet.rows = 60, p.sheet.columns = 70;
    p.sheet.width = 0.6, p.sheet.height = 0.7;
    p.plate.rigidity_main = 2e-3, p.plate.rigidity_cross = 1e-3;
    const auto move = [&p](int threads, double tolerance, TickWork& work) {
        Rig rig(p);
        rig.pool = std::make_unique<ThreadPool>(threads);
        for (int i = 0; i < 9; ++i)  // with springs at cuts
            (void)cut_site(rig.lattice, rig.sheet, rig.lattice.site(30, 5 + i), CutLine::AlongMain);
        rig.refresh();
        work = rig.run({.integrator = IntegratorKind::Rosenbrock,
                        .dt = 1.0 / 240,
                        .substeps = 1,
                        .tolerance = tolerance});
        EXPECT_EQ(work.failure, nullptr);
        return rig.sheet.position;
    };
    TickWork one, three, fine;
    const Vector3Array a = move(1, 1e-5, one), b = move(3, 1e-5, three);
    EXPECT_EQ(a.x, b.x);
    EXPECT_EQ(a.y, b.y);
    EXPECT_EQ(a.z, b.z);
    EXPECT_EQ(one.damping, three.damping);
    const Vector3Array c = move(1, 1e-8, fine);
    EXPECT_LT(distance(a, c), 1e-5);
    EXPECT_GT(fine.substeps, 2 * one.substeps);
}

TEST(Integrators, RosenbrockStaysStableFarBeyondTheBound) {
    Params p = small_swing();
    p.springs.stiffness_scale = 1000;
    Rig rig(p);
    const double height = rig.sheet.position.y[0];
    for (int tick = 0; tick < 60; ++tick)
        ASSERT_EQ(rig.run(1.0 / 60, 1, IntegratorKind::Rosenbrock).failure, nullptr);
    EXPECT_GT(rig.counters.solver_iterations, 0);
    for (const double y : rig.sheet.position.y)
        EXPECT_LT(std::abs(y - height), 0.1);  // the sheet is 6 cm long
}

}  // namespace
}  // namespace ember
