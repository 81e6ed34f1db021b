#include "sim/param_table.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "sim/param_rows.h"
#include "sim/scene.h"

namespace ember {
namespace {

using namespace param_rows;

using enum ParamScale;
using enum ParamApplies;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::string_view kBorders[] = {"tributary", "uniform"};
constexpr std::string_view kShapes[] = {"flat", "cylinder"};
constexpr std::string_view kPoses[] = {"hanging", "horizontal"};
constexpr std::string_view kEdges[] = {"none",
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
constexpr unsigned kEdgeBits[] = {bit(HeldEdge::None),
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
constexpr std::string_view kStiffnessLaws[] = {"per_area", "per_node_mass"};
constexpr std::string_view kPatterns[] = {"per_fibre", "per_spring"};
constexpr std::string_view kFractureRules[] = {"paper", "stress"};
constexpr std::string_view kShrinkRules[] = {"both_burning", "half"};
constexpr std::string_view kIntegrators[] = {
    "auto",  "semi_implicit_euler",     "velocity_verlet", "rk4", "dopri5",
    "rkf78", "adams_bashforth_moulton", "rosenbrock"};
constexpr std::string_view kHeatSolvers[] = {"auto", "ftcs", "rkl2", "adi"};
constexpr std::string_view kArithmetics[] = {"exact", "fast"};

constexpr ParamRange kFar = {-10000, 10000};  // [mm]
constexpr ParamColumn kHeldPoint[] = {{"main", unit::millimetre, {0, 10000}},
                                      {"cross", unit::millimetre, {0, 10000}},
                                      {"radius", unit::millimetre, {0, 10000}}};
constexpr ParamColumn kKeyframe[] = {{"time", unit::second, {0, 3600}, true},
                                     {"x", unit::millimetre, kFar},
                                     {"y", unit::millimetre, kFar},
                                     {"z", unit::millimetre, kFar}};

using P = Params;

constexpr ParamInfo kRows[] = {
    // ---- paper -------------------------------------------------------------------------------
    real<&P::paper, &PaperParams::grammage>(
        "paper.grammage", "G", unit::gram_per_square_metre, {5, 5000}, {18, 400}, Logarithmic, Live,
        {"Mass of one square metre. Heavier paper burns slower and crumples less.",
         "Sec. 3, table 2"}),
    real<&P::paper, &PaperParams::density>(
        "paper.density", "rho", unit::kilogram_per_cubic_metre, {50, 5000}, {250, 1500}, Linear,
        Live,
        {"Mass of one cubic metre; caliper is grammage / density. Denser paper conducts "
         "heat more slowly.",
         "Sec. 3, table 2"}),
    real<&P::paper, &PaperParams::c_s>(
        "paper.c_s", "c_s", unit::one, {1e-6, 1}, {1e-4, 1}, Logarithmic, Live,
        {"Dimensional stability: the quality of the paper. Higher burns slower and shrinks less.",
         "Sec. 4.1, eqs. 2 and 4"}),
    real<&P::paper, &PaperParams::specific_heat>(
        "paper.specific_heat", "c", unit::joule_per_kilogram_kelvin, {1, 1e5}, {1000, 2000}, Linear,
        Live, {"Specific heat capacity. Higher heats up more slowly.", "Table 1"}),
    real<&P::paper, &PaperParams::conductivity>(
        "paper.conductivity", "D", unit::watt_per_metre_kelvin, {0, 10}, {0.02, 0.2}, Linear, Live,
        {"Thermal conductivity. Higher spreads heat faster along the fibres.", "Table 1"}),
    // ---- shrinkage ---------------------------------------------------------------------------
    real<&P::shrinkage, &ShrinkageParams::factor>(
        "shrinkage.factor", "factor", unit::one, {0, 1e-6}, {1e-12, 1e-8}, Logarithmic, Live,
        {"Scales the shrinking of burning fibres. Higher crumples more; 0 not at all.",
         "Sec. 4.3, eq. 4"}),
    real<&P::shrinkage, &ShrinkageParams::reference_step>(
        "shrinkage.reference_step", "dt_ref", unit::millisecond, {0.01, 1000}, {1, 20}, Logarithmic,
        Live,
        {"Time that one application of eq. 4 stands for; the paper does not say.", "Our choice"}),
    real<&P::shrinkage, &ShrinkageParams::floor>(
        "shrinkage.floor", "", unit::one, {0.01, 1}, {0.5, 0.9}, Linear, Live,
        {"No fibre shrinks below this share of its initial length.", "Our choice"}),
    choice<&P::shrinkage, &ShrinkageParams::rule>(
        "shrinkage.rule", kShrinkRules, Live,
        {"both_burning: eq. 4 where both ends burn, and by half for bending springs with one. "
         "half: every spring shrinks in proportion to its burning ends.",
         "Sec. 4.3"}),
    toggle<&P::shrinkage, &ShrinkageParams::literal_stiffness>(
        "shrinkage.literal_stiffness", Live,
        {"Use each kind's own stiffness as k_s in eq. 4, so that bending springs shrink less.",
         "Sec. 4.3"}),
    // ---- lighter -----------------------------------------------------------------------------
    toggle<&P::lighter, &LighterParams::on>("lighter.on", Live,
                                            {"Whether the lighter is there at all.", "Sec. 4.2"}),
    real<&P::lighter, &LighterParams::x>("lighter.x", "", unit::millimetre, {-5000, 5000},
                                         {-300, 300}, Linear, Live,
                                         {"Lighter position, to the right.", "Sec. 4.2"}),
    real<&P::lighter, &LighterParams::y>(
        "lighter.y", "", unit::millimetre, {-5000, 5000}, {0, 600}, Linear, Live,
        {"Lighter position, height above the ground.", "Sec. 4.2"}),
    real<&P::lighter, &LighterParams::z>("lighter.z", "", unit::millimetre, {-5000, 5000},
                                         {-300, 300}, Linear, Live,
                                         {"Lighter position, towards the viewer.", "Sec. 4.2"}),
    real<&P::lighter, &LighterParams::radius>(
        "lighter.radius", "", unit::millimetre, {0, 1000}, {1, 20}, Linear, Live,
        {"Radius of the nozzle from which particles come.", "Our choice"}),
    real<&P::lighter, &LighterParams::rate>("lighter.rate", "", unit::hertz, {0, 1e5}, {50, 1000},
                                            Logarithmic, Live,
                                            {"Fire particles per second.", "Our choice"}),
    real<&P::lighter, &LighterParams::speed>(
        "lighter.speed", "", unit::metre_per_second, {0, 50}, {0.1, 1}, Linear, Live,
        {"Upward speed of its particles at birth.", "Our choice"}),
    real<&P::lighter, &LighterParams::strength>(
        "lighter.strength", "", unit::one, {0, 100}, {0.1, 4}, Linear, Live,
        {"How much its particles heat, relative to fire.heating.", "Our choice"}),
    real<&P::lighter, &LighterParams::start>("lighter.start", "", unit::second, {0, 3600}, {0, 10},
                                             Linear, Live, {"When it is lit.", "Our choice"}),
    real<&P::lighter, &LighterParams::duration>("lighter.duration", "", unit::second, {0, 3600},
                                                {0.2, 10}, Linear, Live,
                                                {"For how long it burns.", "Our choice"}),
    table<&P::lighter, &LighterParams::path>(
        "lighter.path", kKeyframe, Live,
        {"Where it is when, instead of x, y, z: straight between keyframes, at rest before the "
         "first and after the last.",
         "Our choice"}),
    // ---- sheet -------------------------------------------------------------------------------
    real<&P::sheet, &SheetParams::width>("sheet.width", "z", unit::millimetre, {1, 10000},
                                         {20, 500}, Linear, Rebuild,
                                         {"Size in the cross direction.", "Sec. 3, eq. 1"}),
    real<&P::sheet, &SheetParams::height>(
        "sheet.height", "x", unit::millimetre, {1, 10000}, {20, 500}, Linear, Rebuild,
        {"Size in the main (machine) direction.", "Sec. 3, eq. 1"}),
    integer<&P::sheet, &SheetParams::rows>(
        "sheet.rows", "M", {1, 4096}, {16, 128}, Rebuild,
        {"Lattice cells across the sheet (cross direction).", "Eq. 1, table 2"}),
    integer<&P::sheet, &SheetParams::columns>(
        "sheet.columns", "N", {1, 4096}, {24, 192}, Rebuild,
        {"Lattice cells along the sheet (main direction).", "Eq. 1, table 2"}),
    choice<&P::sheet, &SheetParams::border>(
        "sheet.border", kBorders, Rebuild,
        {"tributary: border nodes carry the mass of their share of the sheet, border springs are "
         "half. uniform: all nodes and springs alike, as in the paper.",
         "Our choice"}),
    choice<&P::sheet, &SheetParams::shape>(
        "sheet.shape", kShapes, Rebuild,
        {"flat, or closed to a tube along the main direction.", "Sec. 5"}),
    choice<&P::sheet, &SheetParams::pose>("sheet.pose", kPoses, Rebuild,
                                          {"How the sheet starts.", "Our choice"}),
    set_of<&P::sheet, &SheetParams::held>(
        "sheet.held", kEdges, kEdgeBits, Rebuild,
        {"What is attached, and kept cold: one edge or corner, or a list of them.", "Sec. 5"}),
    table<&P::sheet, &SheetParams::held_points>(
        "sheet.held_points", kHeldPoint, Rebuild,
        {"Points that are attached too, measured along the sheet from the corner where main_start "
         "meets cross_start: the nearest node, and all within the radius.",
         "Our choice"}),
    text<&P::sheet, &SheetParams::mask>(
        "sheet.mask", Rebuild,
        {"A black-and-white PNG beside the preset: paper where it is white. Its x axis is the "
         "cross direction, its y axis, downwards, the main direction.",
         "Our choice"}),
    text<&P::sheet, &SheetParams::name>("sheet.name", Rebuild,
                                        {"What messages call the sheet.", "Our choice"}),
    real<&P::sheet, &SheetParams::x>(
        "sheet.x", "", unit::millimetre, kFar, {-500, 500}, Linear, Rebuild,
        {"Moves the sheet to the right of where its pose puts it.", "Our choice"}),
    real<&P::sheet, &SheetParams::y>("sheet.y", "", unit::millimetre, kFar, {-500, 500}, Linear,
                                     Rebuild, {"Moves the sheet upwards.", "Our choice"}),
    real<&P::sheet, &SheetParams::z>("sheet.z", "", unit::millimetre, kFar, {-500, 500}, Linear,
                                     Rebuild,
                                     {"Moves the sheet towards the viewer.", "Our choice"}),
    real<&P::sheet, &SheetParams::turn_x>(
        "sheet.turn_x", "",
        unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Turns the sheet about its middle, first around the x axis: its upper edge comes towards "
         "the viewer.",
         "Our choice"}),
    real<&P::sheet, &SheetParams::turn_y>(
        "sheet.turn_y", "",
        unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Then around the y axis, upright: its left edge comes towards the viewer.", "Our choice"}),
    real<&P::sheet, &SheetParams::turn_z>(
        "sheet.turn_z", "",
        unit::degree, {-360, 360}, {-180, 180}, Linear, Rebuild,
        {"Then around the z axis: anticlockwise for the viewer.", "Our choice"}),
    integer<&P::sheet, &SheetParams::count>("sheet.count", "", {1, 64}, {1, 4}, Rebuild,
                                            {"Sheets, one behind the other.", "Sec. 5"}),
    real<&P::sheet, &SheetParams::gap>("sheet.gap", "", unit::millimetre, {0, 1000}, {5, 50},
                                       Linear, Rebuild, {"Distance between them.", "Our choice"}),
    real<&P::sheet, &SheetParams::elevation>(
        "sheet.elevation", "", unit::millimetre, {-10000, 10000}, {0, 1000}, Linear, Rebuild,
        {"Height of the highest edge above the ground at the start.", "Our choice"}),
    real<&P::sheet, &SheetParams::imperfection>(
        "sheet.imperfection", "", unit::millimetre, {0, 100}, {0.02, 1}, Logarithmic, Rebuild,
        {"Amplitude of the sheet's initial waviness. A perfectly flat sheet cannot buckle.",
         "Our choice"}),
    // ---- springs -----------------------------------------------------------------------------
    real<&P::springs, &SpringParams::stiffness_scale>(
        "springs.stiffness_scale", "", unit::one, {0.01, 1e4}, {1, 200}, Logarithmic, Live,
        {"Multiplies every spring stiffness; 1 is the paper, which hangs like rubber.",
         "Our choice"}),
    real<&P::springs, &SpringParams::structural>(
        "springs.structural", "k_structural", unit::per_second_squared, {0, 1e8}, {7e3, 7e3},
        Logarithmic, Live, {"Stiffness of structural springs per node weight.", "Sec. 4.1"}),
    real<&P::springs, &SpringParams::diagonal>(
        "springs.diagonal", "k_diagonal", unit::per_second_squared, {0, 1e8}, {7e3, 7e3},
        Logarithmic, Live, {"Stiffness of diagonal springs per node weight.", "Sec. 4.1"}),
    real<&P::springs, &SpringParams::bending>(
        "springs.bending", "k_bending", unit::per_second_squared, {0, 1e8}, {2e4, 2e4}, Logarithmic,
        Live, {"Stiffness of bending springs per node weight.", "Sec. 4.1"}),
    real<&P::springs, &SpringParams::damping>(
        "springs.damping", "d", unit::hertz, {0, 1e5}, {5, 5}, Logarithmic, Live,
        {"Damping of every spring per node weight.", "Sec. 4.1"}),
    choice<&P::springs, &SpringParams::stiffness_law>(
        "springs.stiffness_law", kStiffnessLaws, Live,
        {"per_area: the sheet's stiffness does not depend on the lattice. per_node_mass: as "
         "printed; equal at 32x48.",
         "Sec. 4.1"}),
    real<&P::springs, &SpringParams::variation>(
        "springs.variation", "", unit::percent,
        {0, 90}, {0, 10}, Linear, Live,
        {"Random variation of structural stiffness from fibre to fibre.", "Sec. 4.1, fig. 3"}),
    choice<&P::springs, &SpringParams::variation_pattern>(
        "springs.variation_pattern", kPatterns, Live,
        {"per_fibre: one value per fibre, long ones along the main direction. per_spring: each "
         "spring its own.",
         "Sec. 4.1, fig. 3"}),
    toggle<&P::springs, &SpringParams::follows_mass>(
        "springs.follows_mass", Live,
        {"A node that has lost mass has lost fibre: springs weaken with the mass of their lighter "
         "end. Off is the paper.",
         "Our choice"}),
    // ---- plate -------------------------------------------------------------------------------
    real<&P::plate, &PlateParams::youngs_main>(
        "plate.youngs_main", "E_x", unit::gigapascal, {0, 1000}, {1, 10}, Linear, Rebuild,
        {"Young's modulus along the main direction, for bending. Office paper has about 5; 0 bends "
         "like cloth. The caliper is grammage / density: paper.density of real paper is 600 to "
         "900.",
         "Our choice"}),
    real<&P::plate, &PlateParams::youngs_cross>(
        "plate.youngs_cross", "E_z", unit::gigapascal, {0, 1000}, {0.5, 5}, Linear, Rebuild,
        {"Young's modulus in the cross direction, for bending. About half of the other.",
         "Our choice"}),
    real<&P::plate, &PlateParams::poisson>(
        "plate.poisson", "nu", unit::one, {0, 0.5}, {0.1, 0.4}, Linear, Rebuild,
        {"Poisson's ratio, the geometric mean of the two: how much a sheet that is bent one way "
         "bends the other way across.",
         "Our choice"}),
    real<&P::plate, &PlateParams::rigidity_main>(
        "plate.rigidity_main", "D_x", unit::newton_millimetre, {0, 1e6}, {0.01, 100}, Logarithmic,
        Rebuild,
        {"Flexural rigidity along the main direction, per width. 0: from Young's modulus.",
         "Our choice"}),
    real<&P::plate, &PlateParams::rigidity_cross>(
        "plate.rigidity_cross", "D_z", unit::newton_millimetre, {0, 1e6}, {0.01, 100}, Logarithmic,
        Rebuild,
        {"Flexural rigidity in the cross direction, per width. 0: from Young's modulus.",
         "Our choice"}),
    real<&P::plate, &PlateParams::char_rigidity>(
        "plate.char_rigidity", "", unit::percent, {0, 100}, {5, 50}, Linear, Live,
        {"Share of the rigidity that burnt-out paper keeps; in between it falls with the mass. "
         "Counts with springs.follows_mass.",
         "Our choice"}),
    toggle<&P::plate, &PlateParams::clamped>(
        "plate.clamped", Rebuild,
        {"Held borders keep their slope as in a clip; off: they turn freely, as on a line of pins.",
         "Our choice"}),
    // ---- curl --------------------------------------------------------------------------------
    real<&P::curl, &CurlParams::heat>(
        "curl.heat", "", unit::per_kelvin, {-0.01, 0.01}, {0, 2e-4}, Linear, Rebuild,
        {"Strain per kelvin by which the hotter half of the caliper shrinks, since it dries: paper "
         "curls towards the fire. Below 0 it curls away. Needs plate.youngs_main.",
         "Our choice"}),
    real<&P::curl, &CurlParams::charring>(
        "curl.charring", "", unit::percent, {-100, 100}, {0, 5}, Linear, Rebuild,
        {"Strain by which a half that has charred alone has shrunk; it stays. Needs "
         "plate.youngs_main.",
         "Our choice"}),
    real<&P::curl, &CurlParams::cross_ratio>(
        "curl.cross_ratio", "", unit::one, {0, 20}, {1, 3}, Linear, Rebuild,
        {"How much more paper shrinks in the cross direction than along its fibres.",
         "Our choice"}),
    real<&P::curl, &CurlParams::set>(
        "curl.set", "", unit::one, {0, 100}, {0, 5}, Linear, Rebuild,
        {"Plastic set: charring paper takes its curvature for the one at rest, all but e^-set of "
         "the difference. Needs plate.youngs_main.",
         "Our choice"}),
    // ---- world -------------------------------------------------------------------------------
    real<&P::world, &WorldParams::gravity>("world.gravity", "g", unit::metre_per_second_squared,
                                           {0, 1000}, {0, 9.81}, Linear, Live,
                                           {"Downward acceleration.", "Our choice"}),
    real<&P::world, &WorldParams::held_gravity>(
        "world.held_gravity", "", unit::one, {0, 1}, {0.01, 1}, Logarithmic, Live,
        {"Share of gravity felt by pieces that are still held: lets paper as soft as the paper's "
         "hang without stretching.",
         "Our choice"}),
    real<&P::world, &WorldParams::air_drag>(
        "world.air_drag", "", unit::kilogram_per_second_square_metre, {0, 1000}, {0, 1}, Linear,
        Live, {"Resistance of the air to motion across the sheet.", "Our choice"}),
    real<&P::world, &WorldParams::air_drag_tangential>(
        "world.air_drag_tangential", "", unit::one, {0, 1}, {0.05, 0.3}, Linear, Live,
        {"Share of the air drag that acts along the sheet.", "Our choice"}),
    toggle<&P::world, &WorldParams::ground>(
        "world.ground", Live, {"Whether paper comes to rest on the ground.", "Our choice"}),
    // ---- wind --------------------------------------------------------------------------------
    real<&P::wind, &WindParams::x>(
        "wind.x", "", unit::metre_per_second, {-100, 100}, {-2, 2}, Linear, Live,
        {"Velocity of the air, to the right. It acts through world.air_drag and fire.drag.",
         "Our choice"}),
    real<&P::wind, &WindParams::y>("wind.y", "", unit::metre_per_second, {-100, 100}, {-2, 2},
                                   Linear, Live, {"Velocity of the air, upwards.", "Our choice"}),
    real<&P::wind, &WindParams::z>("wind.z", "", unit::metre_per_second, {-100, 100}, {-2, 2},
                                   Linear, Live,
                                   {"Velocity of the air, towards the viewer.", "Our choice"}),
    real<&P::wind, &WindParams::gust>(
        "wind.gust", "", unit::percent, {0, 1000}, {0, 100}, Linear, Live,
        {"How much of it comes and goes: the wind is 1 + gust sin(2 pi t / period) times its "
         "velocity.",
         "Our choice"}),
    real<&P::wind, &WindParams::gust_period>("wind.gust_period", "", unit::second, {0.01, 3600},
                                             {0.5, 10}, Logarithmic, Live,
                                             {"From gust to gust.", "Our choice"}),
    // ---- hand --------------------------------------------------------------------------------
    toggle<&P::hand, &HandParams::on>(
        "hand.on", Live,
        {"A hand holds the sheet at one site and pulls it; in the window, a right drag.",
         "Our choice"}),
    integer<&P::hand, &HandParams::sheet>("hand.sheet", "", {1, 4096}, {1, 4}, Live,
                                          {"Which sheet, counted from 1.", "Our choice"}),
    integer<&P::hand, &HandParams::row>("hand.row", "", {0, 4096}, {0, 128}, Live,
                                        {"Row of the site that it holds.", "Our choice"}),
    integer<&P::hand, &HandParams::column>("hand.column", "", {0, 4096}, {0, 192}, Live,
                                           {"Column of the site that it holds.", "Our choice"}),
    real<&P::hand, &HandParams::x>("hand.x", "", unit::millimetre, kFar, {-500, 500}, Linear, Live,
                                   {"Where it pulls the site to, to the right.", "Our choice"}),
    real<&P::hand, &HandParams::y>("hand.y", "", unit::millimetre, kFar, {0, 1000}, Linear, Live,
                                   {"Where it pulls the site to, above the ground.", "Our choice"}),
    real<&P::hand, &HandParams::z>(
        "hand.z", "", unit::millimetre, kFar, {-500, 500}, Linear, Live,
        {"Where it pulls the site to, towards the viewer.", "Our choice"}),
    real<&P::hand, &HandParams::radius>(
        "hand.radius", "", unit::millimetre, {1, 1000}, {5, 50}, Logarithmic, Live,
        {"How much of the paper it holds. Wider pulls more.", "Our choice"}),
    real<&P::hand, &HandParams::response>(
        "hand.response", "", unit::millisecond, {40, 10000}, {50, 500}, Logarithmic, Live,
        {"How soon the paper follows. Shorter pulls harder.", "Our choice"}),
    // ---- contact -----------------------------------------------------------------------------
    toggle<&P::contact, &ContactParams::sheets>("contact.sheets", Live,
                                                {"Whether sheets touch each other.", "Our choice"}),
    toggle<&P::contact, &ContactParams::self>(
        "contact.self", Live,
        {"Whether a sheet touches itself where it folds, and its pieces each other.",
         "Our choice"}),
    real<&P::contact, &ContactParams::thickness>(
        "contact.thickness", "", unit::millimetre, {0.01, 20}, {0.5, 3}, Logarithmic, Live,
        {"Paper keeps this far from paper, and half of it from the ground; its caliper, where that "
         "is more. Folds of one sheet keep no farther apart than its nodes are.",
         "Our choice"}),
    real<&P::contact, &ContactParams::friction>("contact.friction", "mu", unit::one, {0, 10},
                                                {0, 1}, Linear, Live,
                                                {"Friction of paper on paper.", "Our choice"}),
    real<&P::contact, &ContactParams::ground_friction>(
        "contact.ground_friction", "mu", unit::one, {0, 10}, {0, 1}, Linear, Live,
        {"Friction of paper on the ground.", "Our choice"}),
    real<&P::contact, &ContactParams::interval>(
        "contact.interval", "", unit::second, {1e-5, 1}, {1e-3, 8e-3}, Logarithmic, Live,
        {"Contact forces are found anew at least this often while anything is near.",
         "Our choice"}),
    // ---- heat --------------------------------------------------------------------------------
    real<&P::heat, &HeatParams::ambient>("heat.ambient", "", unit::celsius, {-200, 500}, {0, 40},
                                         Linear, Rebuild,
                                         {"Temperature of air and cold paper.", "Our choice"}),
    real<&P::heat, &HeatParams::flame_limit>("heat.flame_limit", "T_max", unit::celsius, {0, 5000},
                                             {900, 1300}, Linear, Live,
                                             {"No fire heats paper above this.", "Our choice"}),
    real<&P::heat, &HeatParams::convection>(
        "heat.convection", "h", unit::watt_per_square_metre_kelvin, {0, 1e5}, {0, 60}, Linear, Live,
        {"Heat lost to the air by each face; 0 is the paper. It acts on the sheet's true "
         "heat capacity c G.",
         "Our choice"}),
    real<&P::heat, &HeatParams::emissivity>(
        "heat.emissivity", "eps", unit::one, {0, 1}, {0, 0.9}, Linear, Live,
        {"Heat radiated by each face, as a share of a black body; 0 is the paper.", "Our choice"}),
    // ---- burning -----------------------------------------------------------------------------
    real<&P::burning, &BurningParams::ignition>(
        "burning.ignition", "", unit::celsius, {-200, 5000}, {300, 768}, Linear, Live,
        {"A node starts to burn at this temperature.", "Sec. 4.2: 1.5 x 512"}),
    real<&P::burning, &BurningParams::burn_rate>(
        "burning.burn_rate", "", unit::gram_per_second_square_metre, {0, 1e5}, {14, 520},
        Logarithmic, Live,
        {"Mass lost by burning paper. The paper's 0.02 g/s per node is 520 here, and dies out.",
         "Sec. 4.2"}),
    real<&P::burning, &BurningParams::residual_mass>(
        "burning.residual_mass", "", unit::percent, {1, 99}, {8, 30}, Linear, Live,
        {"What is left of a node when it has burnt out.", "Sec. 4.2"}),
    real<&P::burning, &BurningParams::heat_release>(
        "burning.heat_release", "s", unit::kelvin_per_second, {0, 1e7}, {0, 4e4}, Linear, Live,
        {"Heating of a burning node by its own flame.", "Sec. 4.2, eq. 2"}),
    real<&P::burning, &BurningParams::burn_speed>(
        "burning.burn_speed", "", unit::one, {0.01, 100}, {0.1, 10}, Logarithmic, Live,
        {"Scales conduction, sources, losses and burn rate together: a faster front of the same "
         "width.",
         "Our choice"}),
    // ---- fire --------------------------------------------------------------------------------
    real<&P::fire, &FireParams::temperature>(
        "fire.temperature", "", unit::celsius, {-200, 5000}, {512, 512}, Linear, Live,
        {"Temperature of a fire particle at birth.", "Sec. 4.2"}),
    real<&P::fire, &FireParams::emission>(
        "fire.emission", "", unit::per_second_square_metre, {0, 1e8}, {1e5, 3e6}, Logarithmic, Live,
        {"Fire particles born per second and square metre of burning paper.", "Our choice"}),
    toggle<&P::fire, &FireParams::area_emission>(
        "fire.area_emission", Live,
        {"Particles start anywhere on burning paper and not only at its nodes: the front then has "
         "the same speed on every lattice that resolves fire.kernel_radius.",
         "Our choice"}),
    real<&P::fire, &FireParams::heating>(
        "fire.heating", "A_0", unit::kelvin_per_second, {0, 1e7}, {300, 3e4}, Logarithmic, Live,
        {"Heating by one particle at its centre, for 80 g/m^2 and c_s 2e-4.", "Our choice"}),
    real<&P::fire, &FireParams::heating_time>(
        "fire.heating_time", "", unit::second, {1e-3, 1e6}, {0.02, 1}, Logarithmic, Live,
        {"Particles heat best while they are fresh: what they give falls to 37 % in this time, "
         "though the flame is seen for longer. Longer makes fire climb faster than it creeps.",
         "Our choice"}),
    real<&P::fire, &FireParams::heating_limit>(
        "fire.heating_limit", "S_max", unit::kelvin_per_second, {1, 1e8}, {8e3, 4e4}, Logarithmic,
        Live,
        {"However many particles surround a node, they heat it no faster than this.",
         "Our choice"}),
    real<&P::fire, &FireParams::kernel_radius>("fire.kernel_radius", "r_k", unit::millimetre,
                                               {0.5, 1000}, {6, 22}, Linear, Live,
                                               {"How far a particle reaches.", "Our choice"}),
    real<&P::fire, &FireParams::absorption>(
        "fire.absorption", "", unit::hertz,
        {0, 1e5}, {0, 100}, Linear, Live,
        {"How fast a particle close to paper loses what it gives. 0: it heats every sheet of a "
         "stack alike.",
         "Our choice"}),
    real<&P::fire, &FireParams::node_strength>(
        "fire.node_strength", "", unit::one, {0, 100}, {0, 2}, Linear, Live,
        {"How much particles of burning nodes heat, relative to fire.heating.", "Our choice"}),
    real<&P::fire, &FireParams::grammage_exponent>(
        "fire.grammage_exponent", "", unit::one, {0, 2}, {0, 1}, Linear, Live,
        {"Heating falls with grammage to this power; 1 is eq. 2 by the letter.", "Our choice"}),
    real<&P::fire, &FireParams::stability_exponent>(
        "fire.stability_exponent", "", unit::one, {0, 2}, {0, 1}, Linear, Live,
        {"Heating falls with c_s to this power; 1 is eq. 2 by the letter.", "Our choice"}),
    real<&P::fire, &FireParams::cooling_time>(
        "fire.cooling_time", "", unit::second, {0.001, 1000}, {0.2, 1}, Linear, Live,
        {"A particle's excess temperature falls to 37 % in this time.", "Our choice"}),
    real<&P::fire, &FireParams::life_min>("fire.life_min", "", unit::second, {0.01, 60}, {0.2, 1},
                                          Linear, Live,
                                          {"Shortest life of a particle.", "Our choice"}),
    real<&P::fire, &FireParams::life_max>("fire.life_max", "", unit::second, {0.01, 60}, {0.3, 2},
                                          Linear, Live,
                                          {"Longest life of a particle.", "Our choice"}),
    real<&P::fire, &FireParams::rise_speed>(
        "fire.rise_speed", "", unit::metre_per_second, {0, 50}, {0, 1}, Linear, Live,
        {"Upward speed at birth of particles from burning nodes.", "Our choice"}),
    real<&P::fire, &FireParams::standoff>(
        "fire.standoff", "", unit::millimetre, {0, 1000}, {0, 10}, Linear, Live,
        {"How far above the burning paper that feeds it a flame stands: gas burns only once it "
         "has mixed with air. Higher lets fire creep down and sideways less than up.",
         "Our choice"}),
    real<&P::fire, &FireParams::lateral_speed>(
        "fire.lateral_speed", "", unit::metre_per_second, {0, 50}, {0, 0.3}, Linear, Live,
        {"Spread of the velocity at birth, standard deviation per axis.", "Our choice"}),
    real<&P::fire, &FireParams::buoyancy>(
        "fire.buoyancy", "", unit::metre_per_second_squared, {0, 1000}, {0, 10}, Linear, Live,
        {"Upward acceleration of a particle as hot as at birth.", "Our choice"}),
    real<&P::fire, &FireParams::drag>("fire.drag", "", unit::hertz, {0, 1000}, {0, 5}, Linear, Live,
                                      {"How fast a particle is slowed by the air.", "Our choice"}),
    real<&P::fire, &FireParams::force>(
        "fire.force", "f_ext", unit::kilogram_per_second_square_metre, {0, 100}, {0, 0.1}, Linear,
        Live, {"Push of passing particles on the sheet.", "Sec. 4.2"}),
    real<&P::fire, &FireParams::force_limit>(
        "fire.force_limit", "", unit::metre_per_second_squared, {0, 1000}, {0, 5}, Linear, Live,
        {"The push never accelerates a node by more than this.", "Our choice"}),
    // ---- fracture ----------------------------------------------------------------------------
    choice<&P::fracture, &FractureParams::rule>(
        "fracture.rule", kFractureRules, Live,
        {"paper: bending springs break, and cuts are horizontal or vertical. stress: cracks of any "
         "direction follow stress, grain and the burnt boundary.",
         "Sec. 4.4 (paper), sec. 6 (stress)"}),
    real<&P::fracture, &FractureParams::threshold>(
        "fracture.threshold", "", unit::percent, {0, kInfinity}, {0.6, 4}, Logarithmic, Live,
        {"A burnt bending spring breaks when stretched by this; by the rule stress, ash where its "
         "stress would stretch a whole sheet so. Lower falls to smaller flakes; inf never cracks.",
         "Sec. 4.4"}),
    toggle<&P::fracture, &FractureParams::middle_burnt>(
        "fracture.middle_burnt", Live,
        {"The node between must be burnt out too. Off is the paper.", "Our choice"}),
    real<&P::fracture, &FractureParams::relief_radius>(
        "fracture.relief_radius", "", unit::millimetre, {0, 10000}, {0, 30}, Linear, Live,
        {"A cut relieves the stress around it: no second cut within this distance ...",
         "Our choice"}),
    real<&P::fracture, &FractureParams::relief_time>(
        "fracture.relief_time", "", unit::second, {0, 100}, {0, 1}, Linear, Live,
        {"... for this long. 0 cuts everything over-stretched at once, as the paper does.",
         "Our choice"}),
    toggle<&P::fracture, &FractureParams::release_hinges>(
        "fracture.release_hinges", Live,
        {"Pieces that hang together by a single node let go.", "Our choice"}),
    real<&P::fracture, &FractureParams::ash_strength>(
        "fracture.ash_strength", "", unit::percent, {1, 100}, {5, 100}, Linear, Live,
        {"Ash grows weak with age, down to this share of the threshold ...", "Our choice"}),
    real<&P::fracture, &FractureParams::ash_time>(
        "fracture.ash_time", "", unit::second, {0.001, 1000}, {0.5, 10}, Logarithmic, Live,
        {"... in this time after it burnt out, for 80 g/m^2; in proportion to grammage.",
         "Our choice"}),
    real<&P::fracture, &FractureParams::strength_noise>(
        "fracture.strength_noise", "", unit::percent, {0, 90}, {0, 40}, Linear, Live,
        {"Formation: how much the strength of ash varies from place to place ...", "Our choice"}),
    real<&P::fracture, &FractureParams::noise_length>(
        "fracture.noise_length", "", unit::millimetre, {1, 1000}, {5, 40}, Linear, Live,
        {"... and over what distance.", "Our choice"}),
    real<&P::fracture, &FractureParams::grain>(
        "fracture.grain", "", unit::one, {0.05, 20}, {0.4, 1}, Linear, Live,
        {"Strength across the fibres, relative to along them. Lower turns cracks along the main "
         "direction. Only for the rule stress.",
         "Our choice"}),
    real<&P::fracture, &FractureParams::boundary>(
        "fracture.boundary", "", unit::one, {0, 0.95}, {0, 0.5}, Linear, Live,
        {"How much weaker ash is across the line that the fire front has left in it: more turns "
         "cracks along the burnt boundary. Only for the rule stress.",
         "Our choice"}),
    real<&P::fracture, &FractureParams::crack_speed>(
        "fracture.crack_speed", "", unit::metre_per_second, {0.001, 1000}, {0.05, 1}, Logarithmic,
        Live, {"How fast a crack runs on. Only for the rule stress.", "Our choice"}),
    // ---- numerics ----------------------------------------------------------------------------
    integer<&P::numerics, &NumericsParams::seed>(
        "numerics.seed", "", {0, 9007199254740991.0}, {0, 1000}, Rebuild,
        {"Same preset, same seed: same burn, bit for bit.", "Our choice"}),
    real<&P::numerics, &NumericsParams::tick_rate>(
        "numerics.tick_rate", "", unit::hertz, {1, 100000}, {30, 240}, Logarithmic, Rebuild,
        {"Simulation ticks per simulated second.", "Our choice"}),
    choice<&P::numerics, &NumericsParams::integrator>(
        "numerics.integrator", kIntegrators, Live,
        {"How the lattice is moved. auto takes the cheapest that is accurate enough.",
         "Sec. 4.1 (rk4); our choice"}),
    real<&P::numerics, &NumericsParams::tolerance>(
        "numerics.tolerance", "", unit::metre, {1e-13, 0.01}, {1e-10, 1e-4}, Logarithmic, Live,
        {"Error that one sub-step of dopri5, rkf78 or rosenbrock may make.", "Our choice"}),
    real<&P::numerics, &NumericsParams::safety>(
        "numerics.safety", "", unit::one, {0.01, 10}, {0.5, 0.9}, Linear, Live,
        {"Share of the computed stability bound that a sub-step may use.", "Our choice"}),
    integer<&P::numerics, &NumericsParams::substeps_min>(
        "numerics.substeps_min", "", {1, 100000}, {1, 100}, Live,
        {"At least this many sub-steps per tick.", "Our choice"}),
    choice<&P::numerics, &NumericsParams::heat_solver>(
        "numerics.heat_solver", kHeatSolvers, Live,
        {"How heat is conducted. auto takes the cheapest for the lattice and the step.",
         "Sec. 4.2 (ftcs); our choice"}),
    choice<&P::numerics, &NumericsParams::arithmetic>(
        "numerics.arithmetic", kArithmetics, Live,
        {"exact: the same bits on every processor. fast: fused operations and estimated square "
         "roots where the processor has them; other bits, other state hash.",
         "Our choice"}),
    toggle<&P::numerics, &NumericsParams::skip>(
        "numerics.skip", Live,
        {"Leave out work that changes nothing. Off does all of it, to the same bits.",
         "Our choice"}),
    real<&P::numerics, &NumericsParams::sleep_speed>(
        "numerics.sleep_speed", "", unit::metre_per_second, {0, 1}, {0, 1e-3}, Linear, Live,
        {"Paper that has rested more slowly than this is not moved until something reaches it. "
         "0 moves everything always.",
         "Our choice"}),
    toggle<&P::numerics, &NumericsParams::check>(
        "numerics.check", Live,
        {"Watch every tick for non-finite numbers and energy from nowhere; roll back and retry.",
         "Our choice"}),
};

static_assert(row_count(kRows, "paper") == field_count<PaperParams>, "every field needs a row");
static_assert(row_count(kRows, "sheet") == field_count<SheetParams>, "every field needs a row");
static_assert(row_count(kRows, "springs") == field_count<SpringParams>, "every field needs a row");
static_assert(row_count(kRows, "plate") == field_count<PlateParams>, "every field needs a row");
static_assert(row_count(kRows, "curl") == field_count<CurlParams>, "every field needs a row");
static_assert(row_count(kRows, "world") == field_count<WorldParams>, "every field needs a row");
static_assert(row_count(kRows, "wind") == field_count<WindParams>, "every field needs a row");
static_assert(row_count(kRows, "hand") == field_count<HandParams>, "every field needs a row");
static_assert(row_count(kRows, "contact") == field_count<ContactParams>, "every field needs a row");
static_assert(row_count(kRows, "heat") == field_count<HeatParams>, "every field needs a row");
static_assert(row_count(kRows, "burning") == field_count<BurningParams>, "every field needs a row");
static_assert(row_count(kRows, "fire") == field_count<FireParams>, "every field needs a row");
static_assert(row_count(kRows, "lighter") == field_count<LighterParams>, "every field needs a row");
static_assert(row_count(kRows, "shrinkage") == field_count<ShrinkageParams>,
              "every field needs a row");
static_assert(row_count(kRows, "fracture") == field_count<FractureParams>,
              "every field needs a row");
static_assert(row_count(kRows, "numerics") == field_count<NumericsParams>,
              "every field needs a row");
static_assert(field_count<Params> == 15 + 4, "every group needs rows and an assertion above");

}  // namespace

std::span<const ParamInfo> sim_param_rows() {
    return kRows;
}

ParamBinding bind(Params& params) {
    return {kRows,
            &params,
            {{"sheets", "sheet", &params.sheets}, {"lighters", "lighter", &params.lighters}}};
}

ParamChange compare(const Params& a, const Params& b) {
    ParamChange change = a.lighters == b.lighters ? ParamChange::None : ParamChange::Live;
    if (a.sheets != b.sheets || a.masks != b.masks) return ParamChange::Rebuild;
    for (const ParamInfo& row : kRows) {
        if (row.value(&a) == row.value(&b)) continue;
        if (row.applies == Rebuild) return ParamChange::Rebuild;
        change = ParamChange::Live;
    }
    return change;
}

std::vector<std::string> plausibility_warnings(const Params& params) {
    std::vector<std::string> warnings;
    const auto warn_if = [&](bool condition, const char* text) {
        if (condition) warnings.emplace_back(text);
    };
    warn_if(params.heat.flame_limit <= params.burning.ignition,
            "heat.flame_limit is not above burning.ignition: nothing can ignite");
    warn_if(params.fire.life_max < params.fire.life_min,
            "fire.life_max is below fire.life_min: particles live between the two all the same");
    const auto loose = [](const SheetParams& sheet) {
        return sheet.held == HeldEdge::None && sheet.held_points.empty();
    };
    const std::vector<SheetParams> sheets = sheets_of(params);
    warn_if(std::all_of(sheets.begin(), sheets.end(), loose) && params.world.gravity > 0,
            "sheet.held is none: the sheet falls at once");
    warn_if((params.wind.x != 0 || params.wind.y != 0 || params.wind.z != 0) &&
                params.world.air_drag == 0,
            "world.air_drag is 0: the wind does not move the paper");
    const double held_gravity = params.world.gravity * params.world.held_gravity;
    warn_if(held_gravity / params.springs.stiffness_scale > 0.1,
            "gravity over springs.stiffness_scale is above 0.1 m/s^2: the sheet hangs like rubber; "
            "raise the scale or lower world.held_gravity");
    warn_if(params.numerics.safety > 1,
            "numerics.safety is above 1: sub-steps may be unstable and will be rolled back");
    return warnings;
}

}  // namespace ember
