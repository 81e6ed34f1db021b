// What the forces on a run of nodes make of them: accelerations, or a step of a leapfrog scheme.
// All of these are one pass over the run, as the arrays of a large sheet have to come from far.
#pragma once

#include <array>
#include <cstddef>

#include "sim/mechanics.h"

namespace ember {

/// Consecutive nodes.
struct NodeRun {
    std::ptrdiff_t first, count;
};

/// The three components of an array whose components are `pitch` apart, from a node on.
template <class Pointer>
std::array<Pointer, 3> components(Pointer array, std::ptrdiff_t pitch, std::ptrdiff_t first) {
    return {array + first, array + pitch + first, array + 2 * pitch + first};
}

/// Accelerations a [m/s²] of nodes on which springs exert f [N]; the components of both begin at
/// the run's first node.
void divide_by_mass(const NodeLoads& loads, NodeRun run, const std::array<const double*, 3>& f,
                    const std::array<double*, 3>& a);

/// The same in the air, with the drag F = -c [(v·n) n + τ (v - (v·n) n)] at the velocities v [m/s],
/// which likewise begin at the run's first node. `power` [W] is what the drag takes of each node.
void divide_in_air(const NodeLoads& loads, NodeRun run, const std::array<const double*, 3>& f,
                   const std::array<const double*, 3>& v, const std::array<double*, 3>& a,
                   double* power);

/// The step w <- w + kick a, x <- x + drift w, u <- w + lead a of a run in arrays whose components
/// are n apart; `power` [W] is what the springs' friction [N] takes of each node, at w + mean a.
void kick_and_drift(const Leap& step, NodeRun run, std::ptrdiff_t n,
                    const std::array<const double*, 3>& a,
                    const std::array<const double*, 3>& friction, double* power);

/// divide_in_air() at the velocities u, and kick_and_drift(), in one pass; `dragged` and
/// `rubbed` [W] are what drag and the springs' friction take of each node.
void leap_in_air(const NodeLoads& loads, const Leap& step, NodeRun run, std::ptrdiff_t n,
                 const std::array<const double*, 3>& f,
                 const std::array<const double*, 3>& friction, double* dragged, double* rubbed);

}  // namespace ember
