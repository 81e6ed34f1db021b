#include "sim/fracture.h"

#include <algorithm>
#include <cmath>

#include "sim/ash_stress.h"
#include "sim/relief.h"
#include "sim/stress_fracture.h"
#include "sim/topology.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

struct Candidate {
    double load;  // [1] elongation by strength
    Index slot;
    Index middle;  // site
    CutLine line;  // perpendicular to the spring
};

bool burnt(const SheetState& sheet, Index node) {
    return sheet.phase[static_cast<std::size_t>(node)] == Phase::BurntOut;
}

// The bending springs of one direction that are anchored next to each other in a row. Pointers are
// to the data of the first one: of its slot, or of the sites at its ends and in its middle.
struct BendingRow {
    const double *ax, *ay, *az, *bx, *by, *bz;  // [m]
    const double *ash_a, *ash_b, *ash_middle;   // 1 where burnt out
    const double *weight, *rest, *relief;       // [1], [m], [s]
};

// How many springs may be too long: 0 almost always, and then nothing else is to be done. The
// comparison is of squares, and a little generous, so that it needs no root.
EMBER_VECTORISED std::int64_t count_suspects(const BendingRow& row, std::ptrdiff_t count,
                                             double least_stretch, double time) {
    const BendingRow s = row;
    std::int64_t suspects = 0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = s.bx[i] - s.ax[i], dy = s.by[i] - s.ay[i], dz = s.bz[i] - s.az[i];
        const double length = s.rest[i] * least_stretch;
        const bool suspect = (dx * dx + dy * dy + dz * dz > length * length) &
                             (s.ash_a[i] * s.ash_b[i] * s.ash_middle[i] * s.weight[i] > 0.0) &
                             (s.relief[i] <= time);
        suspects += suspect ? 1 : 0;
    }
    return suspects;
}

// Looks for springs that break.
struct Search {
    const FractureInput& in;
    const SheetState& sheet;
    const Lattice& lattice = in.lattice;
    const FractureParams& fracture = in.params.fracture;
    double time = in.time;
    std::vector<Candidate> found = {};

    void consider(Index a, Index b, Index slot_number) {
        if (!burnt(sheet, a) || !burnt(sheet, b)) return;
        const Index sites = lattice.site_count(), anchor = slot_number % sites;
        const bool main = slot_number / sites == static_cast<Index>(Slot::BendMain);
        const Index middle = lattice.neighbour(anchor, main ? 0 : 1);
        if (fracture.middle_burnt && !burnt(sheet, middle)) return;
        if (sheet.relief_until[static_cast<std::size_t>(middle)] > time) return;
        const Vector3 d = sheet.position.at(static_cast<std::size_t>(b)) -
                          sheet.position.at(static_cast<std::size_t>(a));
        const double elongation =
            d.norm() / sheet.rest_length[static_cast<std::size_t>(slot_number)] - 1.0;
        const double load = elongation / relative_strength(lattice, sheet, in.params,
                                                           in.sheet_number, middle, time);
        if (load <= fracture.threshold) return;
        found.push_back(
            {load, slot_number, middle, main ? CutLine::AlongCross : CutLine::AlongMain});
    }

    // Springs anchored in columns `range` of row r, if one of them may be too long.
    void look_at_row(Slot kind, Index r, ColumnRange range) {
        const bool main = kind == Slot::BendMain;
        const Index row_b = main ? r : lattice.row_at(r, 2),
                    middle = main ? r : lattice.row_at(r, 1);
        const Index slot = lattice.slot(kind, lattice.site(r, range.first));
        const Index a = lattice.site(r, range.first),
                    b = lattice.site(row_b, range.first) + 2 * main;
        const Index m = lattice.site(middle, range.first) + main;
        const Vector3Array& p = sheet.position;
        const std::vector<double>& ash = in.active.ash;
        // by the letter of the paper the middle node need not be burnt: then look at an end twice
        const BendingRow row{p.x.data() + a,
                             p.y.data() + a,
                             p.z.data() + a,
                             p.x.data() + b,
                             p.y.data() + b,
                             p.z.data() + b,
                             ash.data() + a,
                             ash.data() + b,
                             ash.data() + (fracture.middle_burnt ? m : a),
                             in.network.weight.data() + slot,
                             sheet.rest_length.data() + slot,
                             sheet.relief_until.data() + m};
        constexpr double kGenerous = 1.0 - 1e-12;
        const double weakest = fracture.ash_strength * (1.0 - fracture.strength_noise);
        const double least = (1.0 + fracture.threshold * weakest) * kGenerous;
        const Index count = range.last - range.first + 1;
        if (count_suspects(row, count, least, time) == 0) return;
        for (Index i = 0; i < count; ++i) {
            if (in.network.weight[static_cast<std::size_t>(slot) + static_cast<std::size_t>(i)] !=
                0)
                consider(a + i, b + i, slot + i);
        }
    }
};

// Columns of anchors in row r whose ends may both be burnt. Empty for slots outside the sheet.
ColumnRange anchors(const Search& search, Slot kind, Index r, bool skip) {
    const Lattice& lattice = search.lattice;
    const bool main = kind == Slot::BendMain;
    const Index row_b = main ? r : lattice.row_at(r, 2);
    if (row_b == kNone) return {0, -1};
    const Index last = lattice.column_count - 1 - (main ? 2 : 0);
    if (!skip) return {0, last};
    const ColumnRange a = search.in.active.ash_range[static_cast<std::size_t>(r)];
    const ColumnRange b = search.in.active.ash_range[static_cast<std::size_t>(row_b)];
    const Index shift = main ? 2 : 0;
    return {std::max(a.first, b.first - shift), std::min({a.last, b.last - shift, last})};
}

// Over-stretched burnt bending springs, worst first.
std::vector<Candidate> find_candidates(Search search, bool skip, StepCounters& counters) {
    const Lattice& lattice = search.lattice;
    for (const Slot kind : {Slot::BendMain, Slot::BendCross}) {
        for (Index r = 0; r < lattice.row_count; ++r) {
            const ColumnRange range = anchors(search, kind, r, skip);
            if (range.last < range.first) continue;
            counters.fracture_visited += range.last - range.first + 1;
            search.look_at_row(kind, r, range);
        }
    }
    const Index first = lattice.slot(Slot::BendMain, 0);
    for (const ExtraSpring& spring : search.in.network.extra) {
        if (spring.slot < first) continue;
        ++counters.fracture_visited;
        search.consider(spring.a, spring.b, spring.slot);
    }
    std::sort(search.found.begin(), search.found.end(), [](const Candidate& p, const Candidate& q) {
        return p.load != q.load ? p.load > q.load : p.slot < q.slot;
    });
    return std::move(search.found);
}

// The paper's rule.
std::int64_t break_burnt_springs(const FractureInput& in, SheetState& sheet,
                                 std::vector<Index>& opened, StepCounters& counters) {
    const FractureParams& fracture = in.params.fracture;
    std::int64_t cuts = 0;
    for (const Candidate& c : find_candidates({in, sheet}, in.params.numerics.skip, counters)) {
        if (sheet.relief_until[static_cast<std::size_t>(c.middle)] > in.time) continue;
        const std::uint64_t before = sheet.topology_version;
        counters.nodes_added += cut_site(in.lattice, sheet, c.middle, c.line);
        if (sheet.topology_version == before) continue;
        ++cuts;
        opened.push_back(c.middle);
        if (fracture.relief_time > 0) {
            relieve(in.lattice, c.middle, fracture.relief_radius, in.time + fracture.relief_time,
                    sheet);
        }
    }
    return cuts;
}

}  // namespace

std::int64_t break_ash(const FractureInput& in, SheetState& sheet, StepCounters& counters) {
    const FractureParams& fracture = in.params.fracture;
    if (std::isinf(fracture.threshold) || in.active.ash.empty()) return 0;
    if (!in.active.any_ash && in.params.numerics.skip) return 0;
    std::vector<Index> opened;
    std::int64_t cuts = fracture.rule == FractureRule::Paper
                            ? break_burnt_springs(in, sheet, opened, counters)
                            : break_by_stress(in, sheet, opened, counters);
    if (fracture.release_hinges) {
        cuts += release_hinges(in.lattice, in.burnt_out, sheet, counters);
        cuts += release_hinges(in.lattice, opened, sheet, counters);
    }
    counters.cuts += cuts;
    if (cuts > 0) find_pieces(sheet);
    return cuts;
}

}  // namespace ember
