#include "sim/spring_network.h"

#include <algorithm>

#include "sim/vectorise.h"

namespace ember {
namespace {

// One side of a slot: the two nodes that the quads on that side have at its ends.
struct Side {
    bool exists = false;     // the unburnt sheet has quads there
    bool connected = false;  // and they still hold this spring
    Index a = kNone, b = kNone;
};

Index corner(const SheetState& sheet, Index cell, int number) {
    return sheet.quads[static_cast<std::size_t>(cell)][static_cast<std::size_t>(number)];
}

// A spring along a line of one or two edges lies between two strips of quads. `first` and `last`
// are the cells of one strip, `a` and `b` their corners at the spring's ends.
Side make_side(const SheetState& sheet, Index first, Index last, int a, int b, bool glued) {
    if (first == kNone || last == kNone) return {};
    return {true, glued, corner(sheet, first, a), corner(sheet, last, b)};
}

bool glued(const SheetState& sheet, Index site, int direction) {
    return (sheet.glue[static_cast<std::size_t>(site)] >> direction & 1) != 0;
}

// The sides of a slot: of the line springs the strips on either side, of a diagonal its own quad.
std::array<Side, 2> sides_of(const Lattice& lattice, const SheetState& sheet, Slot kind,
                             Index anchor) {
    const Index r = lattice.row_of(anchor), c = lattice.column_of(anchor);
    const auto cell = [&](Index dr, Index dc) { return lattice.cell(r + dr, c + dc); };
    switch (kind) {
        case Slot::Main:
            return {make_side(sheet, cell(0, 0), cell(0, 0), 0, 1, true),
                    make_side(sheet, cell(-1, 0), cell(-1, 0), 3, 2, true)};
        case Slot::Cross:
            return {make_side(sheet, cell(0, 0), cell(0, 0), 0, 3, true),
                    make_side(sheet, cell(0, -1), cell(0, -1), 1, 2, true)};
        case Slot::DiagDown:
            return {make_side(sheet, cell(0, 0), cell(0, 0), 0, 2, true), {}};
        case Slot::DiagUp:
            return {make_side(sheet, cell(0, 0), cell(0, 0), 1, 3, true), {}};
        case Slot::BendMain: {
            const Index middle = lattice.neighbour(anchor, 0);
            return {make_side(sheet, cell(0, 0), cell(0, 1), 0, 1, glued(sheet, middle, 1)),
                    make_side(sheet, cell(-1, 0), cell(-1, 1), 3, 2, glued(sheet, middle, 3))};
        }
        case Slot::BendCross: {
            const Index middle = lattice.neighbour(anchor, 1);
            return {make_side(sheet, cell(0, 0), cell(1, 0), 0, 3, glued(sheet, middle, 0)),
                    make_side(sheet, cell(0, -1), cell(1, -1), 1, 2, glued(sheet, middle, 2))};
        }
    }
    return {};
}

// Share of the slot's stiffness that one side carries: half of a whole spring each (a border
// spring has one side only), or, with a uniform border, all of it between the sides there were.
double share(const Lattice& lattice, Slot kind, const std::array<Side, 2>& sides) {
    if (spring_kind(kind) == SpringKind::Diagonal) return 1.0;
    const bool two = sides[0].exists && sides[1].exists;
    return lattice.border == Border::Uniform && !two ? 1.0 : 0.5;
}

void add_spring(Index a, Index b, Index slot, std::array<Index, 2> ends, double weight,
                SpringNetwork& network) {
    if (a == ends[0] && b == ends[1]) {
        network.weight[static_cast<std::size_t>(slot)] += weight;
    } else {
        network.extra.push_back({a, b, slot, weight});
    }
}

// Sorts the ends by node; only the few nodes that have any are listed.
void index_ends(SpringNetwork& network) {
    struct NodeEnd {
        Index node;
        ExtraEnd end;
    };
    std::vector<NodeEnd> found;
    found.reserve(2 * network.extra.size());
    for (std::size_t x = 0; x < network.extra.size(); ++x) {
        found.push_back({network.extra[x].a, {static_cast<Index>(x), 1.0}});
        found.push_back({network.extra[x].b, {static_cast<Index>(x), -1.0}});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const NodeEnd& p, const NodeEnd& q) { return p.node < q.node; });
    network.end_nodes.clear();
    network.end_begin.clear();
    network.ends.clear();
    for (const NodeEnd& f : found) {
        if (network.end_nodes.empty() || network.end_nodes.back() != f.node) {
            network.end_nodes.push_back(f.node);
            network.end_begin.push_back(static_cast<Index>(network.ends.size()));
        }
        network.ends.push_back(f.end);
    }
    network.end_begin.push_back(static_cast<Index>(network.ends.size()));
}

// A spring is as weak as its weaker end.
EMBER_VECTORISED void weaken_run(std::ptrdiff_t count, const double* __restrict at_a,
                                 const double* __restrict at_b, const double* __restrict weight,
                                 const double* __restrict unburnt_k,
                                 const double* __restrict unburnt_d, double* __restrict k,
                                 double* __restrict d) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double w = weight[i] * (at_a[i] < at_b[i] ? at_a[i] : at_b[i]);
        k[i] = unburnt_k[i] * w;
        d[i] = unburnt_d[i] * w;
    }
}

}  // namespace

void rebuild_network(const Lattice& lattice, const SheetState& sheet, SpringNetwork& network) {
    network.weight.assign(lattice.stiffness.size(), 0.0);
    network.extra.clear();
    for (int k = 0; k < kSlotCount; ++k) {
        const auto kind = static_cast<Slot>(k);
        for (Index anchor = 0; anchor < lattice.site_count(); ++anchor) {
            const auto ends = lattice.ends(kind, anchor);
            if (ends[0] == kNone) continue;
            const auto sides = sides_of(lattice, sheet, kind, anchor);
            const double each = share(lattice, kind, sides);
            const Index slot = lattice.slot(kind, anchor);
            const bool merged = sides[0].connected && sides[1].connected &&
                                sides[0].a == sides[1].a && sides[0].b == sides[1].b;
            if (merged) {
                add_spring(sides[0].a, sides[0].b, slot, ends, 2.0 * each, network);
                continue;
            }
            for (const Side& side : sides) {
                if (side.connected) add_spring(side.a, side.b, slot, ends, each, network);
            }
        }
    }
    index_ends(network);
    network.topology_version = sheet.topology_version;
}

void weaken_springs(const Lattice& lattice, const SheetState& sheet, bool follows_mass,
                    ThreadPool& pool, SpringNetwork& network) {
    const std::size_t nodes = sheet.mass.size(), slots = network.weight.size();
    network.left.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        const bool paper = sheet.initial_mass[n] > 0;
        network.left[n] = follows_mass && paper ? sheet.mass[n] / sheet.initial_mass[n] : 1.0;
    }
    network.stiffness.resize(slots, 0.0);
    network.damping.resize(slots, 0.0);
    const double* left = network.left.data();
    const auto on_rows = [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t row = begin; row < end; ++row) {
            for_springs_of_row(lattice, static_cast<Index>(row),
                               [&](std::ptrdiff_t count, Index a, Index b, std::size_t slot) {
                                   weaken_run(count, left + a, left + b, &network.weight[slot],
                                              &lattice.stiffness[slot], &lattice.damping[slot],
                                              &network.stiffness[slot], &network.damping[slot]);
                               });
        }
    };
    pool.for_rows(lattice.row_count, kSlotCount * lattice.column_count, on_rows);
    network.extra_stiffness.resize(network.extra.size());
    network.extra_damping.resize(network.extra.size());
    for (std::size_t x = 0; x < network.extra.size(); ++x) {
        const ExtraSpring& spring = network.extra[x];
        const auto s = static_cast<std::size_t>(spring.slot);
        const double w = spring.weight * std::min(left[spring.a], left[spring.b]);
        network.extra_stiffness[x] = lattice.stiffness[s] * w;
        network.extra_damping[x] = lattice.damping[s] * w;
    }
}

}  // namespace ember
