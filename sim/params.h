// What a person may set, in SI, with its defaults. Ranges, units and meaning are in
// param_table.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/mask_image.h"
#include "sim/param_info.h"

namespace ember {

/// The material (sections 3 and 4.1, tables 1 and 2).
struct PaperParams {
    double grammage = 0.080;        // [kg/m^2]
    double density = 1500.0;        // [kg/m^3]
    double c_s = 2e-4;              // [1] dimensional stability
    double specific_heat = 1380.0;  // [J/(kg K)]
    double conductivity = 0.05;     // [W/(m K)]
};

enum class Border : std::uint8_t { Tributary, Uniform };
enum class SheetShape : std::uint8_t { Flat, Cylinder };
enum class SheetPose : std::uint8_t { Hanging, Horizontal };

/// Where a sheet is attached: a set of edges and corners, one bit each.
enum class HeldEdge : std::uint8_t {
    None = 0,
    MainStart = 1,
    MainEnd = 2,
    CrossStart = 4,
    CrossEnd = 8,
    CornerMainStartCrossStart = 16,
    CornerMainStartCrossEnd = 32,
    CornerMainEndCrossStart = 64,
    CornerMainEndCrossEnd = 128,
    BothMainEnds = MainStart | MainEnd,
    BothCrossEnds = CrossStart | CrossEnd
};

[[nodiscard]] constexpr HeldEdge operator|(HeldEdge a, HeldEdge b) {
    return static_cast<HeldEdge>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
[[nodiscard]] constexpr HeldEdge operator&(HeldEdge a, HeldEdge b) {
    return static_cast<HeldEdge>(static_cast<unsigned>(a) & static_cast<unsigned>(b));
}

/// Size, lattice and placement of the sheet (eq. 1).
struct SheetParams {
    double width = 0.210;   // [m] cross direction z, M cells
    double height = 0.297;  // [m] main direction x, N cells
    int rows = 32;          // M
    int columns = 48;       // N
    Border border = Border::Tributary;
    SheetShape shape = SheetShape::Flat;
    SheetPose pose = SheetPose::Hanging;
    HeldEdge held = HeldEdge::MainStart;
    std::vector<std::array<double, 3>> held_points;  // [m] along main, along cross, radius
    std::string mask;                                // file of the picture of its outline
    std::string name;                                // in messages
    double x = 0, y = 0, z = 0;                      // [m] from where its pose puts it
    double turn_x = 0, turn_y = 0, turn_z = 0;       // [rad] about its middle, in this order
    int count = 1;                                   // sheets in the stack
    double gap = 0.020;                              // [m] between stacked sheets
    double elevation = 0.450;                        // [m] of the held edge above the ground
    double imperfection = 0.0002;                    // [m] amplitude of the initial waviness
};

enum class StiffnessLaw : std::uint8_t { PerArea, PerNodeMass };
enum class VariationPattern : std::uint8_t { PerFibre, PerSpring };

/// The mass-spring lattice (section 4.1).
struct SpringParams {
    double structural = 7e3;        // [1/s^2] times node weight
    double diagonal = 7e3;          // [1/s^2]
    double bending = 2e4;           // [1/s^2]
    double damping = 5.0;           // [1/s] times node weight
    double stiffness_scale = 40.0;  // [1] multiplies the three stiffnesses
    StiffnessLaw stiffness_law = StiffnessLaw::PerArea;
    double variation = 0.10;  // [1]
    VariationPattern variation_pattern = VariationPattern::PerFibre;
    bool follows_mass = true;
};

/// Flexural rigidity: the sheet as a plate (plate.h). Without it paper bends like cloth.
struct PlateParams {
    double youngs_main = 0.0;     // [Pa] 0: no rigidity
    double youngs_cross = 0.0;    // [Pa]
    double poisson = 0.3;         // [1] geometric mean of the two
    double rigidity_main = 0.0;   // [N m] if above 0, instead of the one from Young's modulus
    double rigidity_cross = 0.0;  // [N m]
    double char_rigidity = 0.2;   // [1] share that is left at burning.residual_mass
    bool clamped = true;          // held borders keep their slope
};

/// Curl of a sheet that has flexural rigidity (curl.h).
struct CurlParams {
    double heat = 0.0;       // [1/K] strain by which the hotter half shrinks
    double charring = 0.0;   // [1] the same of the half that has charred alone
    double two_sided = 0.0;  // [1] the same of one face's half beyond the other's in full charring
    double cross_ratio = 2.0;  // [1] of the strains across and along the main direction
    double set = 0.0;          // [1] how much of its curvature charring paper keeps

    [[nodiscard]] bool any() const {
        return heat != 0 || charring != 0 || two_sided != 0 || set != 0;
    }
};

/// What pulls and drags at the sheet from outside.
struct WorldParams {
    double gravity = 9.81;              // [m/s^2] downwards
    double held_gravity = 0.12;         // [1] share of gravity that pieces still held feel
    double air_drag = 0.3;              // [kg/(m^2 s)] across the sheet
    double air_drag_tangential = 0.15;  // [1] share of it along the sheet
    bool ground = true;                 // paper rests on it at y = 0

    [[nodiscard]] double gravity_while_held() const { return gravity * held_gravity; }
};

/// What keeps paper from passing through the ground and through paper.
struct ContactParams {
    bool sheets = true;            // between sheets
    bool self = false;             // between parts of one sheet
    double thickness = 0.001;      // [m] that sheets keep apart, if the caliper is not more
    double friction = 0.4;         // [1] paper on paper
    double ground_friction = 0.6;  // [1] paper on the ground
    double interval = 0.0021;      // [s] at most, during which contact forces do not change
};

/// The air's own motion.
struct WindParams {
    double x = 0, y = 0, z = 0;  // [m/s]
    double gust = 0;             // [1] share of it that comes and goes
    double gust_period = 2;      // [s]
};

/// A hand that holds a sheet at one place and pulls (hand.h).
struct HandParams {
    bool on = false;
    std::int64_t sheet = 1;            // counted from 1
    std::int64_t row = 0, column = 0;  // site that it holds
    double x = 0, y = 0, z = 0;        // [m] where it wants it
    double radius = 0.02;              // [m] of what it holds, on the paper
    double response = 0.08;            // [s]
};

/// Heat in the sheet (section 4.2, eqs. 2 and 3).
struct HeatParams {
    double ambient = 293.15;       // [K]
    double flame_limit = 1373.15;  // [K] no source heats a node above this
    double convection = 33.0;      // [W/(m^2 K)] per face
    double emissivity = 0.0;       // [1] per face
};

/// The states of a node (section 4.2).
struct BurningParams {
    double ignition = 1041.15;    // [K] 1.5 times the particle temperature
    double burn_rate = 0.060;     // [kg/(s m^2)]
    double residual_mass = 0.2;   // [1]
    double heat_release = 1.5e4;  // [K/s] of a burning node
    double burn_speed = 1.0;      // [1]
};

/// Particles and what they give (section 4.2).
struct FireParams {
    double temperature = 785.15;       // [K] at birth, 512 degC
    double cooling_time = 0.5;         // [s]
    double life_min = 0.42;            // [s]
    double life_max = 0.70;            // [s]
    double rise_speed = 0.0;           // [m/s] at birth from a burning node
    double standoff = 0.0;             // [m] of a flame above the burning node that feeds it
    double lateral_speed = 0.08;       // [m/s] standard deviation per axis
    double buoyancy = 5.0;             // [m/s^2] at birth temperature
    double drag = 2.0;                 // [1/s]
    double kernel_radius = 0.018;      // [m]
    double heating = 6000.0;           // [K/s] per particle at its centre, for 80 g/m^2, c_s 2e-4
    double heating_time = 0.03;        // [s] after birth during which a particle heats
    double heating_limit = 2e4;        // [K/s] per node
    double grammage_exponent = 0.5;    // [1]
    double stability_exponent = 0.35;  // [1]
    double absorption = 10.0;          // [1/s] how fast a particle loses what it gives
    double emission = 7.4e5;           // [1/(s m^2)] of burning paper
    bool area_emission = false;        // from anywhere on burning paper, not only its nodes
    double node_strength = 1.0;        // [1] of particles from burning nodes
    double force = 0.001;              // [kg/(m^2 s)]
    double force_limit = 0.1;          // [m/s^2]
};

/// The lighter (section 4.2, "Lighting the Paper").
struct LighterParams {
    bool on = true;
    double x = -0.100, y = 0.133, z = 0.0;    // [m]
    double radius = 0.004;                    // [m] of its nozzle
    double rate = 250.0;                      // [1/s]
    double speed = 0.35;                      // [m/s]
    double strength = 0.5;                    // [1]
    double start = 0.0;                       // [s]
    double duration = 1.5;                    // [s]
    std::vector<std::array<double, 4>> path;  // [s], [m] keyframes: time, x, y, z
};

enum class ShrinkRule : std::uint8_t { BothBurning, Half };

/// Shrinking fibres (section 4.3, eq. 4).
struct ShrinkageParams {
    double factor = 5e-12;               // [1]
    double reference_step = 1.0 / 60.0;  // [s] the step that eq. 4 leaves out
    double floor = 0.7;                  // [1] of the initial length
    ShrinkRule rule = ShrinkRule::BothBurning;
    bool literal_stiffness = false;  // k_s of the spring's own kind
};

enum class FractureRule : std::uint8_t { Paper, Stress };

/// Cracks (section 4.4).
struct FractureParams {
    FractureRule rule = FractureRule::Paper;
    double threshold = 0.012;  // [1] elongation of a burnt bending spring
    bool middle_burnt = true;
    double relief_radius = 0.025;  // [m] around a cut ...
    double relief_time = 0.70;     // [s] ... that rests this long
    bool release_hinges = true;
    double ash_strength = 1.0;    // [1] share of its strength that old ash keeps
    double ash_time = 3.0;        // [s] in which it loses the rest
    double strength_noise = 0.0;  // [1] of strength, from place to place ...
    double noise_length = 0.010;  // [m] ... at this distance
    double grain = 0.7;           // [1] strength across the fibres, relative to along them
    double boundary = 0.2;        // [1] weakness across the line that the front has left
    double crack_speed = 0.15;    // [m/s]
};

enum class IntegratorKind : std::uint8_t {
    Auto,
    SemiImplicitEuler,
    VelocityVerlet,
    Rk4,
    Dopri5,
    Rkf78,
    AdamsBashforthMoulton,
    Rosenbrock
};
enum class HeatSolverKind : std::uint8_t { Auto, Ftcs, Rkl2, Adi };
enum class Arithmetic : std::uint8_t { Exact, Fast };

/// How the equations are solved.
struct NumericsParams {
    double tick_rate = 60.0;  // [1/s]
    IntegratorKind integrator = IntegratorKind::Auto;
    double tolerance = 1e-6;  // [m] of a sub-step, for integrators that choose their own
    double safety = 0.9;      // [1] of the stability bound
    int substeps_min = 1;
    HeatSolverKind heat_solver = HeatSolverKind::Auto;
    Arithmetic arithmetic = Arithmetic::Exact;
    bool skip = true;          // leave out work that changes nothing
    double sleep_speed = 0.0;  // [m/s] below which resting paper is not moved; 0: never
    bool check = true;         // finiteness and energy, with rollback
    std::int64_t seed = 1;
};

/// Every parameter of the simulation. Two objects with equal fields and seeds burn alike.
struct Params {
    PaperParams paper;
    SheetParams sheet;
    SpringParams springs;
    PlateParams plate;
    CurlParams curl;
    WorldParams world;
    WindParams wind;
    HandParams hand;
    ContactParams contact;
    HeatParams heat;
    BurningParams burning;
    FireParams fire;
    LighterParams lighter;
    ShrinkageParams shrinkage;
    FractureParams fracture;
    NumericsParams numerics;
    // what each sheet and each lighter says differently; empty: there is what the group describes
    std::vector<ParamOverrides> sheets, lighters;
    std::vector<std::shared_ptr<const MaskImage>> masks;  // the pictures that sheet.mask names
};

}  // namespace ember
