// Forces and energy of a plate (plate.h), the product of its stiffness matrix with any vector, and
// what it adds to the bounds that solvers need.
//
// The forces are the exact gradient of the energy, the turning of the normal included, so that they
// conserve linear and angular momentum. They are computed in two passes: moments of every element,
// then their second differences at every node, each row writing only its own. Elements that are
// listed come first, one after the other. So the result does not depend on the number of threads.
#pragma once

#include <vector>

#include "sim/parallel.h"
#include "sim/plate.h"

namespace ember {

/// Three components of S entries each, with a zero before and behind all: x, then y, then z.
struct MomentArray {
    std::vector<double> values;
    std::ptrdiff_t pitch = 0;

    /// Sets all to 0 if the number of sites has changed.
    void resize(Index sites);
    [[nodiscard]] double* component(int axis) { return values.data() + axis * pitch + 1; }
};

/// Scratch of the force evaluation.
struct PlateForces {
    std::vector<double> total;          ///< [N] on the nodes, 3N: the result
    MomentArray main, cross, twist;     ///< [N] energy's derivatives by the second differences
    MomentArray turn_main, turn_cross;  ///< [N] .. by the edges east - west and south - north
    MomentArray turn_down, turn_up;     ///< [N] .. by the diagonals of a cell
    std::vector<double> zeros;          ///< S, a row that is not there

    /// Forces on N nodes at x [m], 3N, all x components, then y, then z.
    void evaluate(const Lattice& lattice, const Plate& plate, const RestCurvature& rest,
                  const double* x, std::size_t nodes, ThreadPool& pool);
    /// total = -K p for the stiffness matrix K of a sheet without rest curvature, which is positive
    /// semi-definite and does not depend on the positions.
    void evaluate_linear(const Lattice& lattice, const Plate& plate, const double* p,
                         std::size_t nodes, ThreadPool& pool);

  private:
    void run(const Lattice& lattice, const Plate& plate, const RestCurvature* rest, const double* x,
             std::size_t nodes, ThreadPool& pool);
};

/// Bending energy of the sheet [J]. The same bits for any number of threads.
[[nodiscard]] double plate_energy(const Lattice& lattice, const Plate& plate,
                                  const SheetState& sheet);

/// Adds the diagonal of K to each of N nodes [N/m], the same for all three components.
void add_plate_diagonal(const Lattice& lattice, const Plate& plate, std::vector<double>& diagonal);

/// Adds to every node what the plate contributes to the bound of stability.h [N/m kg^-1/2]: for
/// energies ½ k |Σ c_j u_j|², k |c_i| Σ_j |c_j|/√m_j at node i, where √(1/m) is `root`; the turning
/// of the normal at the present positions included.
void add_plate_bound(const Lattice& lattice, const Plate& plate, const SheetState& sheet,
                     const std::vector<double>& root, std::vector<double>& bound);

}  // namespace ember
