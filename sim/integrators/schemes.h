// The schemes behind integrate(). Each advances scratch.present by control.dt and adds what it
// lost to `work`.
#pragma once

#include "sim/integrator.h"
#include "sim/integrators/tableau.h"

namespace ember {

/// v' = v + h a(x, v), x' = x + h v'. Conserves E + h/2 Σ m v·a of linear forces.
void semi_implicit_euler(const Mechanics& mechanics, const StepControl& control,
                         IntegratorScratch& scratch, TickWork& work, StepCounters& counters);
/// Conserves E - h²/8 Σ m a² of linear forces.
void velocity_verlet(const Mechanics& mechanics, const StepControl& control,
                     IntegratorScratch& scratch, TickWork& work, StepCounters& counters);
/// With error control where the tableau has an estimate and the tolerance is finite.
void runge_kutta(const Tableau& tableau, const Mechanics& mechanics, const StepControl& control,
                 IntegratorScratch& scratch, TickWork& work, StepCounters& counters);
/// Accelerations of the present and the past that adams_bashforth_moulton() keeps.
constexpr std::size_t kAdamsPast = 6;
void adams_bashforth_moulton(const Mechanics& mechanics, const StepControl& control,
                             IntegratorScratch& scratch, TickWork& work, StepCounters& counters);
void rosenbrock(const Mechanics& mechanics, const StepControl& control, IntegratorScratch& scratch,
                TickWork& work, StepCounters& counters);

/// One step of length h [s] from scratch.present into scratch.stage. accelerations[0] must hold
/// those at the start, whose lost power is `first`. Returns the energy lost [J].
TickWork runge_kutta_step(const Tableau& tableau, const Mechanics& mechanics, double h,
                          const LostPower& first, LostPower& last, IntegratorScratch& scratch,
                          StepCounters& counters);

}  // namespace ember
