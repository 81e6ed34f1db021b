// The equation of motion of one sheet during a tick, M x'' = F(x, x'), as a right-hand side that
// any integrator can call.
#pragma once

#include <span>

#include "sim/lattice.h"
#include "sim/old_rows.h"
#include "sim/parallel.h"
#include "sim/plate_forces.h"
#include "sim/spring_forces.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

/// What acts on a sheet's nodes during a tick besides springs; all arrays N.
struct NodeLoads {
    std::vector<double> inverse_mass;  ///< [1/kg]; 0 for held nodes
    Vector3Array force;        ///< [N] constant while it is moved: gravity, fire, wind, contact
    Vector3Array fire;         ///< [N] the part of it that is fire's and a hand's
    Vector3Array wind;         ///< [N] the part of it that is the wind's; empty: none
    Vector3Array contact;      ///< [N] the part of it that is contact's, see contact.h; empty: none
    std::vector<double> drag;  ///< [kg/s] across the sheet
    Vector3Array normal;       ///< [1] unit normal at the start of the tick
    double drag_tangential = 0;  ///< [1] share of drag along the sheet
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
    OldRows& old_rows;     ///< scratch of leap()
    ThreadPool& pool;
    SpringKernel kernel;
    std::span<const RowSpan> rows;  ///< that are moved, ascending; nodes of others have a = 0 and
                                    ///< must be at rest. Copies are moved if any row is.
    const Plate* plate = nullptr;   ///< null without rigidity
    PlateForces* plate_forces = nullptr;  ///< scratch

    [[nodiscard]] std::size_t node_count() const { return sheet.mass.size(); }
};

/// Accelerations a [m/s²], 3N, of a sheet whose nodes are at x [m] and move with v [m/s], both 3N:
/// all x components, then all y, then all z; kMotionPadding more elements must be readable after
/// x and after v. Held nodes have acceleration 0. Returns the power lost. Same bits for any number
/// of threads.
LostPower accelerate(const Mechanics& mechanics, const double* x, const double* v, double* a);

/// Where a step takes the forces of springs and plate from. They need not be evaluated twice at
/// the same place when only other loads change there.
enum class ForceSource { Motion, MotionAndKeep, Kept };

/// One step of a leapfrog scheme, in which velocities w that carry nodes from place to place
/// (drifts) alternate with accelerations (kicks):
///
///     w <- w + kick·a(x, u),   x <- x + drift·w,   u <- w + lead·a
///
/// All arrays are 3N + kMotionPadding long, as those of accelerate().
struct Leap {
    double *x, *w, *u;                     ///< [m], [m/s] drift that led to x, [m/s] guess at v
    double kick = 0, drift = 0, lead = 0;  ///< [s]
    double mean = 0;                       ///< [s] w + mean·a is half-way to the next drift
    ForceSource source = ForceSource::Motion;
    double* kept = nullptr;  ///< [N] x, y, z of forces and of friction, 6N; for the other sources
};

/// Call before the first of some leaps, and whenever x or u have been changed between leaps.
void prepare_leaps(const Mechanics& mechanics, const double* x, const double* u);

/// Makes one step in one pass over the arrays. The power is that of friction at w + mean·a, which
/// is exactly what the discrete motion loses.
LostPower leap(const Mechanics& mechanics, const Leap& step);

}  // namespace ember
