#include "sim/sleep.h"

#include <algorithm>

namespace ember {
namespace {

constexpr Index kReach = 2;  // rows that a spring spans at most

Index row_of(const Lattice& lattice, const SheetState& sheet, std::size_t node) {
    return lattice.row_of(sheet.site[node]);
}

bool pushed(const NodeLoads& loads, std::size_t n) {
    const auto pushes = [n](const Vector3Array& force) {
        return n < force.size() && (force.x[n] != 0 || force.y[n] != 0 || force.z[n] != 0);
    };
    return pushes(loads.fire) || pushes(loads.wind);
}

bool rested(const SheetState& sheet, Index row, const NumericsParams& numerics) {
    return sheet.quiet_ticks[static_cast<std::size_t>(row)] >= kQuietTime * numerics.tick_rate;
}

// Rows that have rested, as have those that their springs reach.
void find_sleepers(const Lattice& lattice, const NumericsParams& numerics, const SheetState& sheet,
                   std::vector<std::uint8_t>& asleep) {
    asleep.assign(static_cast<std::size_t>(lattice.row_count), 1);
    bool any_awake = false;
    for (Index row = 0; row < lattice.row_count; ++row) {
        if (rested(sheet, row, numerics)) continue;
        any_awake = true;
        for (Index offset = -kReach; offset <= kReach; ++offset) {
            const Index near = lattice.row_at(row, offset);
            if (near != kNone) asleep[static_cast<std::size_t>(near)] = 0;
        }
    }
    if (!any_awake) return;
    // copies are moved all together, so rows that have some keep awake with them
    for (auto n = static_cast<std::size_t>(lattice.site_count()); n < sheet.mass.size(); ++n)
        asleep[static_cast<std::size_t>(row_of(lattice, sheet, n))] = 0;
}

double stop(const Lattice& lattice, const std::vector<std::uint8_t>& asleep, SheetState& sheet) {
    double kinetic = 0.0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (asleep[static_cast<std::size_t>(row_of(lattice, sheet, n))] == 0) continue;
        const Vector3 v = sheet.velocity.at(n);
        if (v.isZero(0.0)) continue;
        kinetic += 0.5 * sheet.mass[n] * v.squaredNorm();
        sheet.velocity.set(n, Vector3::Zero());
    }
    return kinetic;
}

}  // namespace

double find_awake_rows(const Lattice& lattice, const NumericsParams& numerics,
                       const NodeLoads& loads, SheetState& sheet, AwakeRows& awake,
                       StepCounters& counters) {
    std::vector<RowSpan>& spans = awake.spans;
    spans.assign(1, {0, lattice.row_count});
    if (!(numerics.sleep_speed > 0)) return 0.0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (sheet.phase[n] != Phase::Burning && !pushed(loads, n)) continue;
        sheet.quiet_ticks[static_cast<std::size_t>(row_of(lattice, sheet, n))] = 0;
    }
    find_sleepers(lattice, numerics, sheet, awake.asleep);
    spans.clear();
    for (Index row = 0; row < lattice.row_count; ++row) {
        if (awake.asleep[static_cast<std::size_t>(row)] != 0) {
            ++counters.rows_asleep;
        } else if (!spans.empty() && spans.back().end == row) {
            ++spans.back().end;
        } else {
            spans.push_back({row, row + 1});
        }
    }
    return counters.rows_asleep > 0 ? stop(lattice, awake.asleep, sheet) : 0.0;
}

void count_quiet_ticks(const Lattice& lattice, const NumericsParams& numerics, SheetState& sheet) {
    if (!(numerics.sleep_speed > 0)) return;
    for (Index& ticks : sheet.quiet_ticks)
        ++ticks;
    const double limit = numerics.sleep_speed * numerics.sleep_speed;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (sheet.velocity.at(n).squaredNorm() < limit) continue;
        sheet.quiet_ticks[static_cast<std::size_t>(row_of(lattice, sheet, n))] = 0;
    }
}

void wake(SheetState& sheet) {
    std::fill(sheet.quiet_ticks.begin(), sheet.quiet_ticks.end(), 0);
}

}  // namespace ember
