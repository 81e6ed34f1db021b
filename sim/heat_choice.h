// Which way of conducting heat is the cheapest for a lattice and a step.
#pragma once

#include "sim/heat_conduction.h"
#include "sim/params.h"

namespace ember {

/// A solver and how many steps of it a tick takes.
struct HeatChoice {
    HeatSolverKind solver;  ///< never Auto
    double steps;
};

/// The solver for dt [s]: the one asked for, or for Auto the cheapest by
///
///     cost = steps × cost of a step (measured, that of FTCS being 1)
///
/// which is FTCS or ADI: RKL2 is never the cheapest. Chosen by Auto, ADI takes as many steps as
/// keep the error of the slowly varying modes (up to four half waves in each direction) below that
/// of FTCS at its limit; it may err more for modes shorter than eight half waves. Depends on
/// lattice, topology and dt only, never on the temperatures.
[[nodiscard]] HeatChoice choose_heat_solver(const Conduction& op, HeatSolverKind wanted, double dt);

}  // namespace ember
