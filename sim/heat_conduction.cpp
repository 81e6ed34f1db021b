#include "sim/heat_conduction.h"

#include <algorithm>

#include "sim/heat_tiles.h"

namespace ember {
namespace {

void fill_edges(const Lattice& lattice, const SpringNetwork& network, Slot kind, double whole,
                std::vector<double>& conductance) {
    const auto first = static_cast<std::size_t>(lattice.slot(kind, 0));
    for (std::size_t i = 0; i < conductance.size(); ++i)
        conductance[i] = whole * network.weight[first + i];
}

void find_limits(Conduction& op) {
    op.most_per_capacity = op.most_main = op.most_cross = 0;
    for (Index row = 0; row < op.row_count; ++row) {
        const std::size_t at = op.row_begin(row);
        const double* above = op.cross_above(row);
        for (Index c = 0; c < op.column_count; ++c) {
            const auto column = static_cast<std::size_t>(c);
            const std::size_t i = at + column;
            const double main = op.main[i] + (c > 0 ? op.main[i - 1] : 0.0);
            const double cross = op.cross[i] + above[column];
            op.most_main = std::max(op.most_main, main * op.per_capacity[i]);
            op.most_cross = std::max(op.most_cross, cross * op.per_capacity[i]);
            op.most_per_capacity =
                std::max(op.most_per_capacity, (main + cross) * op.per_capacity[i]);
        }
    }
}

// g/C of all four edges of an inner site, in the order left, right, above, below.
std::array<double, 4> rates_at(const Conduction& op, Index row, Index c) {
    const std::size_t i = op.row_begin(row) + static_cast<std::size_t>(c);
    const double left = c > 0 ? op.main[i - 1] : 0.0;
    const double above = op.cross_above(row)[static_cast<std::size_t>(c)];
    const double per = op.per_capacity[i];
    return {left * per, op.main[i] * per, above * per, op.cross[i] * per};
}

bool is_even(const Conduction& op, Index row, Index first, Index last) {
    const std::array<double, 4> model = {op.even_main, op.even_main, op.even_cross, op.even_cross};
    for (Index c = first; c < last; ++c) {
        if (rates_at(op, row, c) != model) return false;
    }
    return true;
}

void find_even(const Lattice& lattice, const PaperParams& paper, Conduction& op) {
    // an inner site owns a cell, however the border is weighted; a uniform border shares evenly
    const double quarter = 0.25 * paper.grammage * lattice.row_spacing * lattice.column_spacing;
    const double mass = lattice.border == Border::Uniform ? lattice.node_weight
                                                          : quarter + quarter + quarter + quarter;
    const double per = 1.0 / heat_capacity(paper, mass);
    op.even_main = lattice.edge_conductance[0] * per;
    op.even_cross = lattice.edge_conductance[1] * per;
    const Index tiles = tile_columns(op.column_count);
    op.even.assign(static_cast<std::size_t>(op.row_count) * static_cast<std::size_t>(tiles), 0);
    for (Index row = 0; row < op.row_count; ++row) {
        for (Index t = 0; t < tiles; ++t) {
            // the solvers treat the first and the last column by themselves
            const Index first = std::max(1, t * kTileColumns);
            const Index last = std::min(op.column_count - 1, (t + 1) * kTileColumns);
            op.even[static_cast<std::size_t>(row) * static_cast<std::size_t>(tiles) +
                    static_cast<std::size_t>(t)] = is_even(op, row, first, last) ? 1 : 0;
        }
    }
}

bool same_rows(const Conduction& op, Index a, Index b) {
    for (Index c = 0; c < op.column_count; ++c) {
        const auto x = rates_at(op, a, c), y = rates_at(op, b, c);
        if (x[0] != y[0] || x[1] != y[1]) return false;
    }
    return true;
}

bool same_columns(const Conduction& op, Index a, Index b) {
    for (Index row = 0; row < op.row_count; ++row) {
        const auto x = rates_at(op, row, a), y = rates_at(op, row, b);
        if (x[2] != y[2] || x[3] != y[3]) return false;
    }
    return true;
}

// Two neighbouring lines that are alike are models for the others: cuts leave few such pairs, an
// uncut part of the sheet has nothing else.
template <class Same>
Index find_model(Index count, Same&& same, std::vector<std::uint8_t>& as_model) {
    as_model.assign(static_cast<std::size_t>(count), 0);
    Index model = kNone;
    for (Index i = 0; i + 1 < count && model == kNone; ++i) {
        if (same(i, i + 1)) model = i;
    }
    for (Index i = 0; i < count && model != kNone; ++i)
        as_model[static_cast<std::size_t>(i)] = i == model || same(model, i) ? 1 : 0;
    return model;
}

}  // namespace

void rebuild_conduction(const Lattice& lattice, const SheetState& sheet,
                        const SpringNetwork& network, const PaperParams& paper, Conduction& op) {
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    op.row_count = lattice.row_count;
    op.column_count = lattice.column_count;
    op.closed = lattice.closed;
    op.main.resize(sites);
    op.cross.resize(sites);
    op.per_capacity.resize(sites);
    op.none.assign(static_cast<std::size_t>(lattice.column_count), 0.0);
    fill_edges(lattice, network, Slot::Main, lattice.edge_conductance[0], op.main);
    fill_edges(lattice, network, Slot::Cross, lattice.edge_conductance[1], op.cross);
    for (std::size_t i = 0; i < sites; ++i) {
        const double capacity = heat_capacity(paper, sheet.initial_mass[i]);
        op.per_capacity[i] = capacity > 0 ? 1.0 / capacity : 0.0;  // where there is no paper
    }
    find_limits(op);
    find_even(lattice, paper, op);
    op.model_row = find_model(
        op.row_count, [&op](Index a, Index b) { return same_rows(op, a, b); }, op.row_as_model);
    op.model_column = find_model(
        op.column_count, [&op](Index a, Index b) { return same_columns(op, a, b); },
        op.column_as_model);
    op.topology_version = sheet.topology_version;
}

}  // namespace ember
