// Heat in the sheet (section 4.2, eqs. 2 and 3).
//
//     c_s rho c ∂u/∂t = D (∂²u/∂x² + ∂²u/∂z²) + s
//
// Conduction runs along the structural springs between the first copies of sites, by one of the
// solvers of heat_solver.h; sources and losses are then applied exactly over the tick:
//
//     du/dt = S (1 - u/ΔT) - β u,   u = T - ambient,   ΔT = flame limit - ambient
//
// Both parts keep every temperature between the coldest and the hottest of what surrounds it,
// ambient and the flame limit, for any time step. Cold nodes that nothing heats are not visited,
// unless numerics.skip is off; the results are the same bits.
#pragma once

#include "sim/heat_choice.h"
#include "sim/heat_solver.h"
#include "sim/params.h"
#include "sim/step_stats.h"

namespace ember {

/// Makes the operator and the scratch fit the sheet's present topology.
void rebuild_heat(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                  const PaperParams& paper, HeatScratch& scratch);

/// Conducts heat for `dt` [s] by numerics.heat_solver, in as many steps as that asks for times
/// `refine`. Conserves Σ capacity · temperature. Returns the solver used; Auto when all was cold.
HeatSolverKind conduct_heat(SheetState& sheet, const Params& params, double dt, int refine,
                            HeatScratch& scratch, StepCounters& counters);

/// Applies sources and losses for `dt` [s] and adds them to the ledger.
/// source [K/s], N: heating by particles (fire_coupling.h); burning nodes add their own.
void exchange_heat(SheetState& sheet, const Params& params, const std::vector<double>& source,
                   double dt, HeatLedger& ledger, StepCounters& counters);

/// Puts held nodes back to ambient and adds what they took to the ledger.
void cool_held(SheetState& sheet, const PaperParams& paper, double ambient, HeatLedger& ledger);

/// Heat above ambient [J].
[[nodiscard]] double stored_heat(const SheetState& sheet, const PaperParams& paper, double ambient);

}  // namespace ember
