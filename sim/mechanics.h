// The equation of motion of one sheet during a tick, M x'' = F(x, x'), as a right-hand side that
// any integrator can call.
#pragma once

#include <span>

#include "sim/lattice.h"
#include "sim/parallel.h"
#include "sim/spring_forces.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

/// What acts on a sheet's nodes during a tick besides springs; all arrays N.
struct NodeLoads {
    std::vector<double> inverse_mass;  ///< [1/kg]; 0 for held nodes
    Vector3Array force;                ///< [N] constant during the tick: gravity and fire
    Vector3Array fire;                 ///< [N] the part of it that is fire's
    std::vector<double> drag;          ///< [kg/s] across the sheet
    Vector3Array normal;               ///< [1] unit normal at the start of the tick
    double drag_tangential = 0;        ///< [1] share of drag along the sheet
    bool has_drag = false;
};

/// Mechanical power that leaves the sheet [W].
struct LostPower {
    double damping = 0, drag = 0;
};

/// Rows begin .. end-1 of the lattice.
struct RowSpan {
    Index begin, end;
};

/// Everything that the forces on a sheet depend on besides its motion. Holds references only.
struct Mechanics {
    const Lattice& lattice;
    const SheetState& sheet;  ///< topology and masses; its motion is not read
    const SpringNetwork& network;
    const NodeLoads& loads;
    SpringForces& forces;  ///< scratch; SpringForces::prepare() has been called for this tick
    ThreadPool& pool;
    SpringKernel kernel;
    std::span<const RowSpan> rows;  ///< that are moved, ascending; nodes of others have a = 0 and
                                    ///< must be at rest. Copies are moved if any row is.

    [[nodiscard]] std::size_t node_count() const { return sheet.mass.size(); }
};

/// Accelerations a [m/s²], 3N, of a sheet whose nodes are at x [m] and move with v [m/s], both 3N:
/// all x components, then all y, then all z; kMotionPadding more elements must be readable after
/// x and after v. Held nodes have acceleration 0. Returns the power lost. Same bits for any number
/// of threads.
LostPower accelerate(const Mechanics& mechanics, const double* x, const double* v, double* a);

/// The drift x' = x + h w of a leapfrog step.
struct Drift {
    const double* w;  ///< [m/s], 3N + kMotionPadding: velocity that led to x
    double h;         ///< [s] step; the next drift will be w + h a
};

/// The same accelerations. The losses are the work that damping and drag do in the discrete
/// motion: of the damping, on the drift since the last call; of the drag, on the halves of the
/// drifts before and after. The damping of a tick's first call means nothing.
LostPower accelerate(const Mechanics& mechanics, const double* x, const double* v, double* a,
                     const Drift& drift);

}  // namespace ember
