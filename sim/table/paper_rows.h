// Rows of the table: what the paper is, how it shrinks, and the lighter; people meet them first.
#pragma once

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr ParamColumn kKeyframe[] = {{"time", unit::second, {0, 3600}, true},
                                            {"x", unit::millimetre, kFar},
                                            {"y", unit::millimetre, kFar},
                                            {"z", unit::millimetre, kFar}};
inline constexpr std::string_view kShrinkRules[] = {"both_burning", "half"};

inline constexpr ParamInfo kPaperRows[] = {
    // ---- paper -------------------------------------------------------------------------------
    real<&Params::paper, &PaperParams::grammage>(
        "paper.grammage", "G", unit::gram_per_square_metre, {5, 5000}, {18, 400}, Logarithmic, Live,
        {"Mass of one square metre. Heavier paper burns slower and crumples less.",
         "Sec. 3, table 2"}),
    real<&Params::paper, &PaperParams::density>(
        "paper.density", "rho", unit::kilogram_per_cubic_metre, {50, 5000}, {250, 1500}, Linear,
        Live,
        {"Mass of one cubic metre; caliper is grammage / density. Denser paper conducts "
         "heat more slowly.",
         "Sec. 3, table 2"}),
    real<&Params::paper, &PaperParams::c_s>(
        "paper.c_s", "c_s", unit::one, {1e-6, 1}, {1e-4, 1}, Logarithmic, Live,
        {"Dimensional stability: the quality of the paper. Higher burns slower and shrinks less.",
         "Sec. 4.1, eqs. 2 and 4"}),
    real<&Params::paper, &PaperParams::specific_heat>(
        "paper.specific_heat", "c", unit::joule_per_kilogram_kelvin, {1, 1e5}, {1000, 2000}, Linear,
        Live, {"Specific heat capacity. Higher heats up more slowly.", "Table 1"}),
    real<&Params::paper, &PaperParams::conductivity>(
        "paper.conductivity", "D", unit::watt_per_metre_kelvin, {0, 10}, {0.02, 0.2}, Linear, Live,
        {"Thermal conductivity. Higher spreads heat faster along the fibres.", "Table 1"}),
    // ---- shrinkage ---------------------------------------------------------------------------
    real<&Params::shrinkage, &ShrinkageParams::factor>(
        "shrinkage.factor", "factor", unit::one, {0, 1e-6}, {1e-12, 1e-8}, Logarithmic, Live,
        {"Scales the shrinking of burning fibres. Higher crumples more; 0 not at all.",
         "Sec. 4.3, eq. 4"}),
    real<&Params::shrinkage, &ShrinkageParams::reference_step>(
        "shrinkage.reference_step", "dt_ref", unit::millisecond, {0.01, 1000}, {1, 20}, Logarithmic,
        Live,
        {"Time that one application of eq. 4 stands for; the paper does not say.", "Our choice"}),
    real<&Params::shrinkage, &ShrinkageParams::floor>(
        "shrinkage.floor", "", unit::one, {0.01, 1}, {0.5, 0.9}, Linear, Live,
        {"No fibre shrinks below this share of its initial length.", "Our choice"}),
    choice<&Params::shrinkage, &ShrinkageParams::rule>(
        "shrinkage.rule", kShrinkRules, Live,
        {"both_burning: eq. 4 where both ends burn, and by half for bending springs with one. "
         "half: every spring shrinks in proportion to its burning ends.",
         "Sec. 4.3"}),
    toggle<&Params::shrinkage, &ShrinkageParams::literal_stiffness>(
        "shrinkage.literal_stiffness", Live,
        {"Use each kind's own stiffness as k_s in eq. 4, so that bending springs shrink less.",
         "Sec. 4.3"}),
    // ---- lighter -----------------------------------------------------------------------------
    toggle<&Params::lighter, &LighterParams::on>(
        "lighter.on", Live, {"Whether the lighter is there at all.", "Sec. 4.2"}),
    real<&Params::lighter, &LighterParams::x>("lighter.x", "", unit::millimetre, {-5000, 5000},
                                              {-300, 300}, Linear, Live,
                                              {"Lighter position, to the right.", "Sec. 4.2"}),
    real<&Params::lighter, &LighterParams::y>(
        "lighter.y", "", unit::millimetre, {-5000, 5000}, {0, 600}, Linear, Live,
        {"Lighter position, height above the ground.", "Sec. 4.2"}),
    real<&Params::lighter, &LighterParams::z>(
        "lighter.z", "", unit::millimetre, {-5000, 5000}, {-300, 300}, Linear, Live,
        {"Lighter position, towards the viewer.", "Sec. 4.2"}),
    real<&Params::lighter, &LighterParams::radius>(
        "lighter.radius", "", unit::millimetre, {0, 1000}, {1, 20}, Linear, Live,
        {"Radius of the nozzle from which particles come.", "Our choice"}),
    real<&Params::lighter, &LighterParams::rate>("lighter.rate", "", unit::hertz, {0, 1e5},
                                                 {50, 1000}, Logarithmic, Live,
                                                 {"Fire particles per second.", "Our choice"}),
    real<&Params::lighter, &LighterParams::speed>(
        "lighter.speed", "", unit::metre_per_second, {0, 50}, {0.1, 1}, Linear, Live,
        {"Upward speed of its particles at birth.", "Our choice"}),
    real<&Params::lighter, &LighterParams::strength>(
        "lighter.strength", "", unit::one, {0, 100},
        {0.1, 4}, Linear, Live,
        {"How much its particles heat, relative to fire.heating.", "Our choice"}),
    real<&Params::lighter, &LighterParams::start>("lighter.start", "", unit::second, {0, 3600},
                                                  {0, 10}, Linear, Live,
                                                  {"When it is lit.", "Our choice"}),
    real<&Params::lighter, &LighterParams::duration>("lighter.duration", "", unit::second,
                                                     {0, 3600}, {0.2, 10}, Linear, Live,
                                                     {"For how long it burns.", "Our choice"}),
    table<&Params::lighter, &LighterParams::path>(
        "lighter.path", kKeyframe, Live,
        {"Where it is when, instead of x, y, z: straight between keyframes, at rest before the "
         "first and after the last.",
         "Our choice"}),
};

}  // namespace ember::param_rows
