// The innermost loops of the spring forces, for one row of the lattice, compiled once for every
// instruction set worth having (spring_kernel_*.cpp).
//
// They are written with explicit vectors instead of being left to the compiler because one pass
// over a row then evaluates all six kinds of springs, loading each node once.
#pragma once

#include <cstddef>

#include "sim/params.h"

namespace ember {

inline constexpr std::ptrdiff_t kBlockColumns = 8;  ///< columns of a block
inline constexpr std::ptrdiff_t kKinds = 6;         ///< spring slots of a site, see lattice.h
inline constexpr std::ptrdiff_t kConstants = 3;     ///< k [N/m], k·l [N], d [kg/s] of a spring
/// Readable elements that must follow an array of positions or velocities: the last block of the
/// last row reaches as far.
inline constexpr std::size_t kMotionPadding = 16;

/// Columns rounded up to whole blocks.
[[nodiscard]] constexpr std::ptrdiff_t padded_columns(std::ptrdiff_t columns) {
    return (columns + kBlockColumns - 1) / kBlockColumns * kBlockColumns;
}

/// One row of springs: those anchored at the row's sites.
struct SpringRow {
    const double* x[3];         ///< [m] column 0 of the row, and of the rows one and two below
    const double* v[3];         ///< [m/s]
    std::ptrdiff_t node_count;  ///< distance between the components of x and of v
    /// [block][kind][k, k·l, d][lane]; all 0 for springs that do not exist.
    const double* constants;
    std::ptrdiff_t columns;
    double* force;  ///< [N] on end a: [kind][component] rows of `pitch`
    std::ptrdiff_t
        pitch;     ///< padded_columns + kBlockColumns; the kBlockColumns before each row are 0
    double* loss;  ///< [W] lost in damping by the springs of each column
    // for evaluate_drift only
    const double* drift[3] = {};  ///< [m/s] velocity of the last drift, as v
    double* friction = nullptr;   ///< [N] of the last evaluation, and then of this one:
                                  ///< [block][kind][lane]
};

/// Forces of the springs of three rows, as SpringRow::force: a node's own row and those above.
struct ForceRows {
    const double *own, *above, *two_above;
    std::ptrdiff_t pitch, columns;
    double* total;  ///< [N] on the nodes of the own row: 3 rows of `pitch`
};

struct SpringKernel {
    void (*evaluate)(const SpringRow& row);
    /// The same forces. The loss is the work that the friction, averaged over this evaluation and
    /// the one before, did on the drift between them: the exact loss of a leapfrog step.
    void (*evaluate_drift)(const SpringRow& row);
    void (*gather)(const ForceRows& rows);
};

/// The widest kernel that this processor runs. All exact ones compute the same bits.
[[nodiscard]] SpringKernel spring_kernel(Arithmetic arithmetic);

/// Exact kernel with the given number of lanes per instruction (2, 4, 8), or the fast one (0), if
/// this processor runs it; otherwise null functions. For tests and benchmarks.
[[nodiscard]] SpringKernel spring_kernel_of_width(int lanes);

}  // namespace ember
