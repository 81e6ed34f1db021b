#include "sim/shrinkage.h"

#include <algorithm>
#include <array>

namespace ember {
namespace {

constexpr double kCelsiusZero = 273.15;  // [K]

double spring_stiffness(Slot kind, const Params& params) {
    if (!params.shrinkage.literal_stiffness) return reference_stiffness(params.paper.grammage);
    const SpringKind spring = spring_kind(kind);
    const double per_weight = spring == SpringKind::Structural ? params.springs.structural
                              : spring == SpringKind::Diagonal ? params.springs.diagonal
                                                               : params.springs.bending;
    return reference_stiffness(params.paper.grammage, per_weight);
}

double burning_weight(Slot kind, ShrinkRule rule, int burning_ends) {
    if (burning_ends == 2) return 1.0;
    const bool half = rule == ShrinkRule::Half || spring_kind(kind) == SpringKind::Bending;
    return burning_ends == 1 && half ? 0.5 : 0.0;
}

// The slots that end at a site, each as (kind, anchor); kNone anchors lie outside the sheet.
std::array<std::pair<Slot, Index>, 12> slots_at(const Lattice& lattice, Index site) {
    const Index r = lattice.row_of(site), c = lattice.column_of(site);
    const auto anchor = [&](Index dr, Index dc) {
        const Index row = lattice.row_at(r, dr), column = c + dc;
        return row == kNone || column < 0 ? kNone : lattice.site(row, column);
    };
    return {{{Slot::Main, site},
             {Slot::Main, anchor(0, -1)},
             {Slot::Cross, site},
             {Slot::Cross, anchor(-1, 0)},
             {Slot::DiagDown, site},
             {Slot::DiagDown, anchor(-1, -1)},
             {Slot::DiagUp, anchor(0, -1)},
             {Slot::DiagUp, anchor(-1, 0)},
             {Slot::BendMain, site},
             {Slot::BendMain, anchor(0, -2)},
             {Slot::BendCross, site},
             {Slot::BendCross, anchor(-2, 0)}}};
}

}  // namespace

void shrink_burning_springs(const Lattice& lattice, const Params& params, double dt,
                            SheetState& sheet, StepCounters& counters) {
    const ShrinkageParams& shrinkage = params.shrinkage;
    if (!(shrinkage.factor > 0)) return;
    const double steps = dt / shrinkage.reference_step;
    for (Index site = 0; site < lattice.site_count(); ++site) {
        if (sheet.phase[static_cast<std::size_t>(site)] != Phase::Burning) continue;
        for (const auto& [kind, anchor] : slots_at(lattice, site)) {
            if (anchor == kNone) continue;
            const auto [a, b] = lattice.ends(kind, anchor);
            if (a == kNone) continue;
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
            const bool both = sheet.phase[i] == Phase::Burning && sheet.phase[j] == Phase::Burning;
            if (both && site == b) continue;  // its other end has done it
            const double w = burning_weight(kind, shrinkage.rule, both ? 2 : 1);
            if (w == 0) continue;
            const auto slot = static_cast<std::size_t>(lattice.slot(kind, anchor));
            const double initial = lattice.initial_length[slot];
            const double heat = sheet.temperature[i] + sheet.temperature[j] - 2.0 * kCelsiusZero;
            const double shrunk =
                sheet.rest_length[slot] - w * steps * shrinkage.factor * initial * heat /
                                              (spring_stiffness(kind, params) * params.paper.c_s);
            sheet.rest_length[slot] =
                std::min(sheet.rest_length[slot], std::max(shrunk, shrinkage.floor * initial));
            ++counters.springs_shrunk;
        }
    }
}

}  // namespace ember
