// Which nodes burn and which have burnt out: work lists for the stages that look only at those.
#pragma once

#include <vector>

#include "sim/lattice.h"
#include "sim/world_state.h"

namespace ember {

/// Columns first .. last of one row, none when last < first.
struct ColumnRange {
    Index first, last;
};

/// Follows from the phases of a sheet. All arrays but `burning` are empty while nothing has burnt.
struct ActiveNodes {
    std::vector<Index> burning;             ///< burning nodes, ascending
    std::vector<double> alight;             ///< 1: the site's first copy burns, else 0; S
    std::vector<double> ash;                ///< 1: the site's first copy has burnt out, else 0; S
    std::vector<ColumnRange> alight_range;  ///< of each row
    std::vector<ColumnRange> ash_range;     ///< of each row
    bool any_ash = false;                   ///< some node has burnt out
};

/// Looks through all phases. Allocates nothing while everything is unburnt.
void find_active(const Lattice& lattice, const SheetState& sheet, ActiveNodes& active);

}  // namespace ember
