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

Session::Session(const Params& params, int threads, std::size_t cache_bytes)
    : Session(make_world(params, threads), threads, cache_bytes) {}

Session::Session(World world, int threads, std::size_t cache_bytes)
    : world_(std::move(world)), threads_(threads), base_(world_.params()), cache_(cache_bytes) {
    world_.set_script(base_, {});
    end_ = world_.state().tick;
    arrive(std::make_shared<const WorldState>(world_.snapshot()));
}

std::shared_ptr<const std::vector<TimedParams>> Session::no_edits() {
    return std::make_shared<const std::vector<TimedParams>>();
}

void Session::arrive(SharedState state) {
    arrived_ = std::move(state);
    cache_.put(arrived_);
    world_.take_scripted();
    ++revision_;
}

void Session::play() {
    if (!stopped_) playing_ = true;
}

bool Session::tick() {
    const std::uint64_t next = tick_number() + 1;
    if (SharedState kept = next <= end_ ? cache_.at(next) : nullptr) {
        world_.restore(*kept);
        arrive(std::move(kept));
        return true;
    }
    const StepReport report = world_.step(observer_);
    substeps_ = report.counters.substeps;
    if (report.ok()) {
        end_ = std::max(end_, next);
        arrive(std::make_shared<const WorldState>(world_.snapshot()));
        return true;
    }
    ++revision_;
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
    base_ = params;
    script_ = no_edits();
    world_.set_script(base_, {});
    cache_.clear();
    end_ = 0;
    due_ = dropped_ = 0;
    substeps_ = 0;
    stopped_ = false;
    message_.clear();
    arrive(std::make_shared<const WorldState>(world_.snapshot()));
}

void Session::restart() {
    rebuild(Params(world_.params()));
}

void Session::follow_script(std::vector<TimedParams> script) {
    world_.set_script(base_, script);
    script_ = std::make_shared<const std::vector<TimedParams>>(std::move(script));
    world_.take_scripted();
    ++revision_;
}

void Session::go_to(std::uint64_t tick) {
    tick = std::min(tick, end_);
    due_ = 0;
    stopped_ = false;
    message_.clear();
    SharedState kept = cache_.at_or_before(tick);
    world_.restore(*kept);
    arrive(std::move(kept));
    while (tick_number() < tick) {
        if (!this->tick()) return;
    }
}

int Session::advance(double seconds, const std::function<bool()>& may_continue) {
    if (!playing_) return 0;
    due_ += speed_ * seconds;
    const double dt = world_.tick_duration();
    int ticks = 0;
    bool time_left = true;
    while (due_ >= dt && ticks < kMostTicks && time_left) {
        due_ -= dt;
        if (loop_ && end_ > 0 && tick_number() >= end_) {
            const double due = due_;
            go_to(0);
            due_ = due;
        } else if (!tick()) {
            return ticks;
        }
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
    return std::max(0.0, (world_.tick_duration() - due_) / speed_);
}

EditOutcome Session::start_anew(const Params& params) {
    try {
        rebuild(params);
        return EditOutcome::Restarted;
    } catch (const std::exception& e) {
        message_ = e.what();
        return EditOutcome::Refused;
    }
}

// Makes what is in force from this tick on the script's entry for it. An edit takes the place of
// an earlier one at the same tick, as if that had not been: what is written down is then exactly
// what has been done.
bool Session::edit_here(const Params& params) {
    const std::uint64_t now = tick_number();
    std::vector<TimedParams> script = *script_;
    std::erase_if(script, [now](const TimedParams& entry) { return entry.tick >= now; });
    world_.restore(*arrived_);
    if (compare(params, world_.params()) != ParamChange::None) script.push_back({now, params});
    try {
        world_.set_script(base_, script);
        world_.take_scripted();
    } catch (const std::exception& e) {
        message_ = e.what();
        world_.set_script(base_, *script_);
        world_.restore(*arrived_);
        world_.take_scripted();
        return false;
    }
    script_ = std::make_shared<const std::vector<TimedParams>>(std::move(script));
    cache_.drop_after(now);
    end_ = now;
    return true;
}

EditOutcome Session::apply(const Params& params) {
    const ParamChange change = compare(params, world_.params());
    if (change == ParamChange::None) {
        if (!stopped_) message_.clear();  // of an edit that has been taken back
        return EditOutcome::Unchanged;
    }
    if (std::string error = range_error(params); !error.empty()) {
        message_ = std::move(error);
        return EditOutcome::Refused;
    }
    if (change == ParamChange::Rebuild) return start_anew(params);
    if (tick_number() == 0) {  // what burns is then what a preset of these values says
        return start_anew(params) == EditOutcome::Restarted ? EditOutcome::Live
                                                            : EditOutcome::Refused;
    }
    const bool done = edit_here(params);
    ++revision_;
    if (!done) return EditOutcome::Refused;
    stopped_ = false;
    message_.clear();
    return EditOutcome::Live;
}

bool Session::retry_with_smaller_step() {
    if (!stopped_) return false;
    Params params = world_.params();
    params.numerics.safety *= 0.5;
    if (apply(params) != EditOutcome::Live) return false;
    play();
    return true;
}

TimelineSpan Session::timeline() const {
    TimelineSpan span;
    span.cursor = tick_number();
    span.end = end_;
    span.tick_duration = world_.tick_duration();
    span.interval = cache_.interval();
    span.bytes = cache_.bytes();
    for (const TimedParams& entry : *script_)
        span.edits.push_back(entry.tick);
    return span;
}

std::shared_ptr<Snapshot> Session::snapshot(bool with_springs) const {
    auto shot = std::make_shared<Snapshot>();
    const auto here = [&](const TimedParams& entry) { return entry.tick == tick_number(); };
    const bool edited = std::ranges::any_of(*script_, here);
    shot->state = edited ? std::make_shared<const WorldState>(world_.snapshot()) : arrived_;
    shot->view = world_.view(*shot->state);
    for (std::size_t s = 0; with_springs && s < shot->state->sheets.size(); ++s)
        shot->springs.push_back(world_.springs(s));
    shot->revision = revision_;
    shot->params = world_.params();
    shot->base = base_;
    shot->script = script_;
    shot->stats = stats();
    shot->timeline = timeline();
    shot->playing = playing_;
    shot->stopped = stopped_;
    shot->message = message_;
    if (!playing_) shot->hash = world_.hash();
    return shot;
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
    stats.kinetic = state.energy.kinetic;
    stats.heat = state.heat.stored;
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
