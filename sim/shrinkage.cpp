#include "sim/shrinkage.h"

#include <algorithm>
#include <array>

#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr double kCelsiusZero = 273.15;  // [K]
constexpr Index kMostColumns = 512;      // slots of a row done at once

double spring_stiffness(Slot kind, const Params& params) {
    if (!params.shrinkage.literal_stiffness) return reference_stiffness(params.paper.grammage);
    const SpringKind spring = spring_kind(kind);
    const double per_weight = spring == SpringKind::Structural ? params.springs.structural
                              : spring == SpringKind::Diagonal ? params.springs.diagonal
                                                               : params.springs.bending;
    return reference_stiffness(params.paper.grammage, per_weight);
}

// Where the ends of a slot lie, from its anchor, as in lattice.h.
struct SlotEnds {
    Slot kind;
    Index rows_b;    // end b is in this row after the anchor's; end a is in the anchor's
    Index column_a;  // columns after the anchor's
    Index column_b;
};

constexpr SlotEnds kSlotEnds[] = {
    {Slot::Main, 0, 0, 1},   {Slot::Cross, 1, 0, 0},    {Slot::DiagDown, 1, 0, 1},
    {Slot::DiagUp, 1, 1, 0}, {Slot::BendMain, 0, 0, 2}, {Slot::BendCross, 2, 0, 0},
};

// Slots of one kind next to each other in a row. Pointers are to the first slot's data, and the
// data of its ends.
struct SlotRow {
    const double *alight_a, *alight_b;            // 1 where the end burns
    const double *temperature_a, *temperature_b;  // [K]
    const double* initial;                        // [m]
    double* rest;                                 // [m]
};

// Shrinks `count` slots: those with one burning end by the weight `one`, those with two by 1.
// Returns how many have shrunk. Slots of weight 0 keep their bits.
EMBER_VECTORISED double shrink_row(const SlotRow& row, std::ptrdiff_t count, double one,
                                   double rate, double stiffness, double least,
                                   double* __restrict weight) {
    const double* __restrict alight_a = row.alight_a, * __restrict alight_b = row.alight_b, * __restrict temperature_a = row.temperature_a, * __restrict temperature_b = row.temperature_b, * __restrict initial = row.initial;
    double* __restrict rest = row.rest;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double ends = alight_a[i] + alight_b[i];
        const double w = ends == 1.0 ? one : 0.5 * ends;  // 0, one or 1
        const double heat = temperature_a[i] + temperature_b[i] - 2.0 * kCelsiusZero;
        const double shrunk = rest[i] - w * rate * initial[i] * heat / stiffness;
        const double floor = least * initial[i];
        const double bounded = shrunk < floor ? floor : shrunk;
        const double shorter = bounded < rest[i] ? bounded : rest[i];
        rest[i] = w > 0.0 ? shorter : rest[i];
        weight[i] = w > 0.0 ? 1.0 : 0.0;
    }
    double shrunk_slots = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i)
        shrunk_slots += weight[i];
    return shrunk_slots;
}

ColumnRange join(ColumnRange a, Index offset_a, ColumnRange b, Index offset_b) {
    a = {a.first - offset_a, a.last - offset_a};
    b = {b.first - offset_b, b.last - offset_b};
    if (a.last < a.first) return b;
    if (b.last < b.first) return a;
    return {std::min(a.first, b.first), std::max(a.last, b.last)};
}

// One kind of slot, row by row.
void shrink_kind(const Lattice& lattice, const Params& params, const SlotEnds& ends, double rate,
                 const ActiveNodes& active, SheetState& sheet, StepCounters& counters) {
    const ShrinkageParams& shrinkage = params.shrinkage;
    const bool half =
        shrinkage.rule == ShrinkRule::Half || spring_kind(ends.kind) == SpringKind::Bending;
    const double stiffness = spring_stiffness(ends.kind, params) * params.paper.c_s;
    const Index columns = lattice.column_count - std::max(ends.column_a, ends.column_b);
    std::array<double, kMostColumns> weight;
    for (Index r = 0; r < lattice.row_count; ++r) {
        const Index row_b = lattice.row_at(r, ends.rows_b);
        if (row_b == kNone) break;
        ColumnRange range =
            join(active.alight_range[static_cast<std::size_t>(r)], ends.column_a,
                 active.alight_range[static_cast<std::size_t>(row_b)], ends.column_b);
        if (!params.numerics.skip) range = {0, columns - 1};
        range = {std::max(range.first, 0), std::min(range.last, columns - 1)};
        for (; range.first <= range.last; range.first += kMostColumns) {
            const Index count = std::min(range.last - range.first + 1, kMostColumns);
            const Index a = lattice.site(r, range.first + ends.column_a);
            const Index b = lattice.site(row_b, range.first + ends.column_b);
            const Index slot = lattice.slot(ends.kind, lattice.site(r, range.first));
            const SlotRow row{active.alight.data() + a,
                              active.alight.data() + b,
                              sheet.temperature.data() + a,
                              sheet.temperature.data() + b,
                              lattice.initial_length.data() + slot,
                              sheet.rest_length.data() + slot};
            counters.shrinkage_visited += count;
            counters.springs_shrunk += static_cast<std::int64_t>(shrink_row(
                row, count, half ? 0.5 : 0.0, rate, stiffness, shrinkage.floor, weight.data()));
        }
    }
}

}  // namespace

void shrink_burning_springs(const Lattice& lattice, const Params& params, double dt,
                            const ActiveNodes& active, SheetState& sheet, StepCounters& counters) {
    const ShrinkageParams& shrinkage = params.shrinkage;
    // nothing has burnt yet, or nothing burns now: there is no slot to shrink
    if (!(shrinkage.factor > 0) || active.alight.empty()) return;
    if (active.burning.empty() && params.numerics.skip) return;
    const double rate = dt / shrinkage.reference_step * shrinkage.factor;
    for (const SlotEnds& ends : kSlotEnds)
        shrink_kind(lattice, params, ends, rate, active, sheet, counters);
}

}  // namespace ember
