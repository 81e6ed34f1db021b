// What is published of a session: values and copies, nothing that belongs to the simulation.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/step_stats.h"
#include "sim/world.h"
#include "ui/state_cache.h"

namespace ember {

/// Figures of one state.
struct SessionStats {
    double time = 0;  ///< [s]
    std::uint64_t tick = 0;
    std::int64_t unburnt = 0, burning = 0, burnt_out = 0;  ///< lattice sites
    std::size_t particles = 0;
    std::int64_t cuts = 0, substeps = 0, retries = 0;
    double hottest = 0;       ///< [K]
    double caliper = 0;       ///< [m]
    double mass = 0;          ///< [kg] of all sheets
    double kinetic = 0;       ///< [J] of motion
    double heat = 0;          ///< [J] stored above ambient
    double dropped = 0;       ///< [s] simulated time that was due and not simulated
    double tick_seconds = 0;  ///< [s] that the last tick took
    std::array<double, kStageCount> stage_seconds{};  ///< [s] of it, by stage
};

/// Where a session is in the burn that it has simulated so far.
struct TimelineSpan {
    std::uint64_t cursor = 0, end = 0;  ///< ticks
    double tick_duration = 1;           ///< [s]
    std::uint64_t interval = 1;         ///< from one kept state to the next
    std::size_t bytes = 0;              ///< of kept states
    std::vector<std::uint64_t> edits;   ///< ticks at which something was changed
};

/// One state of a session. The view points into `state`, which lives as long as this does.
struct Snapshot {
    std::uint64_t revision = 0;  ///< changes whenever anything here may have
    std::uint64_t commands = 0;  ///< that have been done before it
    Params params, base;         ///< in force, and at t = 0
    /// The edits that lead from one to the other; never null.
    std::shared_ptr<const std::vector<TimedParams>> script;
    SharedState state;
    WorldView view;
    std::vector<std::vector<SpringSegment>> springs;  ///< per sheet, if they were asked for
    SessionStats stats;
    TimelineSpan timeline;
    bool playing = false;
    bool stopped = false;    ///< by numbers that went wrong
    std::string message;     ///< why it has stopped or refused something; empty when all is well
    std::uint64_t hash = 0;  ///< of the state; 0 while playing
    std::shared_ptr<const Snapshot> beside;  ///< of the session that is compared with this one
};

}  // namespace ember
