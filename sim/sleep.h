// Paper at rest is not moved: rows of the lattice that have rested fall asleep.
//
// A row is quiet while all its nodes move more slowly than numerics.sleep_speed and nothing reaches
// it: no push of the fire, no burning node. Rows that have been quiet for kQuietTime, and whose
// neighbours up to two rows away have been so too, sleep: they stand still and their springs are
// not evaluated. The row beside them is moved and so feels what comes; when it is no longer quiet
// they wake. A cut or a changed parameter wakes everything. A sleeping node was slower than
// sleep_speed when it stopped, so what it misses is at most sleep_speed × the time asleep; with
// sleep_speed = 0 nothing ever sleeps and no bit changes.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/mechanics.h"
#include "sim/params.h"
#include "sim/step_stats.h"

namespace ember {

inline constexpr double kQuietTime = 0.25;  // [s]

/// The rows that are moved in a tick.
struct AwakeRows {
    std::vector<RowSpan> spans;
    std::vector<std::uint8_t> asleep;  ///< scratch: one flag per row
};

/// Finds the spans of rows that are awake, forgets the rest of rows that something has reached,
/// and stops those that fall asleep. Returns their kinetic energy [J], which is lost.
/// Rows with copies of nodes sleep only when the whole sheet does.
double find_awake_rows(const Lattice& lattice, const NumericsParams& numerics,
                       const NodeLoads& loads, SheetState& sheet, AwakeRows& awake,
                       StepCounters& counters);

/// Counts the ticks that each row has been quiet, after the sheet has moved.
void count_quiet_ticks(const Lattice& lattice, const NumericsParams& numerics, SheetState& sheet);

/// Wakes everything.
void wake(SheetState& sheet);

}  // namespace ember
