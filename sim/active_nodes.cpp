#include "sim/active_nodes.h"

#include <algorithm>

namespace ember {
namespace {

bool all_unburnt(const std::vector<Phase>& phase) {
    unsigned any = 0;  // one branch-free pass
    for (const Phase p : phase)
        any |= static_cast<unsigned>(p);
    return any == 0;
}

void extend(ColumnRange& range, Index column) {
    if (range.last < range.first) range.first = column;
    range.last = column;
}

}  // namespace

void find_active(const Lattice& lattice, const SheetState& sheet, ActiveNodes& active) {
    active.burning.clear();
    active.any_ash = false;
    if (all_unburnt(sheet.phase)) {
        for (std::vector<double>* flags : {&active.alight, &active.ash})
            flags->clear();
        active.alight_range.clear(), active.ash_range.clear();
        return;
    }
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    const auto rows = static_cast<std::size_t>(lattice.row_count);
    active.alight.resize(sites);
    active.ash.resize(sites);
    for (std::size_t n = 0; n < sites; ++n) {
        active.alight[n] = sheet.phase[n] == Phase::Burning ? 1.0 : 0.0;
        active.ash[n] = sheet.phase[n] == Phase::BurntOut ? 1.0 : 0.0;
    }
    active.alight_range.assign(rows, {0, -1});
    active.ash_range.assign(rows, {0, -1});
    std::size_t n = 0;
    for (std::size_t r = 0; r < rows; ++r) {
        for (Index c = 0; c < lattice.column_count; ++c, ++n) {
            if (sheet.phase[n] == Phase::Unburnt) continue;
            const bool burns = sheet.phase[n] == Phase::Burning;
            extend(burns ? active.alight_range[r] : active.ash_range[r], c);
            if (burns) active.burning.push_back(static_cast<Index>(n));
            active.any_ash |= !burns;
        }
    }
    for (; n < sheet.phase.size(); ++n) {
        if (sheet.phase[n] == Phase::Burning) active.burning.push_back(static_cast<Index>(n));
        active.any_ash |= sheet.phase[n] == Phase::BurntOut;
    }
}

}  // namespace ember
