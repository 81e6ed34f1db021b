// Rows of the table: sheets and how they hold together.
#pragma once

#include <iterator>

#include "sim/param_rows.h"
#include "sim/params.h"

namespace ember::param_rows {

inline constexpr std::string_view kBorders[] = {"tributary", "uniform"};
inline constexpr std::string_view kShapes[] = {"flat", "cylinder"};
inline constexpr std::string_view kPoses[] = {"hanging", "horizontal"};
inline constexpr std::string_view kEdges[] = {"none",
                                              "main_start",
                                              "main_end",
                                              "cross_start",
                                              "cross_end",
                                              "both_main_ends",
                                              "both_cross_ends",
                                              "corner_main_start_cross_start",
                                              "corner_main_start_cross_end",
                                              "corner_main_end_cross_start",
                                              "corner_main_end_cross_end"};
constexpr unsigned bit(HeldEdge place) {
    return static_cast<unsigned>(place);
}
inline constexpr unsigned kEdgeBits[] = {bit(HeldEdge::None),
                                         bit(HeldEdge::MainStart),
                                         bit(HeldEdge::MainEnd),
                                         bit(HeldEdge::CrossStart),
                                         bit(HeldEdge::CrossEnd),
                                         bit(HeldEdge::BothMainEnds),
                                         bit(HeldEdge::BothCrossEnds),
                                         bit(HeldEdge::CornerMainStartCrossStart),
                                         bit(HeldEdge::CornerMainStartCrossEnd),
                                         bit(HeldEdge::CornerMainEndCrossStart),
                                         bit(HeldEdge::CornerMainEndCrossEnd)};
static_assert(std::size(kEdges) == std::size(kEdgeBits));
inline constexpr ParamColumn kHeldPoint[] = {{"main", unit::millimetre, {0, 10000}},
                                             {"cross", unit::millimetre, {0, 10000}},
                                             {"radius", unit::millimetre, {0, 10000}}};
inline constexpr std::string_view kStiffnessLaws[] = {"per_area", "per_node_mass"};
inline constexpr std::string_view kPatterns[] = {"per_fibre", "per_spring"};

inline constexpr ParamInfo kSheetRows[] = {
    // ---- sheet -------------------------------------------------------------------------------
    real<&Params::sheet, &SheetParams::width>("sheet.width", "z", unit::millimetre, {1, 10000},
                                              {20, 500}, Linear, Rebuild,
                                              {"Size in the cross direction.", "Sec. 3, eq. 1"}),
    real<&Params::sheet, &SheetParams::height>(
        "sheet.height", "x", unit::millimetre, {1, 10000}, {20, 500}, Linear, Rebuild,
        {"Size in the main (machine) direction.", "Sec. 3, eq. 1"}),
    integer<&Params::sheet, &SheetParams::rows>(
        "sheet.rows", "M", {1, 4096}, {16, 128}, Rebuild,
        {"Lattice cells across the sheet (cross direction).", "Eq. 1, table 2"}),
    integer<&Params::sheet, &SheetParams::columns>(
        "sheet.columns", "N", {1, 4096}, {24, 192}, Rebuild,
        {"Lattice cells along the sheet (main direction).", "Eq. 1, table 2"}),
    choice<&Params::sheet, &SheetParams::border>(
        "sheet.border", kBorders, Rebuild,
        {"tributary: border nodes carry the mass of their share of the sheet, border springs are "
         "half. uniform: all nodes and springs alike, as in the paper.",
         "Our choice"}),
    choice<&Params::sheet, &SheetParams::shape>(
        "sheet.shape", kShapes, Rebuild,
        {"flat, or closed to a tube along the main direction.", "Sec. 5"}),
    choice<&Params::sheet, &SheetParams::pose>("sheet.pose", kPoses, Rebuild,
                                               {"How the sheet starts.", "Our choice"}),
    set_of<&Params::sheet, &SheetParams::held>(
        "sheet.held", kEdges, kEdgeBits, Rebuild,
        {"What is attached, and kept cold: one edge or corner, or a list of them.", "Sec. 5"}),
    table<&Params::sheet, &SheetParams::held_points>(
        "sheet.held_points", kHeldPoint, Rebuild,
        {"Points that are attached too, measured along the sheet from the corner where main_start "
         "meets cross_start: the nearest node, and all within the radius.",
         "Our choice"}),
    text<&Params::sheet, &SheetParams::mask>(
        "sheet.mask", Rebuild,
        {"A black-and-white PNG beside the preset: paper where it is white. Its x axis is the "
         "cross direction, its y axis, downwards, the main direction.",
         "Our choice"}),
    text<&Params::sheet, &SheetParams::name>("sheet.name", Rebuild,
                                             {"What messages call the sheet.", "Our choice"}),
    real<&Params::sheet, &SheetParams::x>(
        "sheet.x", "", unit::millimetre, kFar, {-500, 500}, Linear, Rebuild,
        {"Moves the sheet to the right of where its pose puts it.", "Our choice"}),
    real<&Params::sheet, &SheetParams::y>("sheet.y", "", unit::millimetre, kFar, {-500, 500},
                                          Linear, Rebuild,
                                          {"Moves the sheet upwards.", "Our choice"}),
    real<&Params::sheet, &SheetParams::z>("sheet.z", "", unit::millimetre, kFar, {-500, 500},
                                          Linear, Rebuild,
                                          {"Moves the sheet towards the viewer.", "Our choice"}),
    real<&Params::sheet, &SheetParams::turn_x>(
        "sheet.turn_x", "", unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Turns the sheet about its middle, first around the x axis: its upper edge comes towards "
         "the viewer.",
         "Our choice"}),
    real<&Params::sheet, &SheetParams::turn_y>(
        "sheet.turn_y", "", unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Then around the y axis, upright: its left edge comes towards the viewer.", "Our choice"}),
    real<&Params::sheet, &SheetParams::turn_z>(
        "sheet.turn_z", "", unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Then around the z axis: anticlockwise for the viewer.", "Our choice"}),
    integer<&Params::sheet, &SheetParams::count>("sheet.count", "", {1, 64}, {1, 4}, Rebuild,
                                                 {"Sheets, one behind the other.", "Sec. 5"}),
    real<&Params::sheet, &SheetParams::gap>("sheet.gap", "", unit::millimetre, {0, 1000}, {5, 50},
                                            Linear, Rebuild,
                                            {"Distance between them.", "Our choice"}),
    real<&Params::sheet, &SheetParams::elevation>(
        "sheet.elevation", "", unit::millimetre, {-10000, 10000}, {0, 1000}, Linear, Rebuild,
        {"Height of the highest edge above the ground at the start.", "Our choice"}),
    real<&Params::sheet, &SheetParams::imperfection>(
        "sheet.imperfection", "", unit::millimetre, {0, 100}, {0.02, 1}, Logarithmic, Rebuild,
        {"Amplitude of the sheet's initial waviness. A perfectly flat sheet cannot buckle.",
         "Our choice"}),
    // ---- springs -----------------------------------------------------------------------------
    real<&Params::springs, &SpringParams::stiffness_scale>(
        "springs.stiffness_scale", "", unit::one, {0.01, 1e4}, {1, 200}, Logarithmic, Live,
        {"Multiplies every spring stiffness; 1 is the paper, which hangs like rubber.",
         "Our choice"}),
    real<&Params::springs, &SpringParams::structural>(
        "springs.structural", "k_structural", unit::per_second_squared, {0, 1e8}, {7e3, 7e3},
        Logarithmic, Live, {"Stiffness of structural springs per node weight.", "Sec. 4.1"}),
    real<&Params::springs, &SpringParams::diagonal>(
        "springs.diagonal", "k_diagonal", unit::per_second_squared, {0, 1e8}, {7e3, 7e3},
        Logarithmic, Live, {"Stiffness of diagonal springs per node weight.", "Sec. 4.1"}),
    real<&Params::springs, &SpringParams::bending>(
        "springs.bending", "k_bending", unit::per_second_squared, {0, 1e8}, {2e4, 2e4}, Logarithmic,
        Live, {"Stiffness of bending springs per node weight.", "Sec. 4.1"}),
    real<&Params::springs, &SpringParams::damping>(
        "springs.damping", "d", unit::hertz, {0, 1e5}, {5, 5}, Logarithmic, Live,
        {"Damping of every spring per node weight.", "Sec. 4.1"}),
    choice<&Params::springs, &SpringParams::stiffness_law>(
        "springs.stiffness_law", kStiffnessLaws, Live,
        {"per_area: the sheet's stiffness does not depend on the lattice. per_node_mass: as "
         "printed; equal at 32x48.",
         "Sec. 4.1"}),
    real<&Params::springs, &SpringParams::variation>(
        "springs.variation", "", unit::percent, {0, 90}, {0, 10}, Linear, Live,
        {"Random variation of structural stiffness from fibre to fibre.", "Sec. 4.1, fig. 3"}),
    choice<&Params::springs, &SpringParams::variation_pattern>(
        "springs.variation_pattern", kPatterns, Live,
        {"per_fibre: one value per fibre, long ones along the main direction. per_spring: each "
         "spring its own.",
         "Sec. 4.1, fig. 3"}),
    toggle<&Params::springs, &SpringParams::follows_mass>(
        "springs.follows_mass", Live,
        {"A node that has lost mass has lost fibre: springs weaken with the mass of their lighter "
         "end. Off is the paper.",
         "Our choice"}),
    // ---- plate -------------------------------------------------------------------------------
    real<&Params::plate, &PlateParams::youngs_main>(
        "plate.youngs_main", "E_x", unit::gigapascal, {0, 1000}, {1, 10}, Linear, Rebuild,
        {"Young's modulus along the main direction, for bending. Office paper has about 5; 0 bends "
         "like cloth. The caliper is grammage / density: paper.density of real paper is 600 to "
         "900.",
         "Our choice"}),
    real<&Params::plate, &PlateParams::youngs_cross>(
        "plate.youngs_cross", "E_z", unit::gigapascal, {0, 1000}, {0.5, 5}, Linear, Rebuild,
        {"Young's modulus in the cross direction, for bending. About half of the other.",
         "Our choice"}),
    real<&Params::plate, &PlateParams::poisson>(
        "plate.poisson", "nu", unit::one, {0, 0.5}, {0.1, 0.4}, Linear, Rebuild,
        {"Poisson's ratio, the geometric mean of the two: how much a sheet that is bent one way "
         "bends the other way across.",
         "Our choice"}),
    real<&Params::plate, &PlateParams::rigidity_main>(
        "plate.rigidity_main", "D_x", unit::newton_millimetre, {0, 1e6}, {0.01, 100}, Logarithmic,
        Rebuild,
        {"Flexural rigidity along the main direction, per width. 0: from Young's modulus.",
         "Our choice"}),
    real<&Params::plate, &PlateParams::rigidity_cross>(
        "plate.rigidity_cross", "D_z", unit::newton_millimetre, {0, 1e6}, {0.01, 100}, Logarithmic,
        Rebuild,
        {"Flexural rigidity in the cross direction, per width. 0: from Young's modulus.",
         "Our choice"}),
    real<&Params::plate, &PlateParams::char_rigidity>(
        "plate.char_rigidity", "", unit::percent, {0, 100}, {5, 50}, Linear, Live,
        {"Share of the rigidity that burnt-out paper keeps; in between it falls with the mass. "
         "Counts with springs.follows_mass.",
         "Our choice"}),
    toggle<&Params::plate, &PlateParams::clamped>(
        "plate.clamped", Rebuild,
        {"Held borders keep their slope as in a clip; off: they turn freely, as on a line of pins.",
         "Our choice"}),
    // ---- curl --------------------------------------------------------------------------------
    real<&Params::curl, &CurlParams::heat>(
        "curl.heat", "", unit::per_kelvin,
        {-0.01, 0.01}, {0, 2e-4}, Linear, Rebuild,
        {"Strain per kelvin by which the hotter half of the caliper shrinks, since it dries: paper "
         "curls towards the fire. Below 0 it curls away. Needs plate.youngs_main.",
         "Our choice"}),
    real<&Params::curl, &CurlParams::charring>(
        "curl.charring", "", unit::percent, {-100, 100}, {0, 5}, Linear, Rebuild,
        {"Strain by which a half that has charred alone has shrunk; it stays. Needs "
         "plate.youngs_main.",
         "Our choice"}),
    real<&Params::curl, &CurlParams::two_sided>(
        "curl.two_sided", "", unit::percent, {-100, 100}, {0, 5}, Linear, Rebuild,
        {"Strain by which charring shrinks one face more than the other, since paper is made with "
         "two unlike faces: ash rolls up towards the viewer, below 0 away from him. Needs "
         "plate.youngs_main.",
         "Our choice"}),
    real<&Params::curl, &CurlParams::cross_ratio>(
        "curl.cross_ratio", "", unit::one, {0, 20}, {1, 3}, Linear, Rebuild,
        {"How much more paper shrinks in the cross direction than along its fibres.",
         "Our choice"}),
    real<&Params::curl, &CurlParams::set>(
        "curl.set", "", unit::one, {0, 100}, {0, 5}, Linear, Rebuild,
        {"Plastic set: charring paper takes its curvature for the one at rest, all but e^-set of "
         "the difference. Needs plate.youngs_main.",
         "Our choice"}),
};

}  // namespace ember::param_rows
