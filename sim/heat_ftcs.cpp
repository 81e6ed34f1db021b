#include <algorithm>
#include <cmath>

#include "sim/heat_row.h"
#include "sim/heat_solver.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr std::int64_t kMostInOneGo = 8;  // steps in which heat crosses at most one tile

EMBER_VECTORISED
void even_part(const HeatRow& row, double* __restrict out, Index first, Index last, double main,
               double cross) {
    for (Index c = first; c < last; ++c)
        out[c] = row.here[c] + row.even_flow(c, main, cross);
}

EMBER_VECTORISED
void uneven_part(const HeatRow& row, double* __restrict out, Index first, Index last, double h) {
    for (Index c = first; c < last; ++c)
        out[c] = row.here[c] + h * row.per_capacity[c] * row.flow(c);
}

void one_row(const Conduction& op, const HeatTiles& tiles, const double* from, double* to,
             Index row, double h) {
    const HeatRow t(op, from, row);
    double* out = to + op.row_begin(row);
    const auto end = [&](Index c, Index inner) {
        out[c] = t.here[c] + h * t.per_capacity[c] * t.end_flow(c, inner);
    };
    const auto r = static_cast<std::size_t>(row);
    for (std::size_t s = tiles.begin[r]; s < tiles.begin[r + 1]; ++s) {
        const HeatSegment& segment = tiles.segments[s];
        const Index first = std::max(1, segment.first);
        const Index last = std::min(op.column_count - 1, segment.last);
        if (segment.first == 0) end(0, 1);
        if (segment.last == op.column_count) end(last, last - 1);
        if (segment.even) {
            even_part(t, out, first, last, h * op.even_main, h * op.even_cross);
        } else {
            uneven_part(t, out, first, last, h);
        }
    }
}

// `count` steps between two fields, the last one written being the result. On a flat sheet every
// row is advanced as soon as the row after it is one step behind: a few rows stay in the cache for
// all steps. Around a seam no row is the first.
void several_steps(const Conduction& op, const HeatTiles& tiles, double* const (&field)[2],
                   double h, Index count) {
    if (op.closed) {
        for (Index k = 0; k < count; ++k) {
            for (Index row = 0; row < op.row_count; ++row)
                one_row(op, tiles, field[k % 2], field[(k + 1) % 2], row, h);
        }
        return;
    }
    for (Index front = 0; front < op.row_count + count - 1; ++front) {
        for (Index k = 0; k < count; ++k) {
            const Index row = front - k;
            if (row < 0 || row >= op.row_count) continue;
            one_row(op, tiles, field[k % 2], field[(k + 1) % 2], row, h);
        }
    }
}

}  // namespace

double explicit_steps(const Conduction& op, double h) {
    return std::max(1.0, std::ceil(h * op.most_per_capacity));
}

void ftcs(const HeatStep& step, double h, std::int64_t count) {
    HeatScratch& w = step.scratch;
    for (std::int64_t done = 0; done < count;) {
        const std::int64_t k = std::min(kMostInOneGo, count - done);
        if (done == 0 || step.skip) {
            find_warm_tiles(w.conduction, step.temperature, step.ambient, done > 0, w.tiles);
            activate_tiles(w.conduction, 1, !step.skip, w.tiles);
        }
        prepare_field(w.conduction, w.tiles, step.temperature, step.ambient, w.next);
        double* const fields[2] = {step.temperature.data(), w.next.value.data()};
        several_steps(w.conduction, w.tiles, fields, h, static_cast<Index>(k));
        if (k % 2 != 0) step.temperature.swap(w.next.value);
        step.counters.heat_nodes += k * w.tiles.nodes;
        step.counters.heat_substeps += k;
        done += k;
    }
}

}  // namespace ember
