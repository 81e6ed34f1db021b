#include "sim/topology.h"

#include <algorithm>
#include <numeric>

namespace ember {
namespace {

Index& sector_node(const Lattice& lattice, SheetState& sheet, Index site, int sector) {
    const auto cell = static_cast<std::size_t>(lattice.sector_cell(site, sector));
    return sheet.quads[cell][static_cast<std::size_t>(sector)];
}

template <class T>
void append_copy(std::vector<T>& array, std::size_t of) {
    const T value = array[of];
    array.push_back(value);
}

// A new node like `original`, with `share` of its mass.
Index split_node(SheetState& sheet, Index original, double share) {
    const auto n = static_cast<std::size_t>(original);
    sheet.position.push_back(sheet.position.at(n));
    sheet.velocity.push_back(sheet.velocity.at(n));
    append_copy(sheet.temperature, n);
    append_copy(sheet.ignition_time, n);
    append_copy(sheet.burnout_time, n);
    append_copy(sheet.phase, n);
    append_copy(sheet.site, n);
    append_copy(sheet.held, n);
    append_copy(sheet.piece_held, n);
    for (std::vector<double>* masses : {&sheet.mass, &sheet.initial_mass}) {
        const double part = share * (*masses)[n];
        (*masses)[n] -= part;
        masses->push_back(part);
    }
    return static_cast<Index>(sheet.mass.size()) - 1;
}

}  // namespace

// Parts that already differ keep their nodes.
Index separate(const Lattice& lattice, SheetState& sheet, Index site) {
    const auto parts = fan_parts(lattice, site, sheet.glue[static_cast<std::size_t>(site)]);
    Index added = 0;
    for (int first = 0; first < 4; ++first) {
        const int part = parts[static_cast<std::size_t>(first)];
        if (part < 0) continue;
        const Index node = sector_node(lattice, sheet, site, first);
        // the quads of this node, and among them those of other parts, one part at a time
        for (int other = part + 1; other < 4; ++other) {
            int quads = 0, leaving = 0;
            for (int k = 0; k < 4; ++k) {
                const int p = parts[static_cast<std::size_t>(k)];
                if (p < 0 || sector_node(lattice, sheet, site, k) != node) continue;
                ++quads;
                leaving += p == other ? 1 : 0;
            }
            if (leaving == 0 || leaving == quads) continue;
            const Index copy = split_node(sheet, node, double(leaving) / quads);
            ++added;
            for (int k = 0; k < 4; ++k) {
                if (parts[static_cast<std::size_t>(k)] != other) continue;
                Index& corner = sector_node(lattice, sheet, site, k);
                if (corner == node) corner = copy;
            }
        }
    }
    return added;
}

std::array<int, 4> fan_parts(const Lattice& lattice, Index site, unsigned glue) {
    std::array<int, 4> label{};
    for (int k = 0; k < 4; ++k) {
        label[static_cast<std::size_t>(k)] = lattice.sector_cell(site, k) == kNone ? -1 : k;
    }
    // edge d joins sectors d-1 and d; twice round, so that labels reach the smallest of their part
    for (int d = 0; d < 8; ++d) {
        int& before = label[static_cast<std::size_t>((d + 3) % 4)];
        int& after = label[static_cast<std::size_t>(d % 4)];
        if ((glue >> (d % 4) & 1u) == 0 || before < 0 || after < 0) continue;
        before = after = std::min(before, after);
    }
    // number the parts 0, 1, ... in the order of their first sector
    int next = 0;
    std::array<int, 4> parts{-1, -1, -1, -1};
    for (std::size_t k = 0; k < 4; ++k) {
        if (label[k] < 0) continue;
        for (std::size_t j = 0; j < k; ++j) {
            if (label[j] == label[k]) parts[k] = parts[j];
        }
        if (parts[k] < 0) parts[k] = next++;
    }
    return parts;
}

Index open_site(const Lattice& lattice, SheetState& sheet, Index site, unsigned mask) {
    std::uint8_t& glue = sheet.glue[static_cast<std::size_t>(site)];
    if ((glue & mask) == 0) return 0;
    glue = static_cast<std::uint8_t>(glue & ~mask);
    ++sheet.topology_version;
    return separate(lattice, sheet, site);
}

Index cut_site(const Lattice& lattice, SheetState& sheet, Index site, CutLine line) {
    return open_site(lattice, sheet, site, line == CutLine::AlongMain ? 0b0101u : 0b1010u);
}

unsigned edges_open_beyond(const Lattice& lattice, const SheetState& sheet, Index site) {
    unsigned open = 0;
    for (int d = 0; d < 4; ++d) {
        const Index other = lattice.neighbour(site, d);
        if (other == kNone) continue;
        const unsigned there = sheet.glue[static_cast<std::size_t>(other)];
        if ((there >> ((d + 2) % 4) & 1u) == 0) open |= 1u << d;
    }
    return open;
}

Index release_hinge(const Lattice& lattice, SheetState& sheet, Index site) {
    const unsigned glue = sheet.glue[static_cast<std::size_t>(site)];
    const unsigned strong = glue & ~edges_open_beyond(lattice, sheet, site);
    if (fan_parts(lattice, site, glue) == fan_parts(lattice, site, strong)) return 0;
    return open_site(lattice, sheet, site, glue & ~strong);
}

Index find_pieces(SheetState& sheet) {
    std::vector<Index> root(sheet.mass.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&root](Index n) {
        while (root[static_cast<std::size_t>(n)] != n) {
            Index& parent = root[static_cast<std::size_t>(n)];
            parent = root[static_cast<std::size_t>(parent)];
            n = parent;
        }
        return n;
    };
    for (const Quad& quad : sheet.quads) {
        for (int k = 1; k < 4; ++k) {
            const Index a = find(quad[0]), b = find(quad[static_cast<std::size_t>(k)]);
            root[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
        }
    }
    std::vector<std::uint8_t> held(root.size(), 0);
    Index pieces = 0;
    for (std::size_t n = 0; n < root.size(); ++n) {
        const auto r = static_cast<std::size_t>(find(static_cast<Index>(n)));
        pieces += r == n && sheet.initial_mass[n] > 0 ? 1 : 0;
        held[r] = static_cast<std::uint8_t>(held[r] | sheet.held[n]);
    }
    for (std::size_t n = 0; n < root.size(); ++n) {
        sheet.piece_held[n] = held[static_cast<std::size_t>(find(static_cast<Index>(n)))];
    }
    return pieces;
}

}  // namespace ember
