#include "ui/session.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <sstream>

#include "app/preset_io/parameter_value.h"
#include "sim/param_table.h"

namespace ember {
namespace {

// A value may stand a rounding error outside its range, because units convert.
bool in_range(const ParamInfo& row, double shown) {
    const auto slack = [](double bound) {
        return std::isfinite(bound) ? 1e-9 * std::abs(bound) : 0;
    };
    const ParamRange range{row.hard.min - slack(row.hard.min), row.hard.max + slack(row.hard.max)};
    return range.contains(shown);
}

// The first value that its row does not allow, as a sentence; empty when there is none.
std::string range_error(const Params& params) {
    for (const ParamInfo& row : sim_param_rows()) {
        if (!row.is_number()) continue;  // nothing in the window changes them
        if (in_range(row, row.shown(&params))) continue;
        return std::string(row.key) + ": expected " + expected(row) + ", got " +
               value_text(row, &params);
    }
    return {};
}

std::string failure_text(const StepReport& report) {
    std::ostringstream text;
    text << "Stopped at " << report.time << " s in " << cause_text(report)
         << ". Change a parameter or restart.";
    return text.str();
}

}  // namespace

Session::Session(const Params& params, int threads)
    : Session(make_world(params, threads), threads) {}

Session::Session(World world, int threads) : world_(std::move(world)), threads_(threads) {}

void Session::play() {
    if (!stopped_) playing_ = true;
}

bool Session::tick() {
    const StepReport report = world_.step();
    ++revision_;
    substeps_ = report.counters.substeps;
    if (report.ok()) return true;
    message_ = failure_text(report);
    playing_ = false;
    stopped_ = true;
    return false;
}

void Session::step_once() {
    playing_ = false;
    if (!stopped_) tick();
}

void Session::rebuild(const Params& params) {
    world_ = make_world(params, threads_);
    ++revision_;
    due_ = dropped_ = 0;
    substeps_ = 0;
    stopped_ = false;
    message_.clear();
}

void Session::restart() {
    rebuild(Params(world_.params()));
}

int Session::advance(double seconds, const std::function<bool()>& may_continue) {
    if (!playing_) return 0;
    due_ += seconds;
    const double dt = world_.tick_duration();
    int ticks = 0;
    bool time_left = true;
    while (due_ >= dt && ticks < kMostTicks && time_left) {
        due_ -= dt;
        if (!tick()) return ticks;
        ++ticks;
        time_left = !may_continue || may_continue();
    }
    if (due_ >= dt) {
        // keep the fraction of a tick, so that ticks come at an even pace when there is time again
        const double whole = std::floor(due_ / dt) * dt;
        dropped_ += whole;
        due_ -= whole;
    }
    return ticks;
}

double Session::until_next_tick() const {
    return std::max(0.0, world_.tick_duration() - due_);
}

EditOutcome Session::apply(const Params& params) {
    if (compare(params, world_.params()) == ParamChange::None) {
        if (!stopped_) message_.clear();  // of an edit that has been taken back
        return EditOutcome::Unchanged;
    }
    if (std::string error = range_error(params); !error.empty()) {
        message_ = std::move(error);
        return EditOutcome::Refused;
    }
    if (world_.apply(params)) {
        ++revision_;
        stopped_ = false;
        message_.clear();
        return EditOutcome::Live;
    }
    try {
        rebuild(params);
        return EditOutcome::Restarted;
    } catch (const std::exception& e) {
        message_ = e.what();
        return EditOutcome::Refused;
    }
}

SessionStats Session::stats() const {
    const WorldState& state = world_.state();
    SessionStats stats;
    stats.time = state.time;
    stats.tick = state.tick;
    stats.particles = state.fire.size();
    stats.cuts = state.totals.cuts;
    stats.retries = state.totals.retries;
    stats.substeps = substeps_;
    stats.caliper = caliper(params().paper);
    stats.dropped = dropped_;
    stats.lighter_lit = world_.view().lighters.front().lit;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
            if (sheet.initial_mass[n] == 0) continue;  // no paper
            stats.unburnt += sheet.phase[n] == Phase::Unburnt ? 1 : 0;
            stats.burning += sheet.phase[n] == Phase::Burning ? 1 : 0;
            stats.burnt_out += sheet.phase[n] == Phase::BurntOut ? 1 : 0;
        }
        for (const double t : sheet.temperature)
            stats.hottest = std::max(stats.hottest, t);
        for (const double m : sheet.mass)
            stats.mass += m;
    }
    return stats;
}

}  // namespace ember
