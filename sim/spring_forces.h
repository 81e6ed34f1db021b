// Forces of the springs (section 4.1): Hooke's law and damping along each spring.
//
//     F_a = [ k (L - l) + d (v_b - v_a)·n ] n,   F_b = -F_a,   n = (x_b - x_a)/L
//
// Whole springs are evaluated as a stencil, one dense loop per slot kind and row without any
// index list; the others through SpringNetwork::extra. Each spring is computed once and its force
// stored; nodes then gather their springs in a fixed order, so that the result does not depend on
// the number of threads.
#pragma once

#include <span>
#include <vector>

#include "sim/lattice.h"
#include "sim/parallel.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

/// Position and velocity of every node, as plain pointers to arrays of N [m], [m/s].
struct NodeMotion {
    const double *x, *y, *z, *vx, *vy, *vz;
};

/// Scratch of the force evaluation.
struct SpringForces {
    /// Force of each slot's dense spring on its end a [N]. Every kind's block is preceded by
    /// kFront zeros, because nodes of the first two columns ask for springs before them.
    std::vector<double> x, y, z;                    ///< 6×(kFront + S)
    std::vector<double> dissipated;                 ///< [J] since begin_tick(), 6×S
    std::vector<double> extra_x, extra_y, extra_z;  ///< X
    std::vector<double> extra_dissipated;           ///< X
    std::vector<double> zeros;                      ///< a row of zeros for rows that do not exist
    static constexpr std::size_t kFront = 2;
    [[nodiscard]] static std::size_t offset(const Lattice& lattice, Slot kind, Index row) {
        const auto block = kFront + static_cast<std::size_t>(lattice.site_count());
        return static_cast<std::size_t>(kind) * block + kFront +
               static_cast<std::size_t>(lattice.site(row, 0));
    }

    /// Sizes the arrays for the network and forgets the dissipation.
    void begin_tick(const Lattice& lattice, const SpringNetwork& network);
};

/// Evaluates every spring for `motion`; adds weight [s] × the power lost in damping to
/// `dissipated`. A spring of length zero has no direction and exerts no force.
void evaluate_springs(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                      const NodeMotion& motion, double weight, SpringForces& forces,
                      ThreadPool& pool);

/// Sum of the evaluated spring forces on the nodes of one lattice row (dense springs only);
/// fx, fy, fz have one entry per column and are overwritten [N].
void gather_row(const Lattice& lattice, const SpringForces& forces, Index row, double* fx,
                double* fy, double* fz);

/// Force of the extra springs on `node` [N].
[[nodiscard]] Vector3 gather_extra(const SpringNetwork& network, const SpringForces& forces,
                                   std::size_t node);

/// Elastic energy ½ Σ k (L - l)² [J].
[[nodiscard]] double elastic_energy(const Lattice& lattice, const SheetState& sheet,
                                    const SpringNetwork& network);

}  // namespace ember
