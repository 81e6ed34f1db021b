// Rows of the table: how it is computed.
#pragma once

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr std::string_view kIntegrators[] = {
    "auto",  "semi_implicit_euler",     "velocity_verlet", "rk4", "dopri5",
    "rkf78", "adams_bashforth_moulton", "rosenbrock"};
inline constexpr std::string_view kHeatSolvers[] = {"auto", "ftcs", "rkl2", "adi"};
inline constexpr std::string_view kArithmetics[] = {"exact", "fast"};

inline constexpr ParamInfo kNumericsRows[] = {
    // ---- numerics ----------------------------------------------------------------------------
    integer<&Params::numerics, &NumericsParams::seed>(
        "numerics.seed", "", {0, 9007199254740991.0}, {0, 1000}, Rebuild,
        {"Same preset, same seed: same burn, bit for bit.", "Our choice"}),
    real<&Params::numerics, &NumericsParams::tick_rate>(
        "numerics.tick_rate", "", unit::hertz, {1, 100000}, {30, 240}, Logarithmic, Rebuild,
        {"Simulation ticks per simulated second.", "Our choice"}),
    choice<&Params::numerics, &NumericsParams::integrator>(
        "numerics.integrator", kIntegrators, Live,
        {"How the lattice is moved. auto takes the cheapest that is accurate enough.",
         "Sec. 4.1 (rk4); our choice"}),
    real<&Params::numerics, &NumericsParams::tolerance>(
        "numerics.tolerance", "", unit::metre, {1e-13, 0.01}, {1e-10, 1e-4}, Logarithmic, Live,
        {"Error that one sub-step of dopri5, rkf78 or rosenbrock may make.", "Our choice"}),
    real<&Params::numerics, &NumericsParams::safety>(
        "numerics.safety", "", unit::one, {0.01, 10}, {0.5, 0.9}, Linear, Live,
        {"Share of the computed stability bound that a sub-step may use.", "Our choice"}),
    integer<&Params::numerics, &NumericsParams::substeps_min>(
        "numerics.substeps_min", "", {1, 100000}, {1, 100}, Live,
        {"At least this many sub-steps per tick.", "Our choice"}),
    choice<&Params::numerics, &NumericsParams::heat_solver>(
        "numerics.heat_solver", kHeatSolvers, Live,
        {"How heat is conducted. auto takes the cheapest for the lattice and the step.",
         "Sec. 4.2 (ftcs); our choice"}),
    choice<&Params::numerics, &NumericsParams::arithmetic>(
        "numerics.arithmetic", kArithmetics, Live,
        {"exact: the same bits on every processor. fast: fused operations and estimated square "
         "roots where the processor has them; other bits, other state hash.",
         "Our choice"}),
    toggle<&Params::numerics, &NumericsParams::skip>(
        "numerics.skip", Live,
        {"Leave out work that changes nothing. Off does all of it, to the same bits.",
         "Our choice"}),
    real<&Params::numerics, &NumericsParams::sleep_speed>(
        "numerics.sleep_speed", "", unit::metre_per_second, {0, 1}, {0, 1e-3}, Linear, Live,
        {"Paper that has rested more slowly than this is not moved until something reaches it. "
         "0 moves everything always.",
         "Our choice"}),
    toggle<&Params::numerics, &NumericsParams::check>(
        "numerics.check", Live,
        {"Watch every tick for non-finite numbers and energy from nowhere; roll back and retry.",
         "Our choice"}),
};

}  // namespace ember::param_rows
