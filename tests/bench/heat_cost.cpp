// What conduction costs: the cosine problem by every solver on three lattices.
//
//   heat_cost          seconds per simulated second and relative error, and the cost per node of a
//                      stage relative to FTCS, from which the constants of sim/heat_choice.cpp are
//
// The solvers take turns and the median of the turns counts, so that a busy machine matters little.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "sim/heat.h"
#include "sim/lattice.h"
#include "sim/scene.h"
#include "sim/sheet_builder.h"

namespace {

using ember::HeatSolverKind;
using ember::Index;

constexpr double kAmbient = 293.15, kBase = 400.0, kAmplitude = 100.0;
constexpr double kPi = std::numbers::pi;
constexpr double kSeconds = 2.0;
constexpr int kTurns = 7;

struct Sheet {
    ember::Params params;
    ember::Lattice lattice;
    ember::SheetState state;
    ember::SpringNetwork network;
    ember::HeatScratch scratch;
    ember::StepCounters counters;

    // rows x columns sites of the sheet of the benchmark problems
    Sheet(int rows, int columns) {
        params.sheet.rows = rows - 1;
        params.sheet.columns = columns - 1;
        params.sheet.width = 0.2034375;
        params.sheet.height = 0.2908125;
        params.sheet.imperfection = 0;
        const ember::Scene scene = ember::make_scene(params);
        lattice = ember::make_lattice(scene.sheets[0], params.paper, params.springs, 1, 0);
        state = ember::make_sheet(scene.sheets[0], lattice, params, 0);
        ember::rebuild_network(lattice, state, network);
        ember::rebuild_heat(lattice, state, network, params.paper, scratch);
    }

    [[nodiscard]] double mode(Index row, Index column) const {
        return std::cos(2 * kPi * column / lattice.cell_columns) *
               std::cos(kPi * row / lattice.cell_rows);
    }

    [[nodiscard]] double decay(double t) const {
        const ember::PaperParams& p = params.paper;
        const double alpha = p.conductivity / (p.c_s * p.density * p.specific_heat);
        const double kx = 2 * kPi / params.sheet.height, kz = kPi / params.sheet.width;
        return std::exp(-alpha * (kx * kx + kz * kz) * t);
    }

    void set_mode() {
        for (Index r = 0; r < lattice.row_count; ++r) {
            for (Index c = 0; c < lattice.column_count; ++c) {
                state.temperature[static_cast<std::size_t>(lattice.site(r, c))] =
                    kAmbient + kBase + kAmplitude * mode(r, c);
            }
        }
    }

    [[nodiscard]] double error() const {
        double off = 0, norm = 0;
        for (Index r = 0; r < lattice.row_count; ++r) {
            for (Index c = 0; c < lattice.column_count; ++c) {
                const double exact = kAmplitude * decay(kSeconds) * mode(r, c);
                const double t = state.temperature[static_cast<std::size_t>(lattice.site(r, c))];
                off += std::pow(t - kAmbient - kBase - exact, 2);
                norm += exact * exact;
            }
        }
        return std::sqrt(off / norm);
    }
};

struct Method {
    const char* name;
    HeatSolverKind solver;
    double dt;  // [s]
    std::vector<double> seconds = {};
    double error = 0, stages = 0, guarded = 0;
};

void take_turn(Sheet& sheet, Method& method) {
    sheet.set_mode();
    sheet.counters = {};
    sheet.params.numerics.heat_solver = method.solver;
    const int steps = static_cast<int>(std::lround(kSeconds / method.dt));
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < steps; ++i) {
        ember::conduct_heat(sheet.state, sheet.params, kSeconds / steps, 1, sheet.scratch,
                            sheet.counters);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    method.seconds.push_back(took.count());
    method.error = sheet.error();
    method.stages = static_cast<double>(sheet.counters.heat_substeps);
    method.guarded = static_cast<double>(sheet.counters.heat_guarded);
}

void measure(int rows, int columns) {
    Sheet sheet(rows, columns);
    std::vector<Method> methods = {
        {"FTCS", HeatSolverKind::Ftcs, 1.0},      {"FTCS per tick", HeatSolverKind::Ftcs, 1.0 / 60},
        {"RKL2", HeatSolverKind::Rkl2, 1.0 / 30}, {"RKL2", HeatSolverKind::Rkl2, 1.0 / 60},
        {"ADI", HeatSolverKind::Adi, 1.0 / 30},   {"ADI", HeatSolverKind::Adi, 1.0 / 60},
        {"auto", HeatSolverKind::Auto, 1.0 / 60}};
    for (int turn = 0; turn < kTurns; ++turn) {
        for (Method& method : methods)
            take_turn(sheet, method);
    }
    const double nodes = static_cast<double>(rows) * columns;
    double unit = 0;
    for (Method& method : methods) {
        std::nth_element(method.seconds.begin(), method.seconds.begin() + kTurns / 2,
                         method.seconds.end());
        const double median = method.seconds[kTurns / 2];
        const double stage = median / method.stages / nodes;
        if (unit == 0) unit = stage;
        std::printf(
            "%4d x %-4d %-14s dt %.4f s  %.3e s/s  error %.2e  %6.3f ns/node/stage  "
            "%6.2f FTCS  guarded %.0f\n",
            rows, columns, method.name, method.dt, median / kSeconds, method.error, 1e9 * stage,
            stage / unit, method.guarded);
    }
}

}  // namespace

int main() {
    measure(32, 48);
    measure(128, 192);
    measure(512, 768);
}
