#include "sim/heat_choice.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/heat_solver.h"

namespace ember {
namespace {

// Time per node of one step, that of FTCS being 1: the median of tests/bench/heat_cost.cpp over
// lattices of 33 x 49, 129 x 193 and 513 x 769 sites. A stage of RKL2 takes 2.6 and there are at
// least three: where three would do, so do three steps of FTCS, and five cost more than ADI. It is
// therefore never the cheapest.
constexpr double kAdiStep = 11.0;

// Decay rate of the mode with four half waves in each direction [1/s], from g/C of an uncut
// inner edge, which is alpha / dx².
double slow_rate(const Conduction& op) {
    constexpr double kFourHalfWaves = 4.0 * std::numbers::pi;
    const double across_columns = kFourHalfWaves / std::max(1, op.column_count - 1);
    const double across_rows = kFourHalfWaves / std::max(1, op.row_count - 1);
    return op.even_main * across_columns * across_columns +
           op.even_cross * across_rows * across_rows;
}

// Steps that keep a second-order error below that of FTCS. In a time t a mode of rate r is off by
// r² h t / 2 under FTCS of step h, and by at most r³ H² t / 12 under ADI of step H.
double accurate_steps(const Conduction& op, double dt) {
    const double rate = slow_rate(op);
    if (!(rate > 0) || !(op.most_per_capacity > 0)) return 1.0;
    const double longest = std::sqrt(6.0 / (op.most_per_capacity * rate));
    return std::max(1.0, std::ceil(dt / longest));
}

}  // namespace

HeatChoice choose_heat_solver(const Conduction& op, HeatSolverKind wanted, double dt) {
    const double explicit_count = explicit_steps(op, dt);
    if (wanted == HeatSolverKind::Ftcs) return {wanted, explicit_count};
    if (wanted != HeatSolverKind::Auto) return {wanted, 1.0};
    const double steps = accurate_steps(op, dt);
    if (steps * kAdiStep < explicit_count) return {HeatSolverKind::Adi, steps};
    return {HeatSolverKind::Ftcs, explicit_count};
}

}  // namespace ember
