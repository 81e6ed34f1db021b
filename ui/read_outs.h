// What follows from the parameters and the burn, for the panel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/params.h"
#include "sim/world_view.h"

namespace ember {

/// Speed of the burning front now [m/s]: the median of 1/|∇t| over sites that caught fire in the
/// last `window` [s], t the time at which they did, its gradient by differences between the sites
/// around them on the unburnt lattice. Empty with fewer than 8 such sites.
[[nodiscard]] std::optional<double> front_speed(const WorldView& world, double window = 1.5);

/// The range in which the front of real paper of this grammage runs horizontally [m/s]: 0.35 to
/// 0.56 g/(m s) over the grammage (Thomas and Law 1965).
struct SpeedRange {
    double slow, fast;
};
[[nodiscard]] SpeedRange real_front_speed(double grammage);

/// One line: a name and a value with its unit.
struct ReadOut {
    std::string name, value;
};
/// Caliper, mass of a node, sub-step, front, and how long a node and the sheet burn.
/// `substeps`: of the last tick, 0 where none has been.
[[nodiscard]] std::vector<ReadOut> read_outs(const Params& params, const WorldView& world,
                                             std::int64_t substeps);

}  // namespace ember
