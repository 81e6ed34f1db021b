// Every integrator against what is known about it: order, energy, stability, tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/energy.h"
#include "sim/topology.h"
#include "small_swing.h"

namespace ember {
namespace {

using test::distance;
using test::plain;
using test::Rig;
using test::small_swing;
constexpr double kPi = std::numbers::pi;

constexpr IntegratorKind kAll[] = {IntegratorKind::SemiImplicitEuler,
                                   IntegratorKind::VelocityVerlet,
                                   IntegratorKind::Rk4,
                                   IntegratorKind::Dopri5,
                                   IntegratorKind::Rkf78,
                                   IntegratorKind::AdamsBashforthMoulton,
                                   IntegratorKind::Rosenbrock};

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

TEST(Integrators, TheirLossesAccountForTheirEnergy) {
    for (const IntegratorKind integrator : kAll) {
        Rig rig(small_swing());
        const double before = rig.energy().total();
        const TickWork work =
            rig.run(0.1, integrator == IntegratorKind::Rosenbrock ? 1600 : 400, integrator);
        const double lost = work.damping + work.drag;
        EXPECT_GT(work.damping, 0);
        EXPECT_GT(work.drag, 0);
        EXPECT_NEAR(rig.energy().total() - before - work.scheme, -lost, 2e-3 * lost)
            << static_cast<int>(integrator);
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
    const double before = rig.energy().total();
    (void)rig.run(kSteps * kZ / omega, kSteps);
    const double loss = 1 - rig.energy().total() / before;
    const double each = std::pow(kZ, 6) / 72 - std::pow(kZ, 8) / 576;
    EXPECT_NEAR(loss / (1 - std::pow(1 - each, kSteps)), 1.0, 0.05);
}

TEST(Integrators, LeapfrogEnergyDoesNotDrift) {
    for (const auto integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet}) {
        double omega = 0;
        Rig rig = ringing_chain(omega);
        const double before = rig.energy().total(), h = 0.25 / omega;
        double scheme = 0, worst = 0;
        for (int run = 0; run < 100; ++run) {
            scheme += rig.run(100 * h, 100, integrator).scheme;
            // exactly conserved but for rounding: linear forces
            worst = std::max(worst, std::abs(rig.energy().total() - scheme - before) / before);
        }
        EXPECT_LT(worst, 1e-9);
        EXPECT_LT(std::abs(scheme) / before, 0.2);  // bounded: z/2 and z²/4 of the energy
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
