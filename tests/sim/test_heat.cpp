// Conduction against exact discrete modes, its order in space, its bounds and its ledger.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rig.h"
#include "sim/heat.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

constexpr double kAmbient = 293.15;
constexpr double kPi = std::numbers::pi;

HeatScratch conduction(Rig& rig) {
    HeatScratch scratch;
    rebuild_heat(rig.lattice, rig.sheet, rig.network, rig.params.paper, scratch);
    return scratch;
}

// Cosine mode (p, q) of a sheet with insulated edges at node (row, column).
double mode(const Rig& rig, int p, int q, Index row, Index column) {
    return std::cos(p * kPi * column / rig.lattice.cell_columns) *
           std::cos(q * kPi * row / rig.lattice.cell_rows);
}

void set_mode(Rig& rig, int p, int q, double amplitude) {
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            rig.sheet.temperature[rig.site(r, c)] =
                kAmbient + 400.0 + amplitude * mode(rig, p, q, r, c);
        }
    }
}

double diffusivity(const PaperParams& p) {
    return p.conductivity / (p.c_s * p.density * p.specific_heat);
}

// Relative L2 error of mode (2, 1) against the exact solution of the equation after 0.5 s.
double pde_error(int cells) {
    Params params = plain(cells, cells);
    params.numerics.heat_solver = HeatSolverKind::Ftcs;
    params.sheet.width = params.sheet.height = 0.2;
    Rig rig(params);
    HeatScratch scratch = conduction(rig);
    set_mode(rig, 2, 1, 100.0);
    StepCounters counters;
    // steps far below the limit, so that the error of space is what is left
    constexpr int kRefine = 64;
    constexpr double kTime = 0.5;
    conduct_heat(rig.sheet, params, kTime, kRefine, scratch, counters);
    const double decay =
        std::exp(-diffusivity(params.paper) * (4 + 1) * kPi * kPi / (0.2 * 0.2) * kTime);
    double error = 0, norm = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            const double exact = 100.0 * decay * mode(rig, 2, 1, r, c);
            const double got = rig.sheet.temperature[rig.site(r, c)] - kAmbient - 400.0;
            error += (got - exact) * (got - exact);
            norm += exact * exact;
        }
    }
    return std::sqrt(error / norm);
}

TEST(Heat, EveryStepMultipliesADiscreteModeByItsExactFactor) {
    Params params = plain(12, 20);
    params.sheet.width = 0.21;  // dx and dz differ
    params.numerics.heat_solver = HeatSolverKind::Ftcs;
    Rig rig(params);
    HeatScratch scratch = conduction(rig);
    set_mode(rig, 1, 1, 100.0);
    const double dt = 0.5 / scratch.conduction.most_per_capacity;
    const double alpha = diffusivity(params.paper);
    const double sx = std::sin(kPi / (2.0 * 20)), sz = std::sin(kPi / (2.0 * 12));
    const double dx = rig.lattice.column_spacing, dz = rig.lattice.row_spacing;
    const double factor = 1 - 4 * alpha * dt * (sx * sx / (dx * dx) + sz * sz / (dz * dz));
    StepCounters counters;
    constexpr int kSteps = 400;
    for (int i = 0; i < kSteps; ++i) {
        conduct_heat(rig.sheet, params, dt, 1, scratch, counters);
    }
    ASSERT_EQ(counters.heat_substeps, kSteps);
    const double amplitude = 100.0 * std::pow(factor, kSteps);
    ASSERT_GT(amplitude, 1.0);
    double worst = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c) {
            const double exact = kAmbient + 400.0 + amplitude * mode(rig, 1, 1, r, c);
            worst = std::max(worst, std::abs(rig.sheet.temperature[rig.site(r, c)] - exact));
        }
    }
    EXPECT_LE(worst / (kAmbient + 400.0), 1e-13);
}

TEST(Heat, TheErrorFallsFourfoldWhenTheSpacingHalves) {
    const double e16 = pde_error(16), e32 = pde_error(32), e64 = pde_error(64);
    EXPECT_NEAR(std::log2(e16 / e32), 2.0, 0.1);
    EXPECT_NEAR(std::log2(e32 / e64), 2.0, 0.1);
    EXPECT_LT(e64, 5e-4);
}

TEST(Heat, ConductionKeepsTheTotalAndStaysBetweenItsExtremes) {
    Rig rig(plain(9, 13));
    HeatScratch scratch = conduction(rig);
    rig.sheet.temperature[rig.site(0, 0)] = 1200.0;
    rig.sheet.temperature[rig.site(4, 6)] = 900.0;
    const double before = stored_heat(rig.sheet, rig.params.paper, kAmbient);
    StepCounters counters;
    for (int i = 0; i < 200; ++i) {
        conduct_heat(rig.sheet, rig.params, 0.05, 1, scratch, counters);
        for (const double t : rig.sheet.temperature) {
            ASSERT_GE(t, kAmbient - 1e-9);
            ASSERT_LE(t, 1200.0);
        }
    }
    EXPECT_NEAR(stored_heat(rig.sheet, rig.params.paper, kAmbient) / before, 1.0, 1e-12);
}

TEST(Heat, SourcesAndLossesNeverOvershootHoweverLongTheStep) {
    Params params = plain(2, 2);
    params.heat.emissivity = 0.9;
    for (const double dt : {1e-3, 1.0 / 60, 1.0, 1e3}) {
        Rig rig(params);
        HeatLedger ledger;
        StepCounters counters;
        const std::vector<double> source(rig.sheet.mass.size(), 1e5);
        rig.sheet.phase[0] = Phase::Burning;
        for (int i = 0; i < 50; ++i) {
            exchange_heat(rig.sheet, params, source, dt, ledger, counters);
            for (const double t : rig.sheet.temperature) {
                ASSERT_GE(t, kAmbient);
                ASSERT_LE(t, params.heat.flame_limit);
            }
        }
        const double given = ledger.given_fire + ledger.given_burning;
        EXPECT_NEAR((stored_heat(rig.sheet, params.paper, kAmbient) + ledger.lost_air) / given, 1.0,
                    1e-10);
    }
}

TEST(Heat, ALossIsTheExactExponential) {
    Params params = plain(1, 1);
    Rig rig(params);
    rig.sheet.temperature.assign(4, kAmbient + 500.0);
    HeatLedger ledger;
    StepCounters counters;
    exchange_heat(rig.sheet, params, {}, 0.7, ledger, counters);
    const double rate =
        2 * params.heat.convection / (params.paper.specific_heat * params.paper.grammage);
    EXPECT_NEAR(rig.sheet.temperature[0], kAmbient + 500.0 * std::exp(-0.7 * rate), 1e-9);
}

// Both faces of a hot sheet radiate ε σ T^4 and receive ε σ T_ambient^4.
TEST(Heat, RadiationFollowsStefanAndBoltzmann) {
    Params params = plain(1, 1);
    params.heat.convection = 0;
    params.heat.emissivity = 0.9;
    Rig rig(params);
    const double hot = 900.0, dt = 1e-6;
    rig.sheet.temperature.assign(4, hot);
    HeatLedger ledger;
    StepCounters counters;
    exchange_heat(rig.sheet, params, {}, dt, ledger, counters);
    const double power =
        2 * 0.9 * 5.670374419e-8 * (std::pow(hot, 4) - std::pow(kAmbient, 4));  // [W/m^2]
    const double rate = power / (params.paper.specific_heat * params.paper.grammage);
    EXPECT_NEAR((hot - rig.sheet.temperature[0]) / (rate * dt), 1.0, 1e-6);
}

// The sheet is cut from edge to edge along the cross direction; only the left half is warm.
void expect_a_tear_conducts_nothing(HeatSolverKind solver) {
    Rig rig(plain(4, 8));
    rig.params.numerics.heat_solver = solver;
    rig.sheet.phase.assign(rig.sheet.phase.size(), Phase::BurntOut);
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        cut_site(rig.lattice, rig.sheet, rig.lattice.site(r, 4), CutLine::AlongCross);
    }
    rig.refresh();
    HeatScratch scratch = conduction(rig);
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        rig.sheet.temperature[rig.site(r, 1)] = 1000.0;
    }
    StepCounters counters;
    conduct_heat(rig.sheet, rig.params, 10.0, 1, scratch, counters);
    double left = 0, right = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        left = std::max(left, rig.sheet.temperature[rig.site(r, 3)]);
        right = std::max(right, rig.sheet.temperature[rig.site(r, 6)]);
    }
    EXPECT_GT(left, kAmbient + 50);
    // the first copy of a cut node stays with one side; beyond it everything is cold
    EXPECT_EQ(right, kAmbient);
}

TEST(Heat, ATearConductsNothing) {
    for (const HeatSolverKind solver :
         {HeatSolverKind::Auto, HeatSolverKind::Ftcs, HeatSolverKind::Rkl2, HeatSolverKind::Adi}) {
        expect_a_tear_conducts_nothing(solver);
    }
}

TEST(Heat, AColdSheetCostsNothing) {
    Rig rig(plain(4, 8));
    HeatScratch scratch = conduction(rig);
    HeatLedger ledger;
    StepCounters counters;
    conduct_heat(rig.sheet, rig.params, 1.0, 1, scratch, counters);
    exchange_heat(rig.sheet, rig.params, {}, 1.0, ledger, counters);
    EXPECT_EQ(counters.heat_nodes, 0);
    EXPECT_EQ(counters.heat_substeps, 0);
}

TEST(Heat, HeldNodesReturnToAmbientAndTheLedgerKnows) {
    Params params = plain(2, 2);
    params.sheet.held = HeldEdge::MainStart;
    Rig rig(params);
    rig.sheet.temperature.assign(9, 400.0);
    HeatLedger ledger;
    const double before = stored_heat(rig.sheet, params.paper, kAmbient);
    cool_held(rig.sheet, params.paper, kAmbient, ledger);
    EXPECT_EQ(rig.sheet.temperature[rig.site(1, 0)], kAmbient);
    EXPECT_EQ(rig.sheet.temperature[rig.site(1, 1)], 400.0);
    EXPECT_NEAR(ledger.lost_held + stored_heat(rig.sheet, params.paper, kAmbient), before, 1e-15);
}

}  // namespace
}  // namespace ember
