// Rows of the table: heat, burning and fire.
#pragma once

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr ParamInfo kBurningRows[] = {
    // ---- heat --------------------------------------------------------------------------------
    real<&Params::heat, &HeatParams::ambient>("heat.ambient", "", unit::celsius, {-200, 500},
                                              {0, 40}, Linear, Rebuild,
                                              {"Temperature of air and cold paper.", "Our choice"}),
    real<&Params::heat, &HeatParams::flame_limit>(
        "heat.flame_limit", "T_max", unit::celsius, {0, 5000}, {900, 1300}, Linear, Live,
        {"No fire heats paper above this.", "Our choice"}),
    real<&Params::heat, &HeatParams::convection>(
        "heat.convection", "h", unit::watt_per_square_metre_kelvin, {0, 1e5}, {0, 60}, Linear, Live,
        {"Heat lost to the air by each face; 0 is the paper. It acts on the sheet's true "
         "heat capacity c G.",
         "Our choice"}),
    real<&Params::heat, &HeatParams::emissivity>(
        "heat.emissivity", "eps", unit::one, {0, 1}, {0, 0.9}, Linear, Live,
        {"Heat radiated by each face, as a share of a black body; 0 is the paper.", "Our choice"}),
    // ---- burning -----------------------------------------------------------------------------
    real<&Params::burning, &BurningParams::ignition>(
        "burning.ignition", "", unit::celsius, {-200, 5000}, {300, 768}, Linear, Live,
        {"A node starts to burn at this temperature.", "Sec. 4.2: 1.5 x 512"}),
    real<&Params::burning, &BurningParams::burn_rate>(
        "burning.burn_rate", "", unit::gram_per_second_square_metre, {0, 1e5}, {14, 520},
        Logarithmic, Live,
        {"Mass lost by burning paper. The paper's 0.02 g/s per node is 520 here, and dies out.",
         "Sec. 4.2"}),
    real<&Params::burning, &BurningParams::residual_mass>(
        "burning.residual_mass", "", unit::percent, {1, 99}, {8, 30}, Linear, Live,
        {"What is left of a node when it has burnt out.", "Sec. 4.2"}),
    real<&Params::burning, &BurningParams::heat_release>(
        "burning.heat_release", "s", unit::kelvin_per_second, {0, 1e7}, {0, 4e4}, Linear, Live,
        {"Heating of a burning node by its own flame.", "Sec. 4.2, eq. 2"}),
    real<&Params::burning, &BurningParams::burn_speed>(
        "burning.burn_speed", "", unit::one, {0.01, 100}, {0.1, 10}, Logarithmic, Live,
        {"Scales conduction, sources, losses and burn rate together: a faster front of the same "
         "width.",
         "Our choice"}),
    // ---- fire --------------------------------------------------------------------------------
    real<&Params::fire, &FireParams::temperature>(
        "fire.temperature", "", unit::celsius, {-200, 5000}, {512, 512}, Linear, Live,
        {"Temperature of a fire particle at birth.", "Sec. 4.2"}),
    real<&Params::fire, &FireParams::emission>(
        "fire.emission", "", unit::per_second_square_metre, {0, 1e8}, {1e5, 3e6}, Logarithmic, Live,
        {"Fire particles born per second and square metre of burning paper.", "Our choice"}),
    toggle<&Params::fire, &FireParams::area_emission>(
        "fire.area_emission", Live,
        {"Particles start anywhere on burning paper and not only at its nodes: the front then has "
         "the same speed on every lattice that resolves fire.kernel_radius.",
         "Our choice"}),
    real<&Params::fire, &FireParams::heating>(
        "fire.heating", "A_0", unit::kelvin_per_second, {0, 1e7}, {300, 3e4}, Logarithmic, Live,
        {"Heating by one particle at its centre, for 80 g/m^2 and c_s 2e-4.", "Our choice"}),
    real<&Params::fire, &FireParams::heating_time>(
        "fire.heating_time", "", unit::second, {1e-3, 1e6}, {0.02, 1}, Logarithmic, Live,
        {"Particles heat best while they are fresh: what they give falls to 37 % in this time, "
         "though the flame is seen for longer. Longer makes fire climb faster than it creeps.",
         "Our choice"}),
    real<&Params::fire, &FireParams::heating_limit>(
        "fire.heating_limit", "S_max", unit::kelvin_per_second, {1, 1e8}, {8e3, 4e4}, Logarithmic,
        Live,
        {"However many particles surround a node, they heat it no faster than this.",
         "Our choice"}),
    real<&Params::fire, &FireParams::kernel_radius>("fire.kernel_radius", "r_k", unit::millimetre,
                                                    {0.5, 1000}, {6, 22}, Linear, Live,
                                                    {"How far a particle reaches.", "Our choice"}),
    real<&Params::fire, &FireParams::absorption>(
        "fire.absorption", "", unit::hertz, {0, 1e5}, {0, 100}, Linear, Live,
        {"How fast a particle close to paper loses what it gives. 0: it heats every sheet of a "
         "stack alike.",
         "Our choice"}),
    real<&Params::fire, &FireParams::node_strength>(
        "fire.node_strength", "", unit::one, {0, 100}, {0, 2}, Linear, Live,
        {"How much particles of burning nodes heat, relative to fire.heating.", "Our choice"}),
    real<&Params::fire, &FireParams::grammage_exponent>(
        "fire.grammage_exponent", "", unit::one, {0, 2}, {0, 1}, Linear, Live,
        {"Heating falls with grammage to this power; 1 is eq. 2 by the letter.", "Our choice"}),
    real<&Params::fire, &FireParams::stability_exponent>(
        "fire.stability_exponent", "", unit::one, {0, 2}, {0, 1}, Linear, Live,
        {"Heating falls with c_s to this power; 1 is eq. 2 by the letter.", "Our choice"}),
    real<&Params::fire, &FireParams::cooling_time>(
        "fire.cooling_time", "", unit::second, {0.001, 1000}, {0.2, 1}, Linear, Live,
        {"A particle's excess temperature falls to 37 % in this time.", "Our choice"}),
    real<&Params::fire, &FireParams::life_min>("fire.life_min", "", unit::second, {0.01, 60},
                                               {0.2, 1}, Linear, Live,
                                               {"Shortest life of a particle.", "Our choice"}),
    real<&Params::fire, &FireParams::life_max>("fire.life_max", "", unit::second, {0.01, 60},
                                               {0.3, 2}, Linear, Live,
                                               {"Longest life of a particle.", "Our choice"}),
    real<&Params::fire, &FireParams::rise_speed>(
        "fire.rise_speed", "", unit::metre_per_second, {0, 50}, {0, 1}, Linear, Live,
        {"Upward speed at birth of particles from burning nodes.", "Our choice"}),
    real<&Params::fire, &FireParams::standoff>(
        "fire.standoff", "", unit::millimetre,
        {0, 1000}, {0, 10}, Linear, Live,
        {"How far above the burning paper that feeds it a flame stands: gas burns only once it "
         "has mixed with air. Higher lets fire creep down and sideways less than up.",
         "Our choice"}),
    real<&Params::fire, &FireParams::lateral_speed>(
        "fire.lateral_speed", "", unit::metre_per_second, {0, 50}, {0, 0.3}, Linear, Live,
        {"Spread of the velocity at birth, standard deviation per axis.", "Our choice"}),
    real<&Params::fire, &FireParams::buoyancy>(
        "fire.buoyancy", "", unit::metre_per_second_squared, {0, 1000}, {0, 10}, Linear, Live,
        {"Upward acceleration of a particle as hot as at birth.", "Our choice"}),
    real<&Params::fire, &FireParams::drag>(
        "fire.drag", "", unit::hertz, {0, 1000}, {0, 5}, Linear, Live,
        {"How fast a particle is slowed by the air.", "Our choice"}),
    real<&Params::fire, &FireParams::force>(
        "fire.force", "f_ext", unit::kilogram_per_second_square_metre, {0, 100}, {0, 0.1}, Linear,
        Live, {"Push of passing particles on the sheet.", "Sec. 4.2"}),
    real<&Params::fire, &FireParams::force_limit>(
        "fire.force_limit", "", unit::metre_per_second_squared, {0, 1000}, {0, 5}, Linear, Live,
        {"The push never accelerates a node by more than this.", "Our choice"}),
};

}  // namespace ember::param_rows
