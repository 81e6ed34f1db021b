// Skipping: the solvers below work on u = T - ambient, and a tridiagonal system without a
// right-hand side has the exact solution 0, so a strip of rows that is cold, and has cold
// neighbours, is left out. A warm row is warm along its whole length after its solve, by tails that
// fall exponentially; below kNothing they could not change the last bit of any temperature and are
// dropped, with skipping or without, so that the columns that only they reach are cold too.
#include <algorithm>
#include <cmath>

#include "sim/heat_solver.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr Index kStripRows = 32, kStripColumns = 64;
constexpr double kNothing = 1e-20;  // [K]
static_assert(kStripRows % kTileRows == 0);

// One step: what is explicit in the first half, and how much of the step each solve takes.
struct Scheme {
    double k;            // [s] of each tridiagonal solve
    bool explicit_half;  // Peaceman-Rachford; else backward Euler, one direction after the other
};

// u + k B u of one row, B the conduction across rows; range of the temperatures.
EMBER_VECTORISED
void explicit_row(const double* above, const double* here, const double* below,
                  const double* g_above, const double* g_below, const double* per_capacity,
                  double* __restrict out, Index count, double ambient, double k) {
    for (Index c = 0; c < count; ++c) {
        const double x = here[c];
        const double across = g_above[c] * (above[c] - x) + g_below[c] * (below[c] - x);
        out[c] = (x - ambient) + k * per_capacity[c] * across;
    }
}

// The second half's right-hand side. As x - k A x = r, the explicit x + k A x is 2 x - r.
EMBER_VECTORISED
void second_side(const double* __restrict x, const double* __restrict r, double* __restrict out,
                 double* __restrict largest, Index count, double solved, double known) {
    for (Index c = 0; c < count; ++c) {
        const double u = solved * x[c] - known * r[c];
        const double size = std::fabs(u);
        out[c] = size < kNothing ? 0.0 : u;
        largest[c] = size > largest[c] ? size : largest[c];
    }
}

EMBER_VECTORISED
void add_ambient(double* __restrict u, Index count, double ambient) {
    for (Index c = 0; c < count; ++c)
        u[c] = ambient + u[c];
}

// to(c, r) = from(r, c), by blocks that fit into a few cache lines on both sides.
EMBER_VECTORISED
void transpose(const double* from, Index rows, Index columns, double* __restrict to) {
    constexpr Index kSide = 8;
    for (Index r0 = 0; r0 < rows; r0 += kSide) {
        const Index r1 = std::min(rows, r0 + kSide);
        for (Index c0 = 0; c0 < columns; c0 += kSide) {
            const Index c1 = std::min(columns, c0 + kSide);
            for (Index c = c0; c < c1; ++c) {
                for (Index r = r0; r < r1; ++r)
                    to[c * rows + r] = from[r * columns + c];
            }
        }
    }
}

void prepare(const Conduction& op, double k, AdiScratch& w) {
    if (w.k == k && w.topology_version == op.topology_version &&
        w.largest.size() == static_cast<std::size_t>(op.column_count)) {
        return;
    }
    w.k = k;
    w.topology_version = op.topology_version;
    if (op.model_row != kNone) factor_rows(op, op.model_row, 1, k, w.model_row);
    if (op.model_column != kNone) factor_columns(op, op.model_column, 1, k, w.model_column);
    const auto columns = static_cast<std::size_t>(op.column_count);
    w.explicit_part.resize(columns * kStripRows);
    w.lanes.resize(columns * kStripRows);
    w.largest.resize(columns);
    w.solved.resize(columns * kStripRows);
}

bool all_set(const std::vector<std::uint8_t>& flags, Index first, Index count) {
    const auto begin = flags.begin() + first;
    return std::find(begin, begin + count, 0) == begin + count;
}

// First half for rows first..first+width-1: `out` becomes the right-hand side of the second.
void solve_rows(const HeatStep& step, const Scheme& scheme, Index first, Index width, double* out) {
    const Conduction& op = step.scratch.conduction;
    AdiScratch& w = step.scratch.adi;
    const Index count = op.column_count;
    const double* t = step.temperature.data();
    for (Index j = 0; j < width; ++j) {
        const Index row = first + j;
        const std::size_t at = op.row_begin(row);
        explicit_row(t + op.row_begin(op.row_above(row)), t + at,
                     t + op.row_begin(op.row_below(row)), op.cross_above(row), &op.cross[at],
                     &op.per_capacity[at], &w.explicit_part[op.row_begin(j)], count, step.ambient,
                     scheme.explicit_half ? scheme.k : 0.0);
    }
    transpose(w.explicit_part.data(), width, count, w.lanes.data());
    const bool as_model = all_set(op.row_as_model, first, width);
    if (!as_model) factor_rows(op, first, width, scheme.k, w.own_rows);
    solve_lines(as_model ? w.model_row : w.own_rows, w.lanes.data(),
                static_cast<std::size_t>(width), width);
    const double solved = scheme.explicit_half ? 2.0 : 1.0;
    const double known = scheme.explicit_half ? 1.0 : 0.0;
    transpose(w.lanes.data(), count, width, w.solved.data());
    for (Index j = 0; j < width; ++j) {
        second_side(&w.solved[op.row_begin(j)], &w.explicit_part[op.row_begin(j)],
                    out + op.row_begin(first + j), w.largest.data(), count, solved, known);
    }
}

// Second half for columns first..first+width-1, in place; u becomes T.
void solve_columns(const HeatStep& step, const Scheme& scheme, Index first, Index width,
                   double* out) {
    const Conduction& op = step.scratch.conduction;
    AdiScratch& w = step.scratch.adi;
    const bool as_model = all_set(op.column_as_model, first, width);
    if (!as_model) factor_columns(op, first, width, scheme.k, w.own_columns);
    solve_lines(as_model ? w.model_column : w.own_columns, out + first,
                static_cast<std::size_t>(op.column_count), width);
}

// Whether rows first..first+width-1 or their neighbours hold heat.
bool strip_is_warm(const Conduction& op, const AdiScratch& w, Index first, Index width) {
    const Index last = first + width - 1;
    const auto warm = [&w](Index row) {
        return w.warm_rows[static_cast<std::size_t>(row / kTileRows)] != 0;
    };
    bool any = warm(op.row_above(first)) || warm(op.row_below(last));
    for (Index row = first; row <= last; row += kTileRows)
        any = any || warm(row);
    return any;
}

void find_warm_rows(HeatTiles& tiles, bool all, AdiScratch& w) {
    w.warm_rows.assign(static_cast<std::size_t>(tiles.row_count), all ? 1 : 0);
    for (std::size_t tile = 0; tile < tiles.warm.size(); ++tile) {
        if (tiles.warm[tile] == 0) continue;
        w.warm_rows[tile / static_cast<std::size_t>(tiles.column_count)] = 1;
    }
}

// Both halves; the result is in scratch.next.
void take(const HeatStep& step, const Scheme& scheme) {
    HeatScratch& w = step.scratch;
    const Conduction& op = w.conduction;
    double* out = w.next.value.data();
    prepare(op, scheme.k, w.adi);
    find_warm_rows(w.tiles, !step.skip, w.adi);
    std::fill(w.adi.largest.begin(), w.adi.largest.end(), 0.0);
    const Index rows = op.row_count, columns = op.column_count;
    for (Index first = 0; first < rows; first += kStripRows) {
        const Index width = std::min(kStripRows, rows - first);
        if (strip_is_warm(op, w.adi, first, width)) {
            solve_rows(step, scheme, first, width, out);
            step.counters.heat_nodes += std::int64_t{width} * columns;
        } else {
            std::fill_n(out + op.row_begin(first), op.row_begin(width), 0.0);
        }
    }
    for (Index first = 0; first < columns; first += kStripColumns) {
        const Index width = std::min(kStripColumns, columns - first);
        const double* largest = w.adi.largest.data() + first;
        if (step.skip && *std::max_element(largest, largest + width) < kNothing) continue;
        solve_columns(step, scheme, first, width, out);
        step.counters.heat_nodes += std::int64_t{width} * rows;
    }
    add_ambient(out, op.row_count * op.column_count, step.ambient);
    ++step.counters.heat_substeps;
}

// Looks for heat and makes the field for the result; every tile may be written.
void begin(const HeatStep& step) {
    HeatScratch& w = step.scratch;
    find_warm_tiles(w.conduction, step.temperature, step.ambient, false, w.tiles);
    activate_tiles(w.conduction, 0, true, w.tiles);
    prepare_field(w.conduction, w.tiles, step.temperature, step.ambient, w.next);
}

}  // namespace

void adi(const HeatStep& step, double h) {
    HeatScratch& w = step.scratch;
    begin(step);
    take(step, {0.5 * h, true});
    const HeatRange before = range_of(w.conduction, w.tiles, step.temperature, step.ambient);
    const HeatRange after = range_of(w.conduction, w.tiles, w.next.value, step.ambient);
    if (before.left_by(after)) {
        ++step.counters.heat_guarded;
        monotone_step(step, h);
        return;
    }
    step.temperature.swap(w.next.value);
}

void implicit_euler(const HeatStep& step, double h) {
    begin(step);
    take(step, {h, false});
    step.temperature.swap(step.scratch.next.value);
}

void monotone_step(const HeatStep& step, double h) {
    constexpr double kMostExplicit = 64;
    const double needed = explicit_steps(step.scratch.conduction, h);
    if (needed <= kMostExplicit) {
        ftcs(step, h / needed, static_cast<std::int64_t>(needed));
    } else {
        implicit_euler(step, h);
    }
}

}  // namespace ember
