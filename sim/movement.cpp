#include "sim/movement.h"

#include <algorithm>
#include <cmath>

#include "sim/contact.h"
#include "sim/hand.h"
#include "sim/loads.h"
#include "sim/sleep.h"
#include "sim/stability.h"

namespace ember {
namespace {

constexpr double kMostSubsteps = 1e6;

// How to divide the tick for one sheet; substeps is 0 when no bounded number is stable.
StepControl plan_steps(const Tick& t, const SheetState& sheet, SheetWorkspace& w) {
    const NumericsParams& n = t.params.numerics;
    const FastestMotion fastest =
        find_fastest_motion(w.lattice, sheet, w.network, w.plate.stiff() ? &w.plate : nullptr,
                            w.loads, t.pool, w.stability);
    StepControl control{.integrator = choose_integrator(n, fastest, t.dt), .dt = t.dt};
    const double step = n.safety * stable_step(control.integrator, fastest);
    double needed = std::max(1.0 * n.substeps_min, std::ceil(t.dt / step));
    if (has_error_control(control.integrator)) {
        needed = n.substeps_min;
        control.tolerance = n.tolerance / t.refine;
        control.first_step = step;
    }
    needed *= t.refine;
    // a contact force that opposes a vibration and lags behind it feeds it: with forces constant
    // during h, ωh may not exceed 2.33 = the root of 1 + cos x = sin x / x. Implicit methods damp
    // it
    constexpr double kMostPhase = 2.1;
    const bool implicit = control.integrator == IntegratorKind::Rosenbrock;
    const double intervals = implicit ? 1.0 : std::ceil(t.dt * fastest.omega / kMostPhase);
    w.contact_intervals = static_cast<std::int64_t>(std::min(intervals, kMostSubsteps));
    control.substeps = needed <= kMostSubsteps ? static_cast<std::int64_t>(needed) : 0;
    return control;
}

// What pulls at the sheets, what of them is awake, and how the tick is divided. Returns false when
// a sheet cannot be moved.
bool prepare_motion(const Tick& t, StepReport& report) {
    const StageScope scope(t.observer, Stage::Springs);
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetState& sheet = t.state.sheets[s];
        SheetWorkspace& w = t.work.sheets[s];
        report.sheet = static_cast<Index>(s);
        gather_loads(t.params, sheet, t.work.fire[s], w.loads, t.state.time + 0.5 * t.dt);
        if (t.params.hand.on && t.params.hand.sheet == static_cast<std::int64_t>(s) + 1)
            pull_by_hand(t.params.hand, w.lattice, sheet, w.loads);
        t.state.energy.loss_sleep +=
            find_awake_rows(w.lattice, t.params.numerics, w.loads, sheet, w.awake, report.counters);
        if (w.awake.spans.empty()) continue;
        w.control = plan_steps(t, sheet, w);
        report.integrator = w.control.integrator;
        if (w.control.substeps == 0) {
            report.reason = "a stable sub-step would be shorter than a millionth of the tick";
            return false;
        }
        w.forces.prepare(w.lattice, sheet, w.network, t.pool);
    }
    return true;
}

// Sub-steps of all sheets that touch something, if they are moved by so many intervals; by nodes.
double steps_of_nodes(const Tick& t, std::int64_t intervals) {
    double sum = 0.0;
    for (const SheetWorkspace& w : t.work.sheets) {
        if (w.loads.contact.size() == 0 || w.awake.spans.empty()) continue;
        const std::int64_t each = (w.control.substeps + intervals - 1) / intervals;
        sum += static_cast<double>(each * intervals) *
               static_cast<double>(w.loads.inverse_mass.size());
    }
    return sum;
}

// As few intervals as contact allows, or more of them where whole sub-steps then fit in better.
// Pressing at the ground takes as long as a step of 3 nodes, at paper of 12 (measured).
std::int64_t cheapest_intervals(const Tick& t, std::int64_t least) {
    constexpr double kAtGround = 3.0, kAtPaper = 12.0;
    const NearThings& near = t.work.contact.near;
    const double to_press = kAtGround * static_cast<double>(near.on_ground.size()) +
                            kAtPaper * static_cast<double>(near.pairs.size() + near.edges.size());
    const auto cost = [&](std::int64_t intervals) {
        return to_press * static_cast<double>(intervals) + steps_of_nodes(t, intervals);
    };
    std::int64_t cheapest = least;
    for (std::int64_t n = least + 1; n < 2 * least; ++n) {
        if (cost(n) < cost(cheapest)) cheapest = n;
    }
    return cheapest;
}

// Returns the number of intervals with constant contact forces.
std::int64_t find_contact(const Tick& t, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Contact);
    t.work.contact.sheets.clear();
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetWorkspace& w = t.work.sheets[s];
        const bool may_sleep = t.params.numerics.sleep_speed > 0;
        t.work.contact.sheets.push_back({&w.lattice, w.gap, &t.state.sheets[s], &w.loads,
                                         may_sleep ? w.awake.asleep.data() : nullptr});
    }
    std::int64_t intervals = find_contacts(t.params, t.dt, t.work.contact, counters);
    if (t.work.contact.near.empty()) return intervals;
    for (const SheetWorkspace& w : t.work.sheets) {
        if (w.loads.contact.size() != 0) intervals = std::max(intervals, w.contact_intervals);
    }
    return cheapest_intervals(t, intervals);
}

void press(const Tick& t, std::int64_t intervals, StepCounters& counters) {
    const StageScope scope(t.observer, Stage::Contact);
    press_contacts(t.params, t.dt / static_cast<double>(intervals), t.work.contact, counters);
}

// Moves the sheets through interval i of n; those that touch nothing, through the tick at once.
bool advance(const Tick& t, std::int64_t i, std::int64_t n, StepReport& report) {
    const StageScope scope(t.observer, Stage::Springs);
    for (std::size_t s = 0; s < t.state.sheets.size(); ++s) {
        SheetState& sheet = t.state.sheets[s];
        SheetWorkspace& w = t.work.sheets[s];
        report.sheet = static_cast<Index>(s);
        const std::int64_t parts = w.loads.contact.size() == 0 ? 1 : n;
        if (w.awake.spans.empty() || i >= parts) continue;
        StepControl control = w.control;
        control.dt /= static_cast<double>(parts);
        control.substeps = (control.substeps + parts - 1) / parts;
        control.resumes = i > 0;
        control.pauses = i + 1 < parts;
        const TickWork work =
            integrate({w.lattice, sheet, w.network, w.loads, w.forces, w.old_rows, t.pool,
                       spring_kernel(t.params.numerics.arithmetic), w.awake.spans,
                       w.plate.stiff() ? &w.plate : nullptr, &w.plate_forces},
                      sheet, control, w.integration, report.counters);
        if (work.failure != nullptr) {
            report.reason = work.failure;
            return false;
        }
        t.state.energy.work_fire += work.fire;
        t.state.energy.work_wind += work.wind;
        t.state.energy.work_contact += work.contact;
        t.state.energy.change_scheme += work.scheme;
        t.state.energy.loss_damping += work.damping;
        t.state.energy.loss_drag += work.drag;
    }
    return true;
}

}  // namespace

bool move_sheets(const Tick& t, StepReport& report) {
    if (!prepare_motion(t, report)) return false;
    const std::int64_t intervals = find_contact(t, report.counters);
    for (std::int64_t i = 0; i < intervals; ++i) {
        if (!t.work.contact.near.empty()) press(t, intervals, report.counters);
        if (!advance(t, i, intervals, report)) return false;
    }
    report.sheet = kNone;
    return true;
}

}  // namespace ember
