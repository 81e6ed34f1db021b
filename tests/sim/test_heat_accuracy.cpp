// How accurate heat is where solvers choose for themselves, and where the solution is no mode of
// the lattice.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <vector>

#include "heat_rig.h"

namespace ember {
namespace {

using test::HeatRig;
using test::kAmbient;
using test::kHeatSolvers;
using test::plain;

constexpr double kPi = std::numbers::pi;

struct Mode {
    int p, q;  // half waves along the main and the cross direction
};

double shape_of(const Mode& mode, const HeatRig& rig, Index row, Index column) {
    return std::cos(mode.p * kPi * column / rig.lattice.cell_columns) *
           std::cos(mode.q * kPi * row / rig.lattice.cell_rows);
}

// Decay rate of a mode on the lattice [1/s], exactly.
double rate_of(const Mode& mode, const HeatRig& rig) {
    const double sx = std::sin(mode.p * kPi / (2.0 * rig.lattice.cell_columns));
    const double sz = std::sin(mode.q * kPi / (2.0 * rig.lattice.cell_rows));
    const Conduction& op = rig.scratch.conduction;
    return 4 * (op.even_main * sx * sx + op.even_cross * sz * sz);
}

// Largest error over the amplitude at the start, after about one decay time, but at least a tick.
double error_of(const Params& params, HeatSolverKind solver, const Mode& mode, double tick) {
    HeatRig rig(params, solver);
    const double mean = kAmbient + 400.0, amplitude = 100.0, rate = rate_of(mode, rig);
    rig.set([&](Index r, Index c) { return mean + amplitude * shape_of(mode, rig, r, c); });
    const int ticks = std::clamp(static_cast<int>(1 / (rate * tick)), 1, 20);
    for (int i = 0; i < ticks; ++i)
        rig.conduct(tick);
    EXPECT_EQ(rig.counters.heat_guarded, 0);
    const double left = amplitude * std::exp(-rate * tick * ticks);
    double worst = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            const double exact = mean + left * shape_of(mode, rig, r, c);
            worst = std::max(worst, std::abs(rig.sheet.temperature[rig.site(r, c)] - exact));
        }
    }
    return worst / amplitude;
}

// Sheets and ticks for which auto does not take FTCS anyway.
struct Case {
    Params params;
    double tick;  // [s]
};

std::vector<Case> cases_of_other_solvers() {
    std::vector<Case> cases;
    for (const auto& [rows, columns, width, height] :
         {std::tuple{64, 96, 0.210, 0.297}, {128, 32, 0.210, 0.297}, {100, 100, 0.2, 0.2}}) {
        for (const double c_s : {2e-6, 5e-6, 2e-5}) {
            for (const double rate : {30.0, 60.0, 240.0}) {
                Case c{plain(rows, columns), 1 / rate};
                c.params.sheet.width = width;
                c.params.sheet.height = height;
                c.params.paper.c_s = c_s;
                const HeatRig rig(c.params);
                const HeatSolverKind chosen =
                    choose_heat_solver(rig.scratch.conduction, HeatSolverKind::Auto, c.tick).solver;
                if (chosen != HeatSolverKind::Ftcs) cases.push_back(c);
            }
        }
    }
    return cases;
}

TEST(HeatAccuracy, AutoIsMoreAccurateThanFtcsForUpToFourHalfWaves) {
    // by its choice of steps, to leading order: r³ H² t / 12 <= r² h t / 2; 0.61 of it was measured
    const std::vector<Case> cases = cases_of_other_solvers();
    EXPECT_GE(cases.size(), 10u);
    double largest = 0;  // ratio of errors
    for (const Case& c : cases) {
        for (const Mode mode : {Mode{1, 0}, {0, 1}, {1, 1}, {2, 3}, {4, 0}, {0, 4}, {4, 4}}) {
            const double error = error_of(c.params, HeatSolverKind::Auto, mode, c.tick);
            const double explicit_error = error_of(c.params, HeatSolverKind::Ftcs, mode, c.tick);
            EXPECT_LT(error, explicit_error) << mode.p << ' ' << mode.q;
            largest = std::max(largest, error / explicit_error);
        }
    }
    RecordProperty("largest_ratio", std::to_string(largest));
}

// What a step of h multiplies a mode by that decays at the rates `main` and `cross` [1/s] along the
// two directions. ADI: Peaceman & Rachford, each direction a Crank-Nicolson step.
double adi_factor(double main, double cross, double h) {
    const double a = 0.5 * main * h, b = 0.5 * cross * h;
    return (1 - a) / (1 + a) * (1 - b) / (1 + b);
}

// RKL2: a + b P_s(1 + w z) with the Legendre polynomial P_s (Meyer, Balsara & Aslam, eq. 14).
double rkl2_factor(double rate, double h, std::int64_t stages) {
    const auto s = static_cast<double>(stages);
    const double w = 4 / (s * s + s - 2), b = (s * s + s - 2) / (2 * s * (s + 1));
    const double x = 1 - w * rate * h;
    double before = 1, now = x;  // P_0, P_1
    for (int j = 2; j <= static_cast<int>(stages); ++j) {
        const double next = ((2 * j - 1) * x * now - (j - 1) * before) / j;
        before = now;
        now = next;
    }
    return 1 - b + b * now;
}

// Largest deviation of one step of h from `factor` times the mode, in units of the temperature.
double deviation(HeatRig& rig, const Mode& mode, double h, double factor) {
    const double mean = kAmbient + 400.0;
    rig.set([&](Index r, Index c) { return mean + 100.0 * shape_of(mode, rig, r, c); });
    rig.conduct(h);
    EXPECT_EQ(rig.counters.heat_guarded, 0);
    double worst = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            const double known = mean + factor * 100.0 * shape_of(mode, rig, r, c);
            worst = std::max(worst, std::abs(rig.sheet.temperature[rig.site(r, c)] - known));
        }
    }
    return worst / mean;
}

TEST(HeatAccuracy, AStepOfAdiAndOfRkl2MultipliesEveryModeByItsKnownFactor) {
    // this is also how badly they treat short waves: ADI leaves two thirds of the shortest after
    // twenty explicit limits
    Params params = plain(24, 36);
    params.sheet.width = 0.3;             // dx and dz differ
    constexpr double kRoundings = 1e-14;  // some tens, of 1e-16 each
    for (const double limits : {0.5, 3.0, 20.0}) {
        for (const Mode mode : {Mode{1, 0}, {2, 3}, {8, 5}, {16, 24}, {36, 0}, {0, 24}, {36, 24}}) {
            HeatRig implicit(params, HeatSolverKind::Adi), staged(params, HeatSolverKind::Rkl2);
            const double h = limits * implicit.limit();
            const double main = rate_of({mode.p, 0}, implicit),
                         cross = rate_of({0, mode.q}, implicit);
            EXPECT_LE(deviation(implicit, mode, h, adi_factor(main, cross, h)), kRoundings);
            const double factor = rkl2_factor(main + cross, h, rkl2_stages(limits));
            EXPECT_LE(deviation(staged, mode, h, factor), kRoundings);
        }
    }
}

// A profile from 0 to 1 that no heat leaves through its ends: f = s² (3 - 2 s).
double profile(double s) {
    return s * s * (3 - 2 * s);
}
double curvature(double s) {
    return 6 - 12 * s;
}

// du/dt = α ∇²u + s with u = T0 + A f(x/a) f(z/b) exp(-t), which is no mode of the lattice: heat
// crosses every inner face and s differs at every node. The solver stands between two halves of
// the source; grid and step are refined together. RMS error [K].
double manufactured_error(HeatSolverKind solver, int refined, int steps) {
    Params params = plain(8 * refined, 12 * refined);
    params.sheet.width = 0.16;
    params.sheet.height = 0.2;
    HeatRig rig(params, solver);
    const PaperParams& paper = params.paper;
    const double alpha = paper.conductivity / (paper.c_s * paper.density * paper.specific_heat);
    const auto along = [&](Index c) { return 1.0 * c / rig.lattice.cell_columns; };
    const auto across = [&](Index r) { return 1.0 * r / rig.lattice.cell_rows; };
    const auto exact = [&](Index r, Index c, double t) {
        return 700.0 + 300.0 * profile(along(c)) * profile(across(r)) * std::exp(-t);
    };
    const auto source = [&](Index r, Index c) {  // s / exp(-t)
        const double f = profile(along(c)), g = profile(across(r));
        const double laplacian =
            curvature(along(c)) / (0.2 * 0.2) * g + f * curvature(across(r)) / (0.16 * 0.16);
        return 300.0 * (-f * g - alpha * laplacian);
    };
    const auto add_source = [&](double from, double to) {
        const double integral = std::exp(-from) - std::exp(-to);
        rig.set([&](Index r, Index c) {
            return rig.sheet.temperature[rig.site(r, c)] + source(r, c) * integral;
        });
    };
    return error_after_a_second(rig, steps, exact, add_source);
}

TEST(HeatAccuracy, APolynomialSolutionIsApproachedToSecondOrder) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        std::vector<double> errors;
        for (const int k : {1, 2, 4, 8}) {
            // the explicit one is of first order in a step that goes with the square of the spacing
            const int steps = solver == HeatSolverKind::Ftcs ? 5 * k * k : 5 * k;
            errors.push_back(manufactured_error(solver, k, steps));
        }
        for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
            EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2.0, 0.25)
                << "solver " << static_cast<int>(solver) << " grid " << i;
        }
    }
}

}  // namespace
}  // namespace ember
