#include "sim/fracture.h"

#include <algorithm>
#include <cmath>

#include "sim/topology.h"

namespace ember {
namespace {

struct Candidate {
    double elongation;  // [1]
    Index slot;
    Index middle;  // site
    CutLine line;  // perpendicular to the spring
};

bool burnt(const SheetState& sheet, Index node) {
    return sheet.phase[static_cast<std::size_t>(node)] == Phase::BurntOut;
}

// Over-stretched burnt bending springs, worst first.
std::vector<Candidate> find_candidates(const Lattice& lattice, const FractureParams& fracture,
                                       const SpringNetwork& network, const SheetState& sheet) {
    std::vector<Candidate> found;
    const auto consider = [&](Index a, Index b, Index slot_number) {
        if (!burnt(sheet, a) || !burnt(sheet, b)) return;
        const Index sites = lattice.site_count(), anchor = slot_number % sites;
        const bool main = slot_number / sites == static_cast<Index>(Slot::BendMain);
        const Index middle = lattice.neighbour(anchor, main ? 0 : 1);
        if (fracture.middle_burnt && !burnt(sheet, middle)) return;
        const Vector3 d = sheet.position.at(static_cast<std::size_t>(b)) -
                          sheet.position.at(static_cast<std::size_t>(a));
        const double elongation =
            d.norm() / sheet.rest_length[static_cast<std::size_t>(slot_number)] - 1.0;
        if (elongation <= fracture.threshold) return;
        found.push_back(
            {elongation, slot_number, middle, main ? CutLine::AlongCross : CutLine::AlongMain});
    };
    const Index first = lattice.slot(Slot::BendMain, 0);
    const auto slots = static_cast<Index>(network.weight.size());
    for (Index slot = first; slot < slots; ++slot) {
        if (network.weight[static_cast<std::size_t>(slot)] == 0) continue;
        const auto [a, b] = lattice.slot_ends[static_cast<std::size_t>(slot)];
        consider(a, b, slot);
    }
    for (const ExtraSpring& spring : network.extra) {
        if (spring.slot >= first) consider(spring.a, spring.b, spring.slot);
    }
    std::sort(found.begin(), found.end(), [](const Candidate& p, const Candidate& q) {
        return p.elongation != q.elongation ? p.elongation > q.elongation : p.slot < q.slot;
    });
    return found;
}

// Sites within `radius` of `site` on the unburnt sheet rest until `until`.
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

// Lets go hinges at the given sites and around them.
std::int64_t release_hinges(const Lattice& lattice, const std::vector<Index>& sites,
                            SheetState& sheet, StepCounters& counters) {
    std::int64_t released = 0;
    const auto release = [&](Index site) {
        if (site == kNone || !burnt(sheet, site)) return;
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

}  // namespace

std::int64_t break_burnt_springs(const Lattice& lattice, const Params& params,
                                 const SpringNetwork& network, double time,
                                 const std::vector<Index>& burnt_out, SheetState& sheet,
                                 StepCounters& counters) {
    const FractureParams& fracture = params.fracture;
    if (std::isinf(fracture.threshold)) return 0;
    std::vector<Index> opened = burnt_out;
    std::int64_t cuts = 0;
    for (const Candidate& c : find_candidates(lattice, fracture, network, sheet)) {
        if (sheet.relief_until[static_cast<std::size_t>(c.middle)] > time) continue;
        const std::uint64_t before = sheet.topology_version;
        counters.nodes_added += cut_site(lattice, sheet, c.middle, c.line);
        if (sheet.topology_version == before) continue;
        ++cuts;
        opened.push_back(c.middle);
        if (fracture.relief_time > 0) {
            relieve(lattice, c.middle, fracture.relief_radius, time + fracture.relief_time, sheet);
        }
    }
    if (fracture.release_hinges && !opened.empty()) {
        cuts += release_hinges(lattice, opened, sheet, counters);
    }
    counters.cuts += cuts;
    if (cuts > 0) find_pieces(sheet);
    return cuts;
}

}  // namespace ember
