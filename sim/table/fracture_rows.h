// Rows of the table: cracks.
#pragma once

#include <limits>

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr std::string_view kFractureRules[] = {"paper", "stress"};

inline constexpr ParamInfo kFractureRows[] = {
    // ---- fracture ----------------------------------------------------------------------------
    choice<&Params::fracture, &FractureParams::rule>(
        "fracture.rule", kFractureRules, Live,
        {"paper: bending springs break, and cuts are horizontal or vertical. stress: cracks of any "
         "direction follow stress, grain and the burnt boundary.",
         "Sec. 4.4 (paper), sec. 6 (stress)"}),
    real<&Params::fracture, &FractureParams::threshold>(
        "fracture.threshold", "", unit::percent, {0, kInfinity}, {0.6, 4}, Logarithmic, Live,
        {"A burnt bending spring breaks when stretched by this; by the rule stress, ash where its "
         "stress would stretch a whole sheet so. Lower falls to smaller flakes; inf never cracks.",
         "Sec. 4.4"}),
    toggle<&Params::fracture, &FractureParams::middle_burnt>(
        "fracture.middle_burnt", Live,
        {"The node between must be burnt out too. Off is the paper.", "Our choice"}),
    real<&Params::fracture, &FractureParams::relief_radius>(
        "fracture.relief_radius", "", unit::millimetre, {0, 10000}, {0, 30}, Linear, Live,
        {"A cut relieves the stress around it: no second cut within this distance ...",
         "Our choice"}),
    real<&Params::fracture, &FractureParams::relief_time>(
        "fracture.relief_time", "", unit::second, {0, 100}, {0, 1}, Linear, Live,
        {"... for this long. 0 cuts everything over-stretched at once, as the paper does.",
         "Our choice"}),
    toggle<&Params::fracture, &FractureParams::release_hinges>(
        "fracture.release_hinges", Live,
        {"Pieces that hang together by a single node let go.", "Our choice"}),
    real<&Params::fracture, &FractureParams::ash_strength>(
        "fracture.ash_strength", "", unit::percent, {1, 100}, {5, 100}, Linear, Live,
        {"Ash grows weak with age, down to this share of the threshold ...", "Our choice"}),
    real<&Params::fracture, &FractureParams::ash_time>(
        "fracture.ash_time", "", unit::second, {0.001, 1000}, {0.5, 10}, Logarithmic, Live,
        {"... in this time after it burnt out, for 80 g/m^2; in proportion to grammage.",
         "Our choice"}),
    real<&Params::fracture, &FractureParams::strength_noise>(
        "fracture.strength_noise", "", unit::percent, {0, 90}, {0, 40}, Linear, Live,
        {"Formation: how much the strength of ash varies from place to place ...", "Our choice"}),
    real<&Params::fracture, &FractureParams::noise_length>(
        "fracture.noise_length", "", unit::millimetre, {1, 1000}, {5, 40}, Linear, Live,
        {"... and over what distance.", "Our choice"}),
    real<&Params::fracture, &FractureParams::grain>(
        "fracture.grain", "", unit::one, {0.05, 20}, {0.4, 1}, Linear, Live,
        {"Strength across the fibres, relative to along them. Lower turns cracks along the main "
         "direction. Only for the rule stress.",
         "Our choice"}),
    real<&Params::fracture, &FractureParams::boundary>(
        "fracture.boundary", "", unit::one, {0, 0.95}, {0, 0.5}, Linear, Live,
        {"How much weaker ash is across the line that the fire front has left in it: more turns "
         "cracks along the burnt boundary. Only for the rule stress.",
         "Our choice"}),
    real<&Params::fracture, &FractureParams::crack_speed>(
        "fracture.crack_speed", "", unit::metre_per_second, {0.001, 1000}, {0.05, 1}, Logarithmic,
        Live, {"How fast a crack runs on. Only for the rule stress.", "Our choice"}),
};

}  // namespace ember::param_rows
