// Rows of the table: gravity, air and what paper touches.
#pragma once

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr ParamInfo kSurroundingsRows[] = {
    // ---- world -------------------------------------------------------------------------------
    real<&Params::world, &WorldParams::gravity>(
        "world.gravity", "g", unit::metre_per_second_squared, {0, 1000}, {0, 9.81}, Linear, Live,
        {"Downward acceleration.", "Our choice"}),
    real<&Params::world, &WorldParams::held_gravity>(
        "world.held_gravity", "", unit::one, {0, 1}, {0.01, 1}, Logarithmic, Live,
        {"Share of gravity felt by pieces that are still held: lets paper as soft as the paper's "
         "hang without stretching.",
         "Our choice"}),
    real<&Params::world, &WorldParams::air_drag>(
        "world.air_drag", "", unit::kilogram_per_second_square_metre, {0, 1000}, {0, 1}, Linear,
        Live, {"Resistance of the air to motion across the sheet.", "Our choice"}),
    real<&Params::world, &WorldParams::air_drag_tangential>(
        "world.air_drag_tangential", "", unit::one, {0, 1}, {0.05, 0.3}, Linear, Live,
        {"Share of the air drag that acts along the sheet.", "Our choice"}),
    toggle<&Params::world, &WorldParams::ground>(
        "world.ground", Live, {"Whether paper comes to rest on the ground.", "Our choice"}),
    // ---- wind --------------------------------------------------------------------------------
    real<&Params::wind, &WindParams::x>(
        "wind.x", "", unit::metre_per_second, {-100, 100}, {-2, 2}, Linear, Live,
        {"Velocity of the air, to the right. It acts through world.air_drag and fire.drag.",
         "Our choice"}),
    real<&Params::wind, &WindParams::y>("wind.y", "", unit::metre_per_second, {-100, 100}, {-2, 2},
                                        Linear, Live,
                                        {"Velocity of the air, upwards.", "Our choice"}),
    real<&Params::wind, &WindParams::z>("wind.z", "", unit::metre_per_second, {-100, 100}, {-2, 2},
                                        Linear, Live,
                                        {"Velocity of the air, towards the viewer.", "Our choice"}),
    real<&Params::wind, &WindParams::gust>(
        "wind.gust", "", unit::percent, {0, 1000}, {0, 100}, Linear, Live,
        {"How much of it comes and goes: the wind is 1 + gust sin(2 pi t / period) times its "
         "velocity.",
         "Our choice"}),
    real<&Params::wind, &WindParams::gust_period>("wind.gust_period", "", unit::second,
                                                  {0.01, 3600}, {0.5, 10}, Logarithmic, Live,
                                                  {"From gust to gust.", "Our choice"}),
    // ---- hand --------------------------------------------------------------------------------
    toggle<&Params::hand, &HandParams::on>(
        "hand.on", Live,
        {"A hand holds the sheet at one site and pulls it; in the window, a right drag.",
         "Our choice"}),
    integer<&Params::hand, &HandParams::sheet>("hand.sheet", "", {1, 4096}, {1, 4}, Live,
                                               {"Which sheet, counted from 1.", "Our choice"}),
    integer<&Params::hand, &HandParams::row>("hand.row", "", {0, 4096}, {0, 128}, Live,
                                             {"Row of the site that it holds.", "Our choice"}),
    integer<&Params::hand, &HandParams::column>(
        "hand.column", "", {0, 4096}, {0, 192},
        Live, {"Column of the site that it holds.", "Our choice"}),
    real<&Params::hand, &HandParams::x>(
        "hand.x", "", unit::millimetre,
        kFar, {-500, 500}, Linear, Live,
        {"Where it pulls the site to, to the right.", "Our choice"}),
    real<&Params::hand, &HandParams::y>(
        "hand.y", "", unit::millimetre,
        kFar, {0, 1000}, Linear, Live,
        {"Where it pulls the site to, above the ground.", "Our choice"}),
    real<&Params::hand, &HandParams::z>(
        "hand.z", "", unit::millimetre,
        kFar, {-500, 500}, Linear, Live,
        {"Where it pulls the site to, towards the viewer.", "Our choice"}),
    real<&Params::hand, &HandParams::radius>(
        "hand.radius", "", unit::millimetre,
        {1, 1000}, {5, 50}, Logarithmic, Live,
        {"How much of the paper it holds. Wider pulls more.", "Our choice"}),
    real<&Params::hand, &HandParams::response>(
        "hand.response", "", unit::millisecond, {40, 10000}, {50, 500}, Logarithmic, Live,
        {"How soon the paper follows. Shorter pulls harder.", "Our choice"}),
    // ---- contact -----------------------------------------------------------------------------
    toggle<&Params::contact, &ContactParams::sheets>(
        "contact.sheets", Live, {"Whether sheets touch each other.", "Our choice"}),
    toggle<&Params::contact, &ContactParams::self>(
        "contact.self", Live,
        {"Whether a sheet touches itself where it folds, and its pieces each other.",
         "Our choice"}),
    real<&Params::contact, &ContactParams::thickness>(
        "contact.thickness", "", unit::millimetre, {0.01, 20}, {0.5, 3}, Logarithmic, Live,
        {"Paper keeps this far from paper, and half of it from the ground; its caliper, where that "
         "is more. Folds of one sheet keep no farther apart than its nodes are, and the sheets of "
         "a "
         "stack no farther than sheet.gap.",
         "Our choice"}),
    real<&Params::contact, &ContactParams::friction>("contact.friction", "mu", unit::one, {0, 10},
                                                     {0, 1}, Linear, Live,
                                                     {"Friction of paper on paper.", "Our choice"}),
    real<&Params::contact, &ContactParams::ground_friction>(
        "contact.ground_friction", "mu", unit::one, {0, 10}, {0, 1}, Linear, Live,
        {"Friction of paper on the ground.", "Our choice"}),
    real<&Params::contact, &ContactParams::interval>(
        "contact.interval", "", unit::second, {1e-5, 1}, {1e-3, 8e-3}, Logarithmic, Live,
        {"Contact forces are found anew at least this often while anything is near.",
         "Our choice"}),
};

}  // namespace ember::param_rows
