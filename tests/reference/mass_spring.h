// The paper's mass-spring sheet (section 4.1) written as plainly as it can be: nodes as structures,
// springs as a list of edges, forces scattered spring by spring, the classical Runge-Kutta method.
// It shares no code with the simulation, whose forces and steps are compared with it; only the
// data of Params, Lattice and SheetState.
#pragma once

#include <vector>

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/world_state.h"

namespace ember::reference {

struct Node {
    Vector3 position, velocity;  ///< [m], [m/s]
    Vector3 load;                ///< [N] gravity
    Vector3 normal;              ///< [1] of the sheet; 0 where it has no area
    double mass = 0;             ///< [kg]
    double drag = 0;             ///< [kg/s] across the sheet
    bool held = false;
};

struct Spring {
    Index a, b;                       ///< nodes
    double stiffness, damping, rest;  ///< [N/m], [kg/s], [m]
};

struct MassSpringSheet {
    std::vector<Node> nodes;
    std::vector<Spring> springs;
    double drag_tangential = 0;  ///< [1] share of the drag along the sheet
};

/// The sheet as it is now: masses, burnt springs, cuts, loads.
[[nodiscard]] MassSpringSheet make_mass_springs(const Lattice& lattice, const SheetState& sheet,
                                                const Params& params);

/// Accelerations of all nodes [m/s²], N: springs F_a = [k (L - l) + d (v_b - v_a)·n] n along
/// n = (x_b - x_a)/L, drag -c [(v·n) n + τ (v - (v·n) n)], gravity. Held nodes have none.
void accelerations(const MassSpringSheet& sheet, std::vector<Vector3>& result);

/// One step of the classical Runge-Kutta method over `h` [s]; normals and loads stay.
void step_runge_kutta(MassSpringSheet& sheet, double h);

}  // namespace ember::reference
