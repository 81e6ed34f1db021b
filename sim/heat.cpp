#include "sim/heat.h"

namespace ember {

void rebuild_heat(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                  const PaperParams& paper, HeatScratch& scratch) {
    rebuild_conduction(lattice, sheet, network, paper, scratch.conduction);
    resize_tiles(scratch.conduction, scratch.tiles);
}

HeatSolverKind conduct_heat(SheetState& sheet, const Params& params, double dt, int refine,
                            HeatScratch& scratch, StepCounters& counters) {
    const NumericsParams& numerics = params.numerics;
    const double ambient = params.heat.ambient;
    const Conduction& op = scratch.conduction;
    if (!find_warm_tiles(op, sheet.temperature, ambient, false, scratch.tiles) && numerics.skip) {
        return HeatSolverKind::Auto;
    }
    const HeatChoice choice = choose_heat_solver(op, numerics.heat_solver, dt);
    const auto steps = static_cast<std::int64_t>(choice.steps) * refine;
    const double h = dt / static_cast<double>(steps);
    const HeatStep step = {sheet.temperature, ambient, numerics.skip, scratch, counters};
    if (choice.solver == HeatSolverKind::Ftcs) {
        ftcs(step, h, steps);
        return choice.solver;
    }
    for (std::int64_t i = 0; i < steps; ++i) {
        if (choice.solver == HeatSolverKind::Rkl2) {
            rkl2(step, h);
        } else {
            adi(step, h);
        }
    }
    return choice.solver;
}

}  // namespace ember
