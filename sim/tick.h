// One tick: section 4 of the paper on one page.
#pragma once

#include "sim/parallel.h"
#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/workspace.h"
#include "sim/world_state.h"

namespace ember {

/// Everything a tick works on.
struct Tick {
    const Params& params;
    WorldState& state;
    Workspace& work;
    ThreadPool& pool;
    StageObserver* observer;  ///< may be null
    double dt;                ///< [s]
    int refine;               ///< sub-steps are this many times smaller than they need be
};

/// Advances the state by one tick and checks the result (finiteness, energy and heat ledgers).
/// When the report says Diverged the state is of no use; World::step() then rolls back.
[[nodiscard]] StepReport run_tick(const Tick& tick);

/// Brings networks and conductances up to date with topology and masses, e.g. after a restore.
void refresh_derived(const Params& params, const WorldState& state, ThreadPool& pool,
                     Workspace& work);

/// Energy of all sheets [J].
[[nodiscard]] MechanicalEnergy measure_energy(const Params& params, const WorldState& state,
                                              ThreadPool& pool, Workspace& work);

/// Stores `now` in the ledger and returns the change since the last time [J].
double record_energy(const MechanicalEnergy& now, EnergyLedger& ledger);

}  // namespace ember
