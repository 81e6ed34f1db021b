// Moves a sheet's nodes through one tick by the integrator that is asked for.
#pragma once

#include <limits>

#include "sim/integrators/linear_system.h"
#include "sim/integrators/motion.h"
#include "sim/mechanics.h"
#include "sim/step_stats.h"

namespace ember {

/// How to divide a tick.
struct StepControl {
    IntegratorKind integrator = IntegratorKind::Rk4;
    double dt = 0;  ///< [s] the tick
    /// Equal sub-steps; for integrators with error control the least number, and where they begin.
    std::int64_t substeps = 1;
    double tolerance = std::numeric_limits<double>::infinity();   ///< [m] RMS error of a sub-step
    double first_step = std::numeric_limits<double>::infinity();  ///< [s] to try, with a tolerance
    bool pauses = false;   ///< the next call goes on from here, with other loads only
    bool resumes = false;  ///< the last call paused
};

/// Where mechanical energy went in a tick [J].
struct TickWork {
    double fire = 0, wind = 0, contact = 0, damping = 0, drag = 0;
    /// What the symplectic integrators hold in the energy that they conserve instead of the true
    /// one: exact for linear forces, bounded, see schemes.h.
    double scheme = 0;
    std::int64_t substeps = 0;      ///< taken
    const char* failure = nullptr;  ///< why the integrator gave up, or null
};

/// Scratch of one sheet's integration.
struct IntegratorScratch {
    Motion start, present, stage;
    std::vector<double> ahead;                       ///< [m/s] of leapfrog schemes, as Motion::v
    std::vector<double> kept;                        ///< [N] while they pause, see Leap
    std::vector<std::vector<double>> accelerations;  ///< [m/s²] of stages or past steps, 3N each
    std::vector<std::vector<double>> velocities;     ///< [m/s] stages of rosenbrock, 3N + padding
    std::vector<double> error, zeros;                ///< 3N
    LinearSystem system;                             ///< of rosenbrock
};

/// Whether the integrator finds its own sub-steps from StepControl::tolerance.
[[nodiscard]] constexpr bool has_error_control(IntegratorKind integrator) {
    return integrator == IntegratorKind::Dopri5 || integrator == IntegratorKind::Rkf78 ||
           integrator == IntegratorKind::Rosenbrock;
}

/// Advances the positions and velocities of `sheet`, which is `mechanics.sheet`, by control.dt.
/// Sub-steps must be no longer than stable_step() (stability.h) for explicit integrators.
///
///   integrator              order  right-hand sides per sub-step
///   semi_implicit_euler     1      1       and one more at the end, unless the call pauses or
///   velocity_verlet         2      1       resumes: then the one at its end serves both
///   rk4                     4      4
///   dopri5                  5(4)   6   Dormand and Prince 1980, error control
///   rkf78                   8(7)   13  Fehlberg 1968, error control
///   adams_bashforth_moulton 7      2   PECE, started by Butcher's method of order 6 in every
///                                      tick, since fire, cuts and masses change between ticks
///   rosenbrock              2      3   ROS2 (Verwer et al. 1999), linearly implicit, L-stable,
///                                      error control of order 2(1)
///
/// Returns the work done, by the same quadrature as the motion.
TickWork integrate(const Mechanics& mechanics, SheetState& sheet, const StepControl& control,
                   IntegratorScratch& scratch, StepCounters& counters);

}  // namespace ember
