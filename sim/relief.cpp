#include "sim/relief.h"

#include <algorithm>

#include "sim/topology.h"

namespace ember {

void relieve(const Lattice& lattice, Index site, double radius, double until, SheetState& sheet) {
    const auto reach_rows = static_cast<Index>(
        std::min(radius / lattice.row_spacing, static_cast<double>(lattice.row_count - 1)));
    const auto reach_columns = static_cast<Index>(
        std::min(radius / lattice.column_spacing, static_cast<double>(lattice.column_count - 1)));
    for (Index dr = -reach_rows; dr <= reach_rows; ++dr) {
        const Index row = lattice.row_at(lattice.row_of(site), dr);
        if (row == kNone) continue;
        for (Index dc = -reach_columns; dc <= reach_columns; ++dc) {
            const Index column = lattice.column_of(site) + dc;
            const double z = dr * lattice.row_spacing, x = dc * lattice.column_spacing;
            const bool inside = column >= 0 && column < lattice.column_count;
            if (!inside || x * x + z * z > radius * radius) continue;
            double& rest = sheet.relief_until[static_cast<std::size_t>(lattice.site(row, column))];
            rest = std::max(rest, until);
        }
    }
}

std::int64_t release_hinges(const Lattice& lattice, const std::vector<Index>& sites,
                            SheetState& sheet, StepCounters& counters) {
    std::int64_t released = 0;
    const auto release = [&](Index site) {
        if (site == kNone) return;
        if (sheet.phase[static_cast<std::size_t>(site)] != Phase::BurntOut) return;
        const Index added = release_hinge(lattice, sheet, site);
        counters.nodes_added += added;
        released += added > 0 ? 1 : 0;
    };
    for (const Index site : sites) {
        release(site);
        for (int d = 0; d < 4; ++d)
            release(lattice.neighbour(site, d));
    }
    return released;
}

}  // namespace ember
