// Forces of the springs (section 4.1): Hooke's law and damping along each spring.
//
//     F_a = [ k (L - l) + d (v_b - v_a)·n ] n,   F_b = -F_a,   n = (x_b - x_a)/L
//
// Whole springs are evaluated as a stencil without any index list, a row of the lattice at a time
// (kernel/spring_kernel.h), adding to the forces on the row's nodes and on those of the two rows
// below, always in the same order. Springs at cuts go through lists (ExtraSprings).
// Hence the result does not depend on the number of threads.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/aligned_array.h"
#include "sim/kernel/spring_kernel.h"
#include "sim/lattice.h"
#include "sim/parallel.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

class OldRows;

/// Positions and velocities of N nodes: all x components, then all y, all z; kMotionPadding more
/// elements can be read after each.
struct NodeMotion {
    const double* x;         ///< [m], 3N
    const double* v;         ///< [m/s], 3N
    std::size_t node_count;  ///< N
};

/// Springs that do not connect two first copies, as arrays over the list SpringNetwork::extra.
struct ExtraSprings {
    std::vector<Index> a, b;                          ///< nodes, X
    std::vector<double> stiffness, tension, damping;  ///< k [N/m], k·l [N], d [kg/s], X
    std::array<std::vector<double>, 6> pull;          ///< [N] on end a, and its friction, X each
    std::vector<double> loss;                         ///< [W], X
    std::vector<double> total;                        ///< [N] on nodes, and friction, as SpringRow;
                                                      ///< 6N, 0 at nodes without such springs

    std::vector<std::uint8_t> in_row;  ///< whether a row's sites have any, R

    /// Sets the constants and sizes everything for N nodes.
    void prepare(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network);
    /// Evaluates all springs into `total`; returns the power lost [W].
    double evaluate(const SpringNetwork& network, const NodeMotion& motion);
};

/// Scratch of the force evaluation; prepare() once per tick.
struct SpringForces {
    AlignedArray constants;               ///< packed as SpringRow::constants, row after row
    std::vector<AlignedArray> rings;      ///< one per thread: reactions on 3 rows, forces on one
    std::vector<AlignedArray> finishing;  ///< one per thread: 4 rows of `pitch`

    std::vector<double> row_damping, row_drag;  ///< [W] lost in each row
    ExtraSprings extra;
    std::ptrdiff_t pitch = 0;  ///< of the force rows

    /// Packs the network's constants for the sheet's present rest lengths.
    void prepare(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                 ThreadPool& pool);
};

/// Sums of spring forces along a span of rows, one row at a time from the first to the last.
class RowForces {
  public:
    /// With `old`, rows may be moved as soon as they are done, and forces are split.
    RowForces(const Lattice& lattice, const NodeMotion& motion, const OldRows* old,
              const SpringKernel& kernel, SpringForces& forces, int thread);
    /// Evaluates the rows above `row` whose springs end in it. Call before next(row).
    void start(Index row);
    /// Evaluates the springs anchored at `row`, which completes the forces on its nodes; rows must
    /// follow each other. The damping of the row's springs goes to SpringForces::row_damping.
    void next(Index row);
    /// Forces on the nodes of the last row, as SpringRow::force [N]. May be changed.
    [[nodiscard]] double* force() { return force_; }

  private:
    void evaluate(Index row);
    [[nodiscard]] double* kept(Index row);

    const Lattice& lattice_;
    const NodeMotion& motion_;
    const OldRows* old_;
    const SpringKernel& kernel_;
    SpringForces& forces_;
    double *ring_, *force_;
    std::array<double, kBlockColumns> loss_{};
};

/// Σ of `count` numbers in a fixed order that vectorises: eight sums of every eighth, then theirs.
[[nodiscard]] double sum_in_lanes(const double* values, std::ptrdiff_t count);

}  // namespace ember
