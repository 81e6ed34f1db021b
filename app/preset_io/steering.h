// Edits in mid-burn: [[events]] of a preset, and what a person has done in the window.
#pragma once

#include <span>
#include <vector>

#include "app/preset_io/preset_io.h"
#include "sim/world.h"

namespace ember {

/// The events of `info` as a script from `base` on, ascending by tick; several of one tick are one
/// entry. What is wrong with them is added to `problems`, where it stands: unknown keys, values
/// out of range, and parameters that cannot change in mid-burn.
[[nodiscard]] std::vector<TimedParams> script_of(const Params& base, const PresetInfo& info,
                                                 std::vector<Diagnostic>& problems);

/// The opposite: events that lead from `base` through the entries of `script`.
[[nodiscard]] std::vector<PresetEvent> events_of(const Params& base,
                                                 std::span<const TimedParams> script);

/// "key=value" for everything in which `after` differs from `before`, elements of lists included.
/// A list that has become longer or shorter says its length first: "lighters=2".
[[nodiscard]] std::vector<std::string> assignments_between(const Params& before,
                                                           const Params& after);

}  // namespace ember
