// The springs of a sheet as it is now: whole ones in dense arrays over slots, the rest in a list.
//
// A slot's spring is "dense" as far as it connects the first copies of its two sites. Where cuts
// have made copies, the other springs of the slot are entries of the list `extra`. Everything here
// follows from the quads and glue bits of the sheet (see fracture.h) and is rebuilt after a cut.
#pragma once

#include <vector>

#include "sim/lattice.h"
#include "sim/parallel.h"
#include "sim/world_state.h"

namespace ember {

/// One spring that does not connect two first copies.
struct ExtraSpring {
    Index a, b;     ///< nodes
    Index slot;     ///< its rest length and unburnt constants
    double weight;  ///< [1] share of the slot's stiffness
};

/// Entry of a node's list of extra springs.
struct ExtraEnd {
    Index spring;  ///< in SpringNetwork::extra
    double sign;   ///< +1 for its end a, -1 for its end b
};

struct SpringNetwork {
    std::vector<double> weight;      ///< [1] dense share of each slot, 6×S
    std::vector<ExtraSpring> extra;  ///< X
    std::vector<Index> end_nodes;    ///< E: the nodes that have extra springs, ascending
    std::vector<Index> end_begin;    ///< E+1: end_nodes[i] has ends[end_begin[i] .. [i+1]]
    std::vector<ExtraEnd> ends;      ///< 2X
    // for the present masses; see weaken_springs()
    std::vector<double> stiffness, damping;              ///< [N/m], [kg/s], 6×S
    std::vector<double> extra_stiffness, extra_damping;  ///< X
    std::vector<double> left;                            ///< [1] of each node's mass, N
    std::uint64_t topology_version = ~0ull;              ///< of the sheet it was built for
};

/// Rebuilds the network from the sheet's quads and glue.
void rebuild_network(const Lattice& lattice, const SheetState& sheet, SpringNetwork& network);

/// Sets the network's stiffness and damping for the sheet's present masses: unburnt value × weight
/// × the smaller mass fraction of the two ends (follows_mass), or without the last factor.
void weaken_springs(const Lattice& lattice, const SheetState& sheet, bool follows_mass,
                    ThreadPool& pool, SpringNetwork& network);

/// Calls visit(a, b, slot, stiffness, damping) for every spring there is.
template <class Visitor>
void for_each_spring(const Lattice& lattice, const SpringNetwork& network, Visitor&& visit) {
    for (int k = 0; k < kSlotCount; ++k) {
        for (Index anchor = 0; anchor < lattice.site_count(); ++anchor) {
            const Index slot = lattice.slot(static_cast<Slot>(k), anchor);
            const auto s = static_cast<std::size_t>(slot);
            if (network.weight[s] == 0) continue;
            const auto [a, b] = lattice.ends(static_cast<Slot>(k), anchor);
            visit(a, b, slot, network.stiffness[s], network.damping[s]);
        }
    }
    for (std::size_t x = 0; x < network.extra.size(); ++x) {
        const ExtraSpring& spring = network.extra[x];
        visit(spring.a, spring.b, spring.slot, network.extra_stiffness[x],
              network.extra_damping[x]);
    }
}

}  // namespace ember
