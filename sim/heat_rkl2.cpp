#include <algorithm>
#include <cmath>

#include "sim/heat_row.h"
#include "sim/heat_solver.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// Weights of stage j: Y_j = Y_0 + mu (Y_{j-1} - Y_0) + nu (Y_{j-2} - Y_0)
//                           + slope L(Y_{j-1}) + slope_0 L(Y_0), eqs. 16 and 17 of the source.
struct StageWeights {
    double mu, nu, slope, slope_0;
};

double b(std::int64_t j) {
    const auto x = static_cast<double>(j);
    return j < 2 ? 1.0 / 3.0 : (x * x + x - 2.0) / (2.0 * x * (x + 1.0));
}

StageWeights weights(std::int64_t j, std::int64_t stages, double h) {
    const auto s = static_cast<double>(stages), x = static_cast<double>(j);
    const double w1 = 4.0 / (s * s + s - 2.0);
    if (j == 1) return {0, 0, 0, b(1) * w1 * h};
    const double mu = (2.0 * x - 1.0) / x * b(j) / b(j - 1);
    const double nu = -(x - 1.0) / x * b(j) / b(j - 2);
    return {mu, nu, mu * w1 * h, -(1.0 - b(j - 1)) * mu * w1 * h};
}

// dT/dt of one row, columns first..last-1, none of them at an end.
EMBER_VECTORISED
void even_rate(const HeatRow& row, double* __restrict out, Index first, Index last, double main,
               double cross) {
    for (Index c = first; c < last; ++c)
        out[c] = row.even_flow(c, main, cross);
}

EMBER_VECTORISED
void uneven_rate(const HeatRow& row, double* __restrict out, Index first, Index last) {
    for (Index c = first; c < last; ++c)
        out[c] = row.per_capacity[c] * row.flow(c);
}

void rate_of_segment(const Conduction& op, const double* from, Index row,
                     const HeatSegment& segment, double* out) {
    const HeatRow t(op, from, row);
    const auto end = [&](Index c, Index inner) {
        out[c] = t.per_capacity[c] * t.end_flow(c, inner);
    };
    const Index first = std::max(1, segment.first);
    const Index last = std::min(op.column_count - 1, segment.last);
    if (segment.first == 0) end(0, 1);
    if (segment.last == op.column_count) end(last, last - 1);
    if (segment.even) {
        even_rate(t, out, first, last, op.even_main, op.even_cross);
    } else {
        uneven_rate(t, out, first, last);
    }
}

EMBER_VECTORISED
void first_stage(const double* start, const double* rate, double* __restrict out, Index first,
                 Index last, double slope) {
    for (Index c = first; c < last; ++c)
        out[c] = start[c] + slope * rate[c];
}

// Overwrites Y_{j-2} by Y_j.
EMBER_VECTORISED
void later_stage(const double* start, const double* before, const double* rate_0,
                 const double* rate, double* __restrict out, Index first, Index last,
                 const StageWeights& w) {
    for (Index c = first; c < last; ++c) {
        const double known = w.mu * (before[c] - start[c]) + w.nu * (out[c] - start[c]);
        out[c] = start[c] + (known + (w.slope * rate[c] + w.slope_0 * rate_0[c]));
    }
}

template <class Visitor>
void for_each_segment(const Conduction& op, const HeatTiles& tiles, Visitor&& visit) {
    for (Index row = 0; row < op.row_count; ++row) {
        const auto r = static_cast<std::size_t>(row);
        for (std::size_t s = tiles.begin[r]; s < tiles.begin[r + 1]; ++s)
            visit(row, op.row_begin(row), tiles.segments[s]);
    }
}

// All stages; returns the field that holds the last one.
HeatField& stages_of(const HeatStep& step, std::int64_t stages, double h) {
    HeatScratch& w = step.scratch;
    const Conduction& op = w.conduction;
    const double* start = step.temperature.data();
    double* rate_0 = w.slope.value.data();
    HeatField* before = &w.next;
    HeatField* now = &w.stage;
    const StageWeights one = weights(1, stages, h);
    for_each_segment(op, w.tiles, [&](Index row, std::size_t at, const HeatSegment& s) {
        rate_of_segment(op, start, row, s, rate_0 + at);
        first_stage(start + at, rate_0 + at, now->value.data() + at, s.first, s.last, one.slope_0);
        std::copy_n(start + at + s.first, s.last - s.first, before->value.data() + at + s.first);
    });
    w.row_rate.resize(static_cast<std::size_t>(op.column_count));
    for (std::int64_t j = 2; j <= stages; ++j) {
        std::swap(before, now);  // now holds Y_{j-2}, before Y_{j-1}
        const StageWeights weight = weights(j, stages, h);
        for_each_segment(op, w.tiles, [&](Index row, std::size_t at, const HeatSegment& s) {
            rate_of_segment(op, before->value.data(), row, s, w.row_rate.data());
            later_stage(start + at, before->value.data() + at, rate_0 + at, w.row_rate.data(),
                        now->value.data() + at, s.first, s.last, weight);
        });
    }
    return *now;
}

}  // namespace

std::int64_t rkl2_stages(double explicit_steps) {
    const auto least =
        static_cast<std::int64_t>(std::ceil(0.5 * (std::sqrt(9.0 + 16.0 * explicit_steps) - 1.0)));
    return std::max<std::int64_t>(3, least + (least % 2 == 0 ? 1 : 0));
}

void rkl2(const HeatStep& step, double h) {
    HeatScratch& w = step.scratch;
    const Conduction& op = w.conduction;
    const std::int64_t stages = rkl2_stages(h * op.most_per_capacity);
    find_warm_tiles(op, step.temperature, step.ambient, false, w.tiles);
    const auto rings = static_cast<Index>((stages + kTileRows - 1) / kTileRows);
    activate_tiles(op, rings, !step.skip, w.tiles);
    for (HeatField* field : {&w.next, &w.stage, &w.slope})
        prepare_field(op, w.tiles, step.temperature, step.ambient, *field);
    HeatField& result = stages_of(step, stages, h);
    step.counters.heat_substeps += stages;
    step.counters.heat_nodes += stages * w.tiles.nodes;
    const HeatRange before = range_of(op, w.tiles, step.temperature, step.ambient);
    const HeatRange after = range_of(op, w.tiles, result.value, step.ambient);
    if (before.left_by(after)) {
        ++step.counters.heat_guarded;
        monotone_step(step, h);
        return;
    }
    step.temperature.swap(result.value);
}

}  // namespace ember
