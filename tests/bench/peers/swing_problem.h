// The swing problem in emberleaf's own terms, and its translation for peers.
#pragma once

#include "problem.h"
#include "tests/sim/swing.h"

namespace ember::peers {

inline constexpr double kDuration = 0.5;  ///< [s]

/// A swing with N = rows × columns nodes at rest, in the given arithmetic.
[[nodiscard]] test::Rig make_swing(int rows, int columns, Arithmetic arithmetic);

/// accelerate() of sim/mechanics.h as a right-hand side of first order.
[[nodiscard]] std::unique_ptr<RightHandSide> ember_right_hand_side(test::Rig& rig);

[[nodiscard]] PlainProblem translate(const test::Rig& rig);

/// The rig's present motion as a state for right-hand sides.
[[nodiscard]] std::vector<double> state_of(const test::Rig& rig);

/// Root mean square distance of the nodes of two states [m].
[[nodiscard]] double distance(const std::vector<double>& p, const std::vector<double>& q);

}  // namespace ember::peers
