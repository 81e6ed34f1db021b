#include "sim/tick.h"

#include <algorithm>

#include "sim/burning.h"
#include "sim/check.h"
#include "sim/fire.h"
#include "sim/fracture.h"
#include "sim/lighter.h"
#include "sim/movement.h"
#include "sim/shrinkage.h"
#include "sim/sleep.h"

namespace ember {
namespace {

double end_time(const Tick& t) {
    return t.state.time + t.dt;
}

double energy_change(const Tick& t) {
    return record_energy(measure_energy(t.params, t.state, t.pool, t.work), t.state.energy);
}

void run_fire(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Fire);
    t.work.active.clear();
    t.work.lattices.clear();
    for (const SheetWorkspace& w : t.work.sheets) {
        t.work.active.push_back(t.params.numerics.skip ? &w.active : nullptr);
        t.work.lattices.push_back(&w.lattice);
    }
    advance_fire(t.params, t.work.lighters, static_cast<std::uint64_t>(t.params.numerics.seed),
                 t.state.time, t.dt, t.state.sheets, t.work.lattices, t.work.active, t.state.fire,
                 counters);
}

void run_coupling(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Coupling);
    const std::size_t sheets = t.state.fire.size() > 0 ? t.state.sheets.size() : 0;
    if (t.work.tiles.size() < sheets) t.work.tiles.resize(sheets);
    for (std::size_t s = 0; s < sheets; ++s) {
        if (t.work.tiles[s].topology_version == t.state.sheets[s].topology_version) continue;
        group_nodes(t.work.sheets[s].lattice, t.state.sheets[s], t.work.tiles[s]);
    }
    couple_fire(t.params, end_time(t), t.dt, t.state.sheets, t.work.tiles, t.state.fire, t.pool,
                t.work.coupling, t.work.fire, counters);
}

bool run_motion(const Tick& t, StepReport& report) {
    if (!move_sheets(t, report)) return false;
    (void)energy_change(t);  // accounted for by the work done meanwhile
    return true;
}

void run_rest(const Tick& t) {
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s)
        count_quiet_ticks(t.work.sheets[s].lattice, t.params.numerics, t.state.sheets[s]);
}

// Section 4.2, eqs. 2 and 3. Faster burning is the same heat in less time.
void run_heat(const Tick& t, StepReport& report) {
    const StageScope scope(t.observer, Stage::Heat);
    const double dt = t.dt * t.params.burning.burn_speed;
    const double ambient = t.params.heat.ambient;
    t.state.heat.stored = 0;
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetState& sheet = t.state.sheets[s];
        SheetWorkspace& w = t.work.sheets[s];
        const HeatSolverKind used =
            conduct_heat(sheet, t.params, dt, t.refine, w.heat, report.counters);
        if (used != HeatSolverKind::Auto) report.heat_solver = used;
        exchange_heat(sheet, t.params, t.work.fire[s].heating, dt, t.state.heat, report.counters);
        cool_held(sheet, t.params.paper, ambient, t.state.heat);
        t.state.heat.stored += stored_heat(sheet, t.params.paper, ambient);
    }
}

void run_burning(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Burning);
    // nothing is warmer than its surroundings and nothing burns: nothing can change
    const bool cold = t.state.heat.stored == 0.0 &&
                      t.params.burning.ignition > t.params.heat.ambient && t.params.numerics.skip;
    double gone = 0;
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetState& sheet = t.state.sheets[s];
        SheetWorkspace& w = t.work.sheets[s];
        w.burnt_out.clear();
        if (cold && w.active.burning.empty()) continue;
        const std::int64_t changes = counters.nodes_ignited + counters.nodes_burnt_out;
        const double burnt =
            update_phases(t.params, end_time(t), t.dt * t.params.burning.burn_speed,
                          t.work.active[s], sheet, w.burnt_out, counters);
        gone += burnt;
        if (counters.nodes_ignited + counters.nodes_burnt_out != changes)
            find_active(w.lattice, sheet, w.active);
        if (burnt > 0) {
            weaken_springs(w.lattice, sheet, t.params.springs.follows_mass, t.pool, w.network);
            if (w.plate.stiff()) weaken_plate(w.lattice, sheet, t.params, w.plate);
        }
    }
    t.state.totals.burnt_mass += gone;
    t.state.totals.ignitions += counters.nodes_ignited;
    t.state.totals.burnouts += counters.nodes_burnt_out;
    if (gone > 0) t.state.energy.change_mass += energy_change(t);
}

void run_shrinkage(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Shrinkage);
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        shrink_burning_springs(t.work.sheets[s].lattice, t.params, t.dt, t.work.sheets[s].active,
                               t.state.sheets[s], counters);
    }
    if (counters.springs_shrunk > 0) t.state.energy.change_rest_length += energy_change(t);
}

// Faces that differ bend the sheet, and charring keeps it bent.
void run_curl(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Shrinkage);
    bool changed = false;
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetWorkspace& w = t.work.sheets[s];
        changed |=
            advance_curl(w.lattice, w.plate, t.params, t.work.fire[s],
                         t.dt * t.params.burning.burn_speed, t.state.sheets[s], w.curl, counters);
    }
    if (changed) t.state.energy.change_curvature += energy_change(t);
}

void run_fracture(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Fracture);
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetWorkspace& w = t.work.sheets[s];
        break_ash({w.lattice, t.params, w.network, w.active, s, end_time(t), w.burnt_out},
                  t.state.sheets[s], counters);
    }
    t.state.totals.cuts += counters.cuts;
    if (counters.cuts == 0) return;
    for (SheetState& sheet : t.state.sheets)
        wake(sheet);
    refresh_derived(t.params, t.state, t.pool, t.work);
    t.state.energy.change_topology += energy_change(t);
}

}  // namespace

StepReport run_tick(const Tick& t) {
    StepReport report;
    report.time = t.state.time;
    StepCounters& counters = report.counters;

    run_fire(t, counters);         // Sec. 4.2: particles are born, rise and die
    run_coupling(t, counters);     // Sec. 4.2: and give nodes heat and a push
    if (!run_motion(t, report)) {  // Sec. 4.1: the lattice moves, and touches
        report.status = StepStatus::Diverged;
        report.stage = Stage::Springs;
        return report;
    }
    run_rest(t);                 // what rests falls asleep
    run_heat(t, report);         // Sec. 4.2, eqs. 2 and 3: heat spreads
    run_burning(t, counters);    // Sec. 4.2: unburnt, burning, burnt out
    run_shrinkage(t, counters);  // Sec. 4.3, eq. 4: burning fibres shrink
    run_curl(t, counters);       // faces that differ bend the sheet
    run_fracture(t, counters);   // Sec. 4.4: burnt fibres break

    ++t.state.tick;
    t.state.time = static_cast<double>(t.state.tick) / t.params.numerics.tick_rate;
    if (t.params.numerics.check) {
        const StageScope scope(t.observer, Stage::Check);
        check_state(t.state, report);
    }
    return report;
}

void refresh_derived(const Params& params, const WorldState& state, ThreadPool& pool,
                     Workspace& work) {
    work.lighters = lighters_of(params);
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        const SheetState& sheet = state.sheets[s];
        SheetWorkspace& w = work.sheets[s];
        if (w.network.topology_version != sheet.topology_version) {
            rebuild_network(w.lattice, sheet, w.network);
            rebuild_heat(w.lattice, sheet, w.network, params.paper, w.heat);
        }
        weaken_springs(w.lattice, sheet, params.springs.follows_mass, pool, w.network);
        find_active(w.lattice, sheet, w.active);
        if (!w.plate.stiff()) continue;
        if (w.plate.topology_version != sheet.topology_version)
            rebuild_plate(w.lattice, sheet, w.plate);
        weaken_plate(w.lattice, sheet, params, w.plate);
    }
}

MechanicalEnergy measure_energy(const Params& params, const WorldState& state, ThreadPool& pool,
                                Workspace& work) {
    MechanicalEnergy energy;
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        SheetWorkspace& w = work.sheets[s];
        energy +=
            sheet_energy(w.lattice, params.world, state.sheets[s], w.network, pool, w.row_energy);
        if (w.plate.stiff()) energy.elastic += plate_energy(w.lattice, w.plate, state.sheets[s]);
    }
    return energy;
}

double record_energy(const MechanicalEnergy& now, EnergyLedger& ledger) {
    const double before = ledger.kinetic + ledger.elastic + ledger.gravitational;
    ledger.kinetic = now.kinetic;
    ledger.elastic = now.elastic;
    ledger.gravitational = now.gravitational;
    return now.total() - before;
}

}  // namespace ember
