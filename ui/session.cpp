#include "ui/session.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace ember {

Session::Session(const Params& params, int threads)
    : world_(make_world(params, threads)), threads_(threads) {}

void Session::play() {
    if (!stopped_) playing_ = true;
}

bool Session::tick() {
    const StepReport report = world_.step();
    substeps_ = report.counters.substeps;
    if (report.ok()) return true;
    char text[400];
    std::snprintf(text, sizeof text, "stopped at %.3f s in stage %s (sheet %d, node %d): %s",
                  report.time,
                  std::string(kStageNames[static_cast<std::size_t>(report.stage)]).c_str(),
                  report.sheet, report.node, report.reason.c_str());
    message_ = text;
    playing_ = false;
    stopped_ = true;
    return false;
}

void Session::step_once() {
    playing_ = false;
    if (!stopped_) tick();
}

void Session::restart() {
    world_ = make_world(world_.params(), threads_);
    due_ = dropped_ = 0;
    stopped_ = false;
    message_.clear();
}

void Session::advance(double seconds) {
    if (!playing_) return;
    due_ += seconds;
    const double dt = world_.tick_duration();
    for (int i = 0; i < kMostTicks && due_ >= dt; ++i) {
        due_ -= dt;
        if (!tick()) return;
    }
    if (due_ >= dt) {
        dropped_ += due_;
        due_ = 0;
    }
}

void Session::apply(const Params& params) {
    if (world_.apply(params)) {
        message_.clear();
        return;
    }
    try {
        world_ = make_world(params, threads_);
        due_ = dropped_ = 0;
        stopped_ = false;
        message_.clear();
    } catch (const std::invalid_argument& e) {
        message_ = e.what();
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
    stats.dropped = dropped_;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
            stats.unburnt += sheet.phase[n] == Phase::Unburnt ? 1 : 0;
            stats.burning += sheet.phase[n] == Phase::Burning ? 1 : 0;
            stats.burnt_out += sheet.phase[n] == Phase::BurntOut ? 1 : 0;
            stats.hottest = std::max(stats.hottest, sheet.temperature[n]);
        }
    }
    return stats;
}

}  // namespace ember
