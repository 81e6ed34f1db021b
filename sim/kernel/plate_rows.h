// Loops over the elements of a plate that are anchored in one row of the lattice: moments, then
// forces. Included by plate_forces.cpp alone.
#pragma once

#include <array>
#include <cstddef>

#include "sim/kernel/plate_law.h"
#include "sim/plate_forces.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

using plate::Bent;
using plate::Moments;
using plate::Stiffness;
using plate::Triple;
using plate::Twist;

using Pointers = std::array<double*, 3>;
using ConstPointers = std::array<const double*, 3>;

Pointers row_of(MomentArray& array, std::ptrdiff_t first) {
    return {array.component(0) + first, array.component(1) + first, array.component(2) + first};
}

EMBER_INLINE Triple load(const ConstPointers& p, std::ptrdiff_t i) {
    return {p[0][i], p[1][i], p[2][i]};
}
EMBER_INLINE void store(const Pointers& p, std::ptrdiff_t i, const Triple& t) {
    p[0][i] = t.x, p[1][i] = t.y, p[2][i] = t.z;
}

// Dense elements of a row without rest curvature, one component at a time. Pointers are to the
// first column of the row, and of those above and below.
EMBER_VECTORISED void flat_row(std::ptrdiff_t columns, const Stiffness k, const double* left,
                               const double* x, const double* above, const double* below,
                               double* __restrict main, double* __restrict cross) {
    for (std::ptrdiff_t i = 1; i < columns - 1; ++i) {
        const double along = x[i - 1] - 2.0 * x[i] + x[i + 1];
        const double across = above[i] - 2.0 * x[i] + below[i];
        main[i] = left[i] * (k.main * along + k.coupling * across);
        cross[i] = left[i] * (k.coupling * along + k.cross * across);
    }
}

EMBER_VECTORISED void flat_cells(std::ptrdiff_t columns, double k, const double* left,
                                 const double* x, const double* below, double* __restrict twist) {
    for (std::ptrdiff_t i = 0; i < columns - 1; ++i)
        twist[i] = left[i] * k * (x[i] - x[i + 1] + below[i + 1] - below[i]);
}

// Where a row's numbers are.
struct RowPointers {
    ConstPointers x, above, below;
    const double *left, *cell_left;                     // [1]
    const double *bent_main, *bent_cross, *bent_twist;  // [1/m]
    Pointers main, cross, twist, turn_main, turn_cross, turn_down, turn_up;
};

EMBER_VECTORISED void curved_row(std::ptrdiff_t columns, const Stiffness k, const Bent unit,
                                 const RowPointers row) {
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 1; i < columns - 1; ++i) {
        const double left = row.left[i];
        const Moments m =
            plate::moments_of({left * k.main, left * k.coupling, left * k.cross},
                              {load(row.x, i), load(row.x, i - 1), load(row.x, i + 1),
                               load(row.above, i), load(row.below, i)},
                              {unit.main * row.bent_main[i], unit.cross * row.bent_cross[i], 0.0});
        store(row.main, i, m.main);
        store(row.cross, i, m.cross);
        store(row.turn_main, i, m.turn.u);
        store(row.turn_cross, i, m.turn.w);
    }
}

EMBER_VECTORISED void curved_cells(std::ptrdiff_t columns, double k, double unit,
                                   const RowPointers row) {
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < columns - 1; ++i) {
        const Twist t =
            plate::twist_of(row.cell_left[i] * k, load(row.x, i), load(row.x, i + 1),
                            load(row.below, i + 1), load(row.below, i), unit * row.bent_twist[i]);
        store(row.twist, i, t.moment);
        store(row.turn_down, i, t.turn.u);
        store(row.turn_up, i, t.turn.w);
    }
}

// f -= what the elements of a node's own row and of the two beside it exert.
EMBER_VECTORISED void gather_row(std::ptrdiff_t columns, const double* main, const double* above,
                                 const double* cross, const double* below,
                                 const double* twist_above, const double* twist,
                                 double* __restrict f) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
        f[i] -= (main[i - 1] - 2.0 * main[i] + main[i + 1]) +
                (above[i] - 2.0 * cross[i] + below[i]) +
                (twist[i] - twist[i - 1] - twist_above[i] + twist_above[i - 1]);
    }
}

EMBER_VECTORISED void gather_turns(std::ptrdiff_t columns, const double* main, const double* above,
                                   const double* below, const double* down_above,
                                   const double* down, const double* up_above, const double* up,
                                   double* __restrict f) {
    for (std::ptrdiff_t i = 0; i < columns; ++i) {
        f[i] += (main[i - 1] - main[i + 1]) + (above[i] - below[i]) +
                (down_above[i - 1] - down[i]) + (up_above[i] - up[i - 1]);
    }
}

}  // namespace
}  // namespace ember
