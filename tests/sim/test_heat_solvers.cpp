// The heat solvers: orders, conservation on cut sheets, no overshoot, and what auto chooses.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "heat_rig.h"

namespace ember {
namespace {

using test::HeatRig;
using test::kAmbient;
using test::kHeatSolvers;
using test::plain;
using test::tube;

constexpr double kPi = std::numbers::pi;

double cosine(const HeatRig& rig, int p, int q, Index row, Index column) {
    return std::cos(p * kPi * column / rig.lattice.cell_columns) *
           std::cos(q * kPi * row / rig.lattice.cell_rows);
}

// Decay rate of a mode on the lattice, exactly.
double rate_of(const HeatRig& rig, int p, int q) {
    const double sx = std::sin(p * kPi / (2.0 * rig.lattice.cell_columns));
    const double sz = std::sin(q * kPi / (2.0 * rig.lattice.cell_rows));
    const Conduction& op = rig.scratch.conduction;
    return 4 * (op.even_main * sx * sx + op.even_cross * sz * sz);
}

// Error of the amplitude after `steps` steps of `dt` against the exact exponential in time.
double time_error(HeatSolverKind solver, double dt, int steps) {
    HeatRig rig(plain(24, 36), solver);
    rig.set([&](Index r, Index c) { return kAmbient + 400.0 + 100.0 * cosine(rig, 2, 3, r, c); });
    for (int i = 0; i < steps; ++i)
        rig.conduct(dt);
    EXPECT_EQ(rig.counters.heat_guarded, 0);
    const double exact = 100.0 * std::exp(-rate_of(rig, 2, 3) * dt * steps);
    double worst = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            const double t = kAmbient + 400.0 + exact * cosine(rig, 2, 3, r, c);
            worst = std::max(worst, std::abs(rig.sheet.temperature[rig.site(r, c)] - t));
        }
    }
    return worst;
}

double order_in_time(HeatSolverKind solver, double longest, int fewest, int sizes) {
    std::vector<double> errors;
    for (int k = 0; k < sizes; ++k)
        errors.push_back(time_error(solver, longest / (1 << k), fewest << k));
    // slope of the least-squares line through (k, log2 error)
    double sum = 0, weight = 0;
    for (int k = 0; k < sizes; ++k) {
        const double x = k - 0.5 * (sizes - 1);
        sum -= x * std::log2(errors[static_cast<std::size_t>(k)]);
        weight += x * x;
    }
    return sum / weight;
}

TEST(HeatSolvers, FtcsIsOfFirstOrderInTime) {
    const double limit = HeatRig(plain(24, 36)).limit();
    EXPECT_NEAR(order_in_time(HeatSolverKind::Ftcs, limit, 20, 5), 1.0, 0.1);
}

TEST(HeatSolvers, AdiIsOfSecondOrderInTime) {
    const double limit = HeatRig(plain(24, 36)).limit();
    EXPECT_NEAR(order_in_time(HeatSolverKind::Adi, 4 * limit, 10, 5), 2.0, 0.1);
}

TEST(HeatSolvers, Rkl2IsOfSecondOrderInTime) {
    // all of at most a limit, so that the number of stages, which also changes the error, stays
    const double limit = HeatRig(plain(24, 36)).limit();
    EXPECT_NEAR(order_in_time(HeatSolverKind::Rkl2, 2.4 * limit, 8, 5), 2.0, 0.1);
}

// du/dt = L u + s with u = T0 + A cos(pi x/a) cos(2 pi y/b) exp(-t): the solver between two halves
// of the source, grid and step refined together.
double manufactured_error(HeatSolverKind solver, int cells, int steps) {
    Params params = plain(cells, cells);
    params.sheet.width = params.sheet.height = 0.2;
    HeatRig rig(params, solver);
    const double alpha = params.paper.conductivity /
                         (params.paper.c_s * params.paper.density * params.paper.specific_heat);
    const double rate = alpha * (1 + 4) * kPi * kPi / (0.2 * 0.2);
    const auto exact = [&](Index r, Index c, double t) {
        return 700.0 + 100.0 * cosine(rig, 1, 2, r, c) * std::exp(-t);
    };
    const auto add_source = [&](double from, double to) {  // s = (rate - 1) (u - T0), integrated
        const double integral = (rate - 1) * (std::exp(-from) - std::exp(-to));
        rig.set([&](Index r, Index c) {
            return rig.sheet.temperature[rig.site(r, c)] +
                   100.0 * cosine(rig, 1, 2, r, c) * integral;
        });
    };
    return error_after_a_second(rig, steps, exact, add_source);
}

TEST(HeatSolvers, ApproachAManufacturedSolutionToSecondOrderWhenGridAndStepAreRefined) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        std::vector<double> errors;
        for (const int k : {1, 2, 4, 8}) {
            // the explicit one is of first order in a step that goes with the square of the spacing
            const int steps = solver == HeatSolverKind::Ftcs ? 5 * k * k : 5 * k;
            errors.push_back(manufactured_error(solver, 10 * k, steps));
        }
        for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
            EXPECT_NEAR(std::log2(errors[i] / errors[i + 1]), 2.0, 0.25)
                << "solver " << static_cast<int>(solver) << " grid " << i;
        }
    }
}

void expect_conserved(const Params& params, HeatSolverKind solver, double limits) {
    HeatRig rig(params, solver);
    rig.cut_at_random(0.2);
    rig.heat_spots();
    const double before = rig.stored(), dt = limits * rig.limit();
    for (int i = 0; i < 300; ++i)
        rig.conduct(dt);
    EXPECT_NEAR(rig.stored() / before, 1.0, 1e-12)
        << "solver " << static_cast<int>(solver) << ", " << limits << " limits";
}

TEST(HeatSolvers, ConserveHeatOnCutSheetsAndTubes) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        for (const double limits : {0.7, 8.0, 200.0}) {
            expect_conserved(plain(23, 37), solver, limits);
            expect_conserved(tube(23, 37), solver, limits);
        }
    }
}

void expect_no_overshoot(const Params& params, HeatSolverKind solver, double limits) {
    HeatRig rig(params, solver);
    rig.cut_at_random(0.1);
    // a jump from row to row and column to column, and single hot nodes
    rig.set([&](Index r, Index c) { return r < 9 && c < 17 ? 1100.0 : kAmbient; });
    rig.heat_spots();
    for (int i = 0; i < 3; ++i) {
        rig.conduct(limits * rig.limit());
        for (Index n = 0; n < rig.lattice.site_count(); ++n) {
            const double t = rig.sheet.temperature[static_cast<std::size_t>(n)];
            ASSERT_GE(t, kAmbient - 1e-10) << limits << " limits, step " << i;
            ASSERT_LE(t, 1100.0 + 1e-10) << limits << " limits, step " << i;
        }
    }
    if (solver == HeatSolverKind::Adi && limits >= 100) {
        EXPECT_GT(rig.counters.heat_guarded, 0);
    }
}

TEST(HeatSolvers, StayWithinTheRangeTheyStartedFromHoweverLongTheStep) {
    for (const HeatSolverKind solver : kHeatSolvers) {
        for (const double limits : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
            expect_no_overshoot(plain(20, 40), solver, limits);
            expect_no_overshoot(tube(20, 40), solver, limits);
        }
    }
}

// Longest of the differences between two solvers after a smooth field has spread.
double difference(const Params& params, HeatSolverKind a, HeatSolverKind b) {
    std::vector<double> result[2];
    for (const int k : {0, 1}) {
        HeatRig rig(params, k == 0 ? a : b);
        rig.cut_at_random(0.15);
        rig.set([&](Index r, Index c) { return 600.0 + 200.0 * std::sin(0.3 * r + 0.2 * c); });
        for (int i = 0; i < 200; ++i)
            rig.conduct(0.1 * rig.limit());
        result[k] = rig.sheet.temperature;
    }
    double worst = 0;
    for (std::size_t n = 0; n < result[0].size(); ++n)
        worst = std::max(worst, std::abs(result[0][n] - result[1][n]));
    return worst;
}

TEST(HeatSolvers, AgreeOnCutSheetsAndTubes) {
    for (const Params& params : {plain(40, 70), tube(40, 70)}) {
        // both of second order, by entirely different ways
        EXPECT_LT(difference(params, HeatSolverKind::Rkl2, HeatSolverKind::Adi), 0.2);
        EXPECT_LT(difference(params, HeatSolverKind::Ftcs, HeatSolverKind::Adi), 2.0);
    }
}

HeatSolverKind chosen(int rows, int columns) {
    Params params;
    params.sheet.rows = rows;
    params.sheet.columns = columns;
    const HeatRig rig(params);
    return choose_heat_solver(rig.scratch.conduction, HeatSolverKind::Auto, 1.0 / 60).solver;
}

TEST(HeatSolvers, AutoTakesTheExplicitOneOnCoarseLatticesAndTheImplicitOneOnFine) {
    EXPECT_EQ(chosen(32, 48), HeatSolverKind::Ftcs);
    EXPECT_EQ(chosen(128, 192), HeatSolverKind::Ftcs);
    EXPECT_EQ(chosen(512, 768), HeatSolverKind::Adi);
}

}  // namespace
}  // namespace ember
