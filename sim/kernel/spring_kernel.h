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

/// One row of springs: those anchored at the row's sites. Once the rows have been evaluated in
/// their order, those of the rows above included, every spring of the row's nodes has been.
/// Forces are rows of `pitch` elements, x, y and z; for evaluate_split then x, y and z of friction.
struct SpringRow {
    const double* x[3];         ///< [m] column 0 of the row, and of the rows one and two below
    const double* v[3];         ///< [m/s]
    std::ptrdiff_t node_count;  ///< distance between the components of x and of v
    /// [block][kind][k, k·l, d][lane]; all 0 for springs that do not exist.
    const double* constants;
    std::ptrdiff_t columns;
    /// [N] Sums of the pulls, on their upper ends, of springs that end in the row and in the two
    /// below. The first is read, the second is added to, the third is set.
    double* reaction[3];
    double* force;         ///< [N] out: of all springs on the nodes of the row
    std::ptrdiff_t pitch;  ///< padded_columns
    double* loss;  ///< [W] out: lost in damping, kBlockColumns sums over every eighth column
};

struct SpringKernel {
    void (*evaluate)(const SpringRow& row);
    /// The same forces, and what part of them is friction. Leaves the loss to those who know the
    /// motion better (mechanics.h).
    void (*evaluate_split)(const SpringRow& row);
};

/// The widest kernel that this processor runs. All exact ones compute the same bits.
[[nodiscard]] SpringKernel spring_kernel(Arithmetic arithmetic);

/// Exact kernel with the given number of lanes per instruction (2, 4, 8), or the fast one (0), if
/// this processor runs it; otherwise null functions. For tests and benchmarks.
[[nodiscard]] SpringKernel spring_kernel_of_width(int lanes);

}  // namespace ember
