#include "sim/contact_pairs.h"

#include <algorithm>
#include <cstdlib>
#include <tuple>

namespace ember {
namespace {

// Calls visit(node) for all nodes of rows of which chosen(row) holds.
template <class Choice, class Visitor>
void for_nodes_of_rows(const SheetInSpace& s, Choice&& chosen, Visitor&& visit) {
    const Lattice& lattice = *s.lattice;
    bool any = false;
    for (Index r = 0; r < lattice.row_count; ++r) {
        if (!chosen(static_cast<std::size_t>(r))) continue;
        any = true;
        for (Index c = 0; c < lattice.column_count; ++c)
            visit(lattice.site(r, c));
    }
    if (!any) return;
    for (auto n = lattice.site_count(); n < static_cast<Index>(s.sheet->mass.size()); ++n) {
        const Index site = s.sheet->site[static_cast<std::size_t>(n)];
        if (chosen(static_cast<std::size_t>(lattice.row_of(site)))) visit(n);
    }
}

void find_near_ground(std::span<const SheetInSpace> sheets, double dt, double reach, bool skip,
                      NearThings& near, StepCounters& counters) {
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const SheetState& sheet = *sheets[s].sheet;
        const auto low = [&](std::size_t r) { return !skip || near.rows[s][r].low[1] < reach; };
        for_nodes_of_rows(sheets[s], low, [&](Index node) {
            ++counters.contact_visited;
            const auto n = static_cast<std::size_t>(node);
            const double y = sheet.position.y[n];
            if (std::min(y, y + dt * sheet.velocity.y[n]) < reach && sheet.held[n] == 0)
                near.on_ground.push_back({static_cast<Index>(s), node});
        });
    }
}

// The axis along which the sheets lie farthest apart.
std::size_t widest_axis(const std::vector<SweptBox>& sheets) {
    SweptBox lows = kEmptyBox;
    for (const SweptBox& box : sheets) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            lows.include(axis, box.low[axis], box.low[axis]);
    }
    std::size_t widest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis) {
        if (lows.high[axis] - lows.low[axis] > lows.high[widest] - lows.low[widest]) widest = axis;
    }
    return widest;
}

// What of each sheet's box the boxes of other sheets reach. Along the axis on which sheets lie
// apart, so that each meets its neighbours only.
void find_shared(double reach, NearThings& near) {
    const std::size_t count = near.sheets.size();
    near.shared.assign(count, kEmptyBox);
    const std::size_t axis = widest_axis(near.sheets);
    near.order.resize(count);
    for (std::size_t s = 0; s < count; ++s)
        near.order[s] = static_cast<Index>(s);
    std::sort(near.order.begin(), near.order.end(), [&](Index a, Index b) {
        const double low_a = near.sheets[static_cast<std::size_t>(a)].low[axis];
        const double low_b = near.sheets[static_cast<std::size_t>(b)].low[axis];
        return low_a != low_b ? low_a < low_b : a < b;
    });
    for (std::size_t i = 0; i < count; ++i) {
        const auto a = static_cast<std::size_t>(near.order[i]);
        for (std::size_t j = i + 1; j < count; ++j) {
            const auto b = static_cast<std::size_t>(near.order[j]);
            if (near.sheets[b].low[axis] > near.sheets[a].high[axis] + reach) break;
            if (!overlap(near.sheets[a], near.sheets[b], reach)) continue;
            near.shared[a].include(near.sheets[b]);
            near.shared[b].include(near.sheets[a]);
        }
    }
}

// Whether a site belongs to a quad, whose first corner is at site `corner`, or to its neighbourhood
// on the lattice.
bool are_neighbours(const Lattice& lattice, Index site, Index corner) {
    const Index column = lattice.column_of(site) - lattice.column_of(corner);
    Index row = lattice.row_of(site) - lattice.row_of(corner);
    if (lattice.closed) {  // the shorter way around
        const Index half = lattice.row_count / 2;
        row = (row + half + lattice.row_count) % lattice.row_count - half;
    }
    const auto away = [](Index d) { return d > 1 ? d - 1 : std::max(-d, Index{0}); };
    return std::max(away(row), away(column)) <= kNeighbourCells;
}

bool are_neighbours(const Lattice& lattice, const SheetState& sheet,
                    const std::array<Index, 2>& edge, const std::array<Index, 2>& other) {
    const auto site = [&](Index node) { return sheet.site[static_cast<std::size_t>(node)]; };
    for (const Index a : edge) {
        for (const Index b : other) {
            const Index columns = std::abs(lattice.column_of(site(a)) - lattice.column_of(site(b)));
            Index rows = std::abs(lattice.row_of(site(a)) - lattice.row_of(site(b)));
            if (lattice.closed) rows = std::min(rows, lattice.row_count - rows);
            if (std::max(columns, rows) <= kNeighbourCells) return true;
        }
    }
    return false;
}

SweptBox swept_by_edge(const SheetState& sheet, const std::array<Index, 2>& ends, double dt) {
    SweptBox box = swept_by_node(sheet, static_cast<std::size_t>(ends[0]), dt);
    box.include(swept_by_node(sheet, static_cast<std::size_t>(ends[1]), dt));
    return box;
}

struct PairSearch {
    std::span<const SheetInSpace> sheets;
    double dt, reach;
    bool between, self, skip;
    double longest_edge = 0;  // [m] now

    // A row with its neighbours: quads and edges between two rows may reach what neither row does.
    [[nodiscard]] bool row_takes_part(const NearThings& near, std::size_t s,
                                      std::size_t row) const {
        if (self || !skip) return true;
        SweptBox box = near.rows[s][row];
        for (const Index offset : {-1, 1}) {
            const Index beside = sheets[s].lattice->row_at(static_cast<Index>(row), offset);
            if (beside != kNone) box.include(near.rows[s][static_cast<std::size_t>(beside)]);
        }
        return overlap(box, near.shared[s], reach);
    }

    void pairs_of_quad(std::size_t s, std::size_t quad, NearThings& near,
                       StepCounters& counters) const {
        const SheetState& sheet = *sheets[s].sheet;
        const SweptBox box = swept_by_quad(sheet, quad, dt);
        if (!self && !overlap(box, near.shared[s], reach)) return;
        const auto other = static_cast<Index>(s), number = static_cast<Index>(quad);
        const Index corner = sheet.site[static_cast<std::size_t>(sheet.quads[quad][0])];
        const std::size_t first = near.pairs.size();
        near.grid.visit(box, reach, [&](const SheetNode& node) {
            ++counters.contact_visited;
            const auto n = static_cast<std::size_t>(node.node);
            const SheetInSpace& owner = sheets[static_cast<std::size_t>(node.sheet)];
            if (node.sheet == other) {
                if (!self || are_neighbours(*owner.lattice, sheet.site[n], corner)) return;
            } else if (!between) {
                return;
            }
            if (!overlap(swept_by_node(*owner.sheet, n, dt), box, reach)) return;
            near.pairs.push_back({node.sheet, node.node, other, number});
        });
        std::sort(near.pairs.begin() + static_cast<std::ptrdiff_t>(first), near.pairs.end(),
                  [](const NearPair& p, const NearPair& q) {
                      return std::tie(p.sheet, p.node) < std::tie(q.sheet, q.node);
                  });
    }

    // Edges are met through the node at which they begin.
    void pairs_of_edge(std::size_t s, Index edge, NearThings& near, StepCounters& counters) const {
        const auto& ends = near.borders[s].ends[static_cast<std::size_t>(edge)];
        const SweptBox box = swept_by_edge(*sheets[s].sheet, ends, dt);
        if (!self && !overlap(box, near.shared[s], reach)) return;
        const std::size_t begin = near.edges.size();
        near.grid.visit(box, reach + longest_edge, [&](const SheetNode& node) {
            ++counters.contact_visited;
            const auto o = static_cast<std::size_t>(node.sheet),
                       n = static_cast<std::size_t>(node.node);
            if (o < s || (o == s ? !self : !between)) return;
            const BorderEdges& border = near.borders[o];
            for (Index k = border.first[n]; k < border.first[n + 1]; ++k) {
                const auto& other = border.ends[static_cast<std::size_t>(k)];
                if (o == s && (k <= edge ||
                               are_neighbours(*sheets[s].lattice, *sheets[s].sheet, ends, other))) {
                    continue;
                }
                if (overlap(box, swept_by_edge(*sheets[o].sheet, other, dt), reach))
                    near.edges.push_back({static_cast<Index>(s), edge, node.sheet, k});
            }
        });
        std::sort(near.edges.begin() + static_cast<std::ptrdiff_t>(begin), near.edges.end(),
                  [](const NearEdges& p, const NearEdges& q) {
                      return std::tie(p.other, p.other_edge) < std::tie(q.other, q.other_edge);
                  });
    }

    void find_edges(NearThings& near, StepCounters& counters) {
        near.borders.resize(sheets.size());
        longest_edge = 0;
        for (const SheetNode& node : near.grid.nodes) {
            const auto s = static_cast<std::size_t>(node.sheet),
                       n = static_cast<std::size_t>(node.node);
            find_border_edges(*sheets[s].sheet, near.borders[s]);
            const BorderEdges& border = near.borders[s];
            for (Index k = border.first[n]; k < border.first[n + 1]; ++k) {
                const auto& ends = border.ends[static_cast<std::size_t>(k)];
                const Vector3Array& p = sheets[s].sheet->position;
                longest_edge = std::max(longest_edge,
                                        (p.at(static_cast<std::size_t>(ends[1])) - p.at(n)).norm());
            }
        }
        for (const SheetNode& node : near.grid.nodes) {
            const auto s = static_cast<std::size_t>(node.sheet),
                       n = static_cast<std::size_t>(node.node);
            const Index first = near.borders[s].first[n], last = near.borders[s].first[n + 1];
            for (Index k = first; k < last; ++k)
                pairs_of_edge(s, k, near, counters);
        }
    }

    void run(NearThings& near, StepCounters& counters) {
        near.grid.nodes.clear();
        double size = 0;
        for (std::size_t s = 0; s < sheets.size(); ++s) {
            const Lattice& lattice = *sheets[s].lattice;
            size = std::max({size, lattice.row_spacing, lattice.column_spacing});
            for_nodes_of_rows(
                sheets[s], [&](std::size_t r) { return row_takes_part(near, s, r); },
                [&](Index n) {
                    // sites without paper weigh nothing
                    if (sheets[s].sheet->mass[static_cast<std::size_t>(n)] > 0)
                        near.grid.nodes.push_back({static_cast<Index>(s), n});
                });
        }
        if (near.grid.nodes.empty()) return;
        near.grid.fill(sheets, size + 2.0 * reach, dt);
        for (std::size_t s = 0; s < sheets.size(); ++s) {
            const Lattice& lattice = *sheets[s].lattice;
            for (Index r = 0; r < lattice.cell_rows; ++r) {
                if (!row_takes_part(near, s, static_cast<std::size_t>(r))) continue;
                for (Index c = 0; c < lattice.cell_columns; ++c) {
                    const Index quad = lattice.cell(r, c);
                    if (quad != kNone)
                        pairs_of_quad(s, static_cast<std::size_t>(quad), near, counters);
                }
            }
        }
        find_edges(near, counters);
    }
};

}  // namespace

void find_near(const Params& params, double dt, double thickness, double fall,
               std::span<const SheetInSpace> sheets, NearThings& near, StepCounters& counters) {
    near.on_ground.clear();
    near.pairs.clear();
    near.edges.clear();
    const bool skip = params.numerics.skip, self = params.contact.self;
    const bool between = params.contact.sheets && sheets.size() > 1;
    if (!params.world.ground && !between && !self) return;
    if (near.rows.size() != sheets.size()) near.rows.resize(sheets.size());
    near.sheets.resize(sheets.size());
    const bool pairs = between || self;
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        near.sheets[s] = swept_by_rows(*sheets[s].lattice, *sheets[s].sheet, dt, pairs ? 0 : 1,
                                       pairs ? 2 : 1, near.rows[s]);
    }
    if (params.world.ground) {
        find_near_ground(sheets, dt, 0.5 * thickness + fall, skip, near, counters);
    }
    if (!pairs) return;
    find_shared(thickness + fall, near);
    PairSearch{sheets, dt, thickness + fall, between, self, skip}.run(near, counters);
    counters.contact_pairs += static_cast<std::int64_t>(near.pairs.size() + near.edges.size());
}

}  // namespace ember
