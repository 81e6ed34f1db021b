// The computed bound on the fastest motion against the eigenvalues of the very forces that the
// integrators see, and the longest stable steps that follow from it.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "random_sheet.h"
#include "sim/energy.h"
#include "sim/integrators/motion.h"

namespace ember {
namespace {

using test::Dice;
using test::plain;
using test::Rig;

std::vector<double> acceleration_of(const Mechanics& mechanics, const Motion& motion) {
    std::vector<double> a(3 * mechanics.node_count());
    (void)accelerate(mechanics, motion.x.data(), motion.v.data(), a.data());
    return a;
}

// -M^½ ∂a/∂q M^-½ over the nodes that are not held, by central differences of the right-hand side
// in q, the positions or the velocities. The forces are linear in the velocities, so that any step
// does; 1e-7 m of springs of at least 1 mm leave out (1e-4)² of k, and rounding less.
Eigen::MatrixXd mass_scaled_derivative(Rig& rig, std::vector<double> Motion::*q) {
    const Mechanics mechanics = rig.mechanics();
    Motion motion;
    motion.read(rig.sheet);
    std::fill(motion.v.begin(), motion.v.end(), 0.0);
    const std::size_t nodes = rig.sheet.mass.size();
    std::vector<std::size_t> free;  // components
    for (std::size_t i = 0; i < 3 * nodes; ++i) {
        if (rig.sheet.held[i % nodes] == 0) free.push_back(i);
    }
    const double step = q == &Motion::x ? 1e-7 : 1.0;
    const auto size = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd matrix(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
        const std::size_t moved = free[static_cast<std::size_t>(j)];
        double& value = (motion.*q)[moved];
        const double before = value;
        value = before + step;
        const std::vector<double> above = acceleration_of(mechanics, motion);
        const double high = value;
        value = before - step;
        const std::vector<double> below = acceleration_of(mechanics, motion);
        const double width = high - value;
        value = before;
        for (Eigen::Index i = 0; i < size; ++i) {
            const std::size_t at = free[static_cast<std::size_t>(i)];
            const double root =
                std::sqrt(rig.sheet.mass[at % nodes] / rig.sheet.mass[moved % nodes]);
            matrix(i, j) = root * (below[at] - above[at]) / width;
        }
    }
    return matrix;
}

// Largest eigenvalue of a matrix that is symmetric but for rounding.
double largest_eigenvalue(const Eigen::MatrixXd& matrix) {
    const double asymmetry = (matrix - matrix.transpose()).cwiseAbs().maxCoeff();
    EXPECT_LE(asymmetry, 1e-6 * matrix.cwiseAbs().maxCoeff()) << "not the gradient of an energy";
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (matrix + matrix.transpose()),
                                                                Eigen::EigenvaluesOnly);
    return solver.eigenvalues().maxCoeff();
}

// Length of the shortest spring over its rest length.
double most_compressed(const Rig& rig) {
    double least = 1e300;
    for_each_spring(rig.lattice, rig.network, [&](Index a, Index b, Index slot, double, double) {
        const Vector3 d = rig.sheet.position.at(static_cast<std::size_t>(b)) -
                          rig.sheet.position.at(static_cast<std::size_t>(a));
        least = std::min(least, d.norm() / rig.sheet.rest_length[static_cast<std::size_t>(slot)]);
    });
    return least;
}

struct Ratios {
    std::vector<double> values;

    [[nodiscard]] double largest() const { return *std::max_element(values.begin(), values.end()); }
    [[nodiscard]] double median() {
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
        std::nth_element(values.begin(), middle, values.end());
        return *middle;
    }
};

struct Trials {
    Ratios omega, uncompressed_omega, gamma;  // bound over truth
};

void compare(Rig& rig, Trials& trials) {
    constexpr double kRounding = 1e-7;  // of the differences, see mass_scaled_derivative()
    const FastestMotion bound = rig.fastest();
    const double stiffness = largest_eigenvalue(mass_scaled_derivative(rig, &Motion::x));
    ASSERT_GE(bound.omega * bound.omega, stiffness * (1 - kRounding));
    const double ratio = bound.omega / std::sqrt(stiffness);
    trials.omega.values.push_back(ratio);
    if (most_compressed(rig) > 1 - 1e-9) trials.uncompressed_omega.values.push_back(ratio);
    const double damping = largest_eigenvalue(mass_scaled_derivative(rig, &Motion::v));
    ASSERT_GE(bound.gamma, damping * (1 - kRounding));
    if (damping > 0) trials.gamma.values.push_back(bound.gamma / damping);
}

TEST(StepBound, IsNeverBelowTheEigenvaluesOfAThousandSheetsNorFarAbove) {
    Trials trials;
    for (std::uint64_t trial = 0; trial < 1000; ++trial) {
        SCOPED_TRACE(trial);
        Dice dice(trial);
        Rig rig(test::random_params(dice));
        test::burn_and_cut(rig, dice);
        if (dice.chance(0.8)) test::crumple(rig, dice);
        rig.refresh();
        compare(rig, trials);
        if (HasFatalFailure()) return;
    }
    RecordProperty("omega_median", std::to_string(trials.omega.median()));
    RecordProperty("omega_largest", std::to_string(trials.omega.largest()));
    RecordProperty("uncompressed_omega_largest",
                   std::to_string(trials.uncompressed_omega.largest()));
    RecordProperty("gamma_median", std::to_string(trials.gamma.median()));
    RecordProperty("gamma_largest", std::to_string(trials.gamma.largest()));
    // as measured, rounded up: 1.19, 1.56 and, without compression, 1.30; friction, which the bound
    // takes to act in all directions, 2.3 and 3.5
    EXPECT_LT(trials.omega.median(), 1.25);
    EXPECT_LT(trials.omega.largest(), 1.6);
    EXPECT_LT(trials.uncompressed_omega.largest(), 1.35);
    EXPECT_LT(trials.gamma.median(), 2.4);
    EXPECT_LT(trials.gamma.largest(), 3.6);
    EXPECT_GT(trials.uncompressed_omega.values.size(), 100u);
}

// A plate as stiff as its springs or a good deal stiffer, bent at rest in any way.
Rig random_plate(std::uint64_t trial) {
    Dice dice(trial);
    Params p = test::random_params(dice);
    const double spring = 7e3 * p.paper.grammage * 1e-4 * p.springs.stiffness_scale;
    p.plate.rigidity_main = spring * 1e-4 * dice.factor(10);
    p.plate.rigidity_cross = spring * 1e-4 * dice.factor(10);
    p.plate.poisson = dice.in(0, 0.5);
    p.plate.char_rigidity = dice.in(0, 1);
    p.plate.clamped = dice.chance(0.7);
    Rig rig(p);
    test::burn_and_cut(rig, dice);
    if (dice.chance(0.8)) test::crumple(rig, dice);
    const double most = dice.chance(0.5) ? 0.5 / std::max(rig.lattice.column_spacing,  //
                                                          rig.lattice.row_spacing)
                                         : 0.0;
    RestCurvature& rest = rig.sheet.rest_curvature;
    for (std::vector<double>* array : {&rest.main, &rest.cross, &rest.twist}) {
        array->resize(static_cast<std::size_t>(rig.lattice.site_count()));
        for (double& value : *array)
            value = dice.in(-most, most);
    }
    rig.refresh();
    return rig;
}

TEST(StepBound, IsNeverBelowTheEigenvaluesOfPlatesNorFarAbove) {
    Trials trials;
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE(trial);
        Rig rig = random_plate(trial);
        compare(rig, trials);
        if (HasFatalFailure()) return;
    }
    RecordProperty("omega_median", std::to_string(trials.omega.median()));
    RecordProperty("omega_largest", std::to_string(trials.omega.largest()));
    // as measured, rounded up: 1.46 and 1.96, where curvature at rest lets the normal turn
    EXPECT_LT(trials.omega.median(), 1.5);
    EXPECT_LT(trials.omega.largest(), 2.0);
}

TEST(StepBound, OfAnEvenPlateIsThatOfItsCheckerboard) {
    // no springs, 40×40 cells of a stiff isotropic plate: ω² = 64 D / (G h⁴) far from borders,
    // whose lighter nodes make the bound 13 % larger
    Params p = plain(40, 40);
    p.springs.structural = p.springs.diagonal = p.springs.bending = p.springs.damping = 0;
    p.plate.rigidity_main = p.plate.rigidity_cross = 1e-3;
    Rig rig(p);
    const double omega = std::sqrt(64 * 1e-3 / (p.paper.grammage * 1e-8));
    EXPECT_GE(rig.fastest().omega, omega);
    EXPECT_LE(rig.fastest().omega, 1.15 * omega);
}

// A crumpled sheet without stress: it is in equilibrium, and moves in all directions about it.
Rig relaxed_rig(std::uint64_t trial, bool damped) {
    Dice dice(trial);
    Params p = test::random_params(dice);
    p.world.air_drag = 0;
    if (!damped) p.springs.damping = 0;
    Rig rig(p);
    test::crumple(rig, dice);
    for (std::size_t slot = 0; slot < rig.sheet.rest_length.size(); ++slot) {
        const auto [a, b] = rig.lattice.slot_ends[slot];
        if (a == kNone) continue;
        const Vector3 d = rig.sheet.position.at(static_cast<std::size_t>(b)) -
                          rig.sheet.position.at(static_cast<std::size_t>(a));
        rig.sheet.rest_length[slot] = d.norm();
    }
    test::burn_and_cut(rig, dice);
    rig.refresh();
    return rig;
}

// Most energy seen in 600 steps of h over that of the random velocities they begin with. These are
// so small, 1e-6 m/s, that the forces are linear.
double growth(Rig rig, IntegratorKind integrator, double h) {
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        Dice dice(n);
        const Vector3 v = dice.vector(1e-6);
        rig.sheet.velocity.set(n, rig.sheet.held[n] != 0 ? Vector3(Vector3::Zero()) : v);
    }
    const double before = rig.energy().total();
    double most = 0;
    for (int run = 0; run < 60; ++run) {
        (void)rig.run(10 * h, 10, integrator);
        const double now = rig.energy().total() / before;
        if (!(now < 1e12)) return 1e12;
        most = std::max(most, now);
    }
    return most;
}

TEST(StepBound, TinyMotionsOfRelaxedSheetsDoNotGrowWithinIt) {
    // Verlet conserves Σ v² + ω² (1 - ω²h²/4) x², which bounds the energy by 1 / (1 - 0.99²) of
    // that at the start; at ωh < 2.6 every mode loses energy under Runge-Kutta
    constexpr double kShare = 0.99;
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
        const bool damped = trial % 2 == 1;
        for (const auto& [integrator, most] :
             {std::pair{IntegratorKind::VelocityVerlet, 1 / (1 - kShare * kShare)},
              {IntegratorKind::Rk4, 1.0}}) {
            Rig rig = relaxed_rig(trial, damped);
            const double h = kShare * stable_step(integrator, rig.fastest());
            EXPECT_LE(growth(relaxed_rig(trial, damped), integrator, h), most)
                << "trial " << trial << " integrator " << static_cast<int>(integrator);
        }
    }
}

TEST(StepBound, JustBeyondTheTrueLimitTinyMotionsGrow) {
    // so that the test above can fail: the limits are ωh = 2 and √8
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        Rig rig = relaxed_rig(trial, false);
        const double omega = std::sqrt(largest_eigenvalue(mass_scaled_derivative(rig, &Motion::x)));
        for (const auto& [integrator, limit] : {std::pair{IntegratorKind::VelocityVerlet, 2.0},
                                                {IntegratorKind::Rk4, std::sqrt(8.0)}}) {
            EXPECT_LT(growth(relaxed_rig(trial, false), integrator, 0.98 * limit / omega), 1e2);
            EXPECT_GT(growth(relaxed_rig(trial, false), integrator, 1.02 * limit / omega), 1e6);
        }
    }
}

// Largest frequency of a sheet too large for the above, from below, by power iteration.
double true_omega(const Rig& rig) {
    const std::size_t n = rig.sheet.mass.size();
    std::vector<Vector3> v(n), w(n);
    Dice dice(0);
    for (Vector3& x : v)
        x = dice.vector(1);
    double value = 0;
    for (int iteration = 0; iteration < 400; ++iteration) {
        for (Vector3& x : w)
            x.setZero();
        for_each_spring(rig.lattice, rig.network, [&](Index i, Index j, Index, double k, double) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
            const Vector3 axis = (rig.sheet.position.at(b) - rig.sheet.position.at(a)).normalized();
            const double sa = std::sqrt(rig.loads.inverse_mass[a]),
                         sb = std::sqrt(rig.loads.inverse_mass[b]);
            const Vector3 f = k * axis.dot(sb * v[b] - sa * v[a]) * axis;
            w[b] += sb * f;
            w[a] -= sa * f;
        });
        double norm = 0;
        for (const Vector3& x : w)
            norm += x.squaredNorm();
        value = std::sqrt(norm);
        for (std::size_t i = 0; i < n; ++i)
            v[i] = w[i] / value;
    }
    return std::sqrt(value);
}

TEST(StepBound, AtRestOnThePapersLatticeIsWithinTwelvePerCentOfTheTruth) {
    Params p = plain(32, 48);
    p.sheet.width = 0.21;
    p.sheet.height = 0.297;
    p.springs.damping = 0;
    Rig rig(p);
    const double bound = rig.fastest().rate(), truth = true_omega(rig);
    EXPECT_GE(bound, truth);
    EXPECT_LE(bound, 1.12 * truth);
}

// The largest |λ| of a leapfrog step for x'' = -ω² x - γ x', whose friction is taken at the
// velocity u, by `lead` ahead of the last one: see Leap.
double growth_of_leaps(const FastestMotion& motion, double h, double lead) {
    const auto step = [&](const Eigen::Vector3d& xwu) -> Eigen::Vector3d {
        const double a = -motion.omega * motion.omega * xwu[0] - motion.gamma * xwu[2];
        const double w = xwu[1] + h * a;
        return {xwu[0] + h * w, w, w + lead * a};
    };
    Eigen::Matrix3d matrix;
    matrix << step({1, 0, 0}), step({0, 1, 0}), step({0, 0, 1});
    return matrix.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(StepBound, OfLeapfrogIsWhereASingleOscillatorBeginsToGrow) {
    for (const FastestMotion& motion :
         std::vector<FastestMotion>{{1.0, 0.0}, {1.0, 0.3}, {0.7, 2.0}, {0.1, 5.0}, {40.0, 1.0}}) {
        const double verlet = stable_step(IntegratorKind::VelocityVerlet, motion);
        EXPECT_LE(growth_of_leaps(motion, 0.999 * verlet, 0.4995 * verlet), 1.0 + 1e-12);
        EXPECT_GT(growth_of_leaps(motion, 1.001 * verlet, 0.5005 * verlet), 1.0 + 1e-6);
        const double euler = stable_step(IntegratorKind::SemiImplicitEuler, motion);
        EXPECT_LE(growth_of_leaps(motion, 0.999 * euler, 0.0), 1.0 + 1e-12);
        EXPECT_GT(growth_of_leaps(motion, 1.001 * euler, 0.0), 1.0 + 1e-6);
    }
}

}  // namespace
}  // namespace ember
