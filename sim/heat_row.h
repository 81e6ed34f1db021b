// One row of the five-point sums that the explicit heat solvers share.
#pragma once

#include <algorithm>

#include "sim/heat_conduction.h"

namespace ember {

/// A row of temperatures [K] and its neighbours, and the conductances [W/K] of its edges, each by
/// column; the heat that flows into a column, for loops that the compiler vectorises.
struct HeatRow {
    const double *above, *here, *below;
    const double *main, *cross_above, *cross_below;
    const double* per_capacity;  ///< [K/J]

    HeatRow(const Conduction& op, const double* temperature, Index row)
        : above(temperature + op.row_begin(op.row_above(row))),
          here(temperature + op.row_begin(row)),
          below(temperature + op.row_begin(op.row_below(row))),
          main(&op.main[op.row_begin(row)]),
          cross_above(op.cross_above(row)),
          cross_below(&op.cross[op.row_begin(row)]),
          per_capacity(&op.per_capacity[op.row_begin(row)]) {}

    /// Σ g (T_j - T) of an inner column when g is `along` in the row and `across` beside it.
    [[nodiscard]] double even_flow(Index c, double along, double across) const {
        const double x = here[c];
        return along * ((here[c - 1] - x) + (here[c + 1] - x)) +
               across * ((above[c] - x) + (below[c] - x));
    }
    /// Σ g (T_j - T) of an inner column [W].
    [[nodiscard]] double flow(Index c) const {
        const double x = here[c];
        const double along = main[c - 1] * (here[c - 1] - x) + main[c] * (here[c + 1] - x);
        return along + (cross_above[c] * (above[c] - x) + cross_below[c] * (below[c] - x));
    }
    /// Σ g (T_j - T) of the first or last column, whose only neighbour in the row is `inner` [W].
    [[nodiscard]] double end_flow(Index c, Index inner) const {
        const double x = here[c];
        const double along = main[std::min(c, inner)] * (here[inner] - x);
        return along + (cross_above[c] * (above[c] - x) + cross_below[c] * (below[c] - x));
    }
};

}  // namespace ember
