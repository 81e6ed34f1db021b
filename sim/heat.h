// Heat in the sheet (section 4.2, eqs. 2 and 3).
//
//     c_s rho c ∂u/∂t = D (∂²u/∂x² + ∂²u/∂z²) + s
//
// Conduction runs forward in time, centred in space, along the structural springs between the
// first copies of sites; sources and losses are then applied exactly over the tick:
//
//     du/dt = S (1 - u/ΔT) - β u,   u = T - ambient,   ΔT = flame limit - ambient
//
// Both parts keep every temperature between the coldest and the hottest of what surrounds it,
// ambient and the flame limit, for any time step.
#pragma once

#include "sim/params.h"
#include "sim/spring_network.h"
#include "sim/step_stats.h"

namespace ember {

/// Scratch of one sheet.
struct HeatScratch {
    std::vector<double> main, cross;  ///< [W/K] conductance of each edge slot, S
    std::vector<double> next;         ///< [K], S
    double most_per_capacity = 0;     ///< [1/s] largest Σ conductance / capacity of any site
    std::uint64_t topology_version = ~0ull;
    Index first_row = 0, last_row = -1;  ///< rows that hold anything warmer than ambient
};

/// Rebuilds the conductances after cuts. The limit of the explicit step is
/// dt <= 1 / most_per_capacity; below it every step is an average, so nothing overshoots.
void rebuild_conduction(const Lattice& lattice, const SheetState& sheet,
                        const SpringNetwork& network, const PaperParams& paper,
                        HeatScratch& scratch);

/// Heat capacity of a node [J/K] = c_s · c · unburnt mass: eq. 2 per node.
[[nodiscard]] inline double heat_capacity(const PaperParams& paper, double initial_mass) {
    return paper.c_s * paper.specific_heat * initial_mass;
}

/// Conducts heat for `dt` [s], in as many explicit sub-steps as the limit asks for times
/// `refine`. Conserves Σ capacity · temperature. Rows at ambient are not visited.
void conduct_heat(const Lattice& lattice, SheetState& sheet, const PaperParams& paper,
                  double ambient, double dt, int refine, HeatScratch& scratch,
                  StepCounters& counters);

/// Applies sources and losses for `dt` [s] and adds them to the ledger.
/// source [K/s], N: heating by particles (coupling.h); burning nodes add their own.
void exchange_heat(SheetState& sheet, const Params& params, const std::vector<double>& source,
                   double dt, HeatLedger& ledger, StepCounters& counters);

/// Puts held nodes back to ambient and adds what they took to the ledger.
void cool_held(SheetState& sheet, const PaperParams& paper, double ambient, HeatLedger& ledger);

/// Heat above ambient [J].
[[nodiscard]] double stored_heat(const SheetState& sheet, const PaperParams& paper, double ambient);

}  // namespace ember
