#include "sim/stress_fracture.h"

#include <algorithm>
#include <cmath>

#include "sim/ash_stress.h"
#include "sim/crack_path.h"
#include "sim/relief.h"
#include "sim/topology.h"

namespace ember {
namespace {

constexpr double kReferenceSpacing = 0.0064;  // [m] of the paper's own lattice
constexpr double kLeastStrength = 1e-12;      // [1] strain: without strength any tension breaks
constexpr double kLeastAlignment = 0.5;       // of a crack from a border with the edge it opens

struct Start {
    double ratio;
    Index site;
    int part;
};

// Cracks of one sheet in one tick.
class Cracking {
  public:
    Cracking(const FractureInput& in, SheetState& sheet, std::vector<Index>& opened,
             StepCounters& counters)
        : in_(in),
          lattice_(in.lattice),
          fracture_(in.params.fracture),
          sheet_(sheet),
          opened_(opened),
          counters_(counters) {}

    void grow_all();
    void start_all();

  private:
    [[nodiscard]] bool burnt(Index site) const {
        return sheet_.phase[static_cast<std::size_t>(site)] == Phase::BurntOut;
    }
    [[nodiscard]] std::array<int, 4> parts(Index site) const {
        return fan_parts(lattice_, site, sheet_.glue[static_cast<std::size_t>(site)]);
    }
    // σ/S over the threshold here: above 1 it breaks
    [[nodiscard]] WeakestDirection weakest(Index site, const PlaneTensor& stress) const;
    [[nodiscard]] unsigned ways_on(Index site) const;
    bool open(Index site, unsigned mask);
    [[nodiscard]] bool grow(Index tip);
    void find_starts(std::vector<Start>& starts);
    void start(const Start& start);
    void start_from_border(const Start& start, PlaneVector along);

    const FractureInput& in_;
    const Lattice& lattice_;
    const FractureParams& fracture_;
    SheetState& sheet_;
    std::vector<Index>& opened_;
    StepCounters& counters_;
};

WeakestDirection Cracking::weakest(Index site, const PlaneTensor& stress) const {
    WeakestDirection found =
        weakest_direction(stress, strength_tensor(lattice_, sheet_, fracture_, site));
    const double strength =
        fracture_.threshold *
        relative_strength(lattice_, sheet_, in_.params, in_.sheet_number, site, in_.time);
    found.ratio /= std::max(strength, kLeastStrength);
    return found;
}

// Edges along which a crack may leave a site: still glued here and beyond, and burnt there.
unsigned Cracking::ways_on(Index site) const {
    unsigned ways =
        sheet_.glue[static_cast<std::size_t>(site)] & ~edges_open_beyond(lattice_, sheet_, site);
    for (int d = 0; d < 4; ++d) {
        const Index next = lattice_.neighbour(site, d);
        if (next == kNone || !burnt(next)) ways &= ~(1u << d);
    }
    return ways;
}

bool Cracking::open(Index site, unsigned mask) {
    const std::uint64_t before = sheet_.topology_version;
    counters_.nodes_added += open_site(lattice_, sheet_, site, mask);
    if (sheet_.topology_version == before) return false;
    opened_.push_back(site);
    if (fracture_.relief_time > 0)
        relieve(lattice_, site, fracture_.relief_radius, in_.time + fracture_.relief_time, sheet_);
    return true;
}

// Moves the crack on from a tip whose time has come. Returns false when it stays a tip.
bool Cracking::grow(Index tip) {
    if (!burnt(tip)) return false;
    const auto t = static_cast<std::size_t>(tip);
    const unsigned arrived = edges_open_beyond(lattice_, sheet_, tip) & sheet_.glue[t];
    const Index joined = release_hinge(lattice_, sheet_, tip);
    if (joined > 0) {  // at a border or at another crack: the end
        counters_.nodes_added += joined;
        opened_.push_back(tip);
        return true;
    }
    const auto fan = parts(tip);
    if (fan != std::array<int, 4>{0, 0, 0, 0}) return true;  // others have cut it meanwhile
    CrackPaths& cracks = sheet_.cracks;
    PlaneVector heading{cracks.heading_x[t], cracks.heading_z[t]};
    const PlaneVector normal = weakest(tip, mean_stress(lattice_, sheet_, tip)).normal;
    const double tough =
        std::sqrt(kReferenceSpacing / std::sqrt(lattice_.row_spacing * lattice_.column_spacing));
    if (weakest(tip, part_stress(lattice_, sheet_, tip, fan, 0)).ratio <= tough) return false;
    const double side = heading.x * normal.z - heading.z * normal.x >= 0 ? 1.0 : -1.0;
    heading = {heading.x + side * normal.z, heading.z - side * normal.x};
    const double length = std::sqrt(dot(heading, heading));
    heading = {heading.x / length, heading.z / length};
    const CrackStep step =
        next_step(lattice_, ways_on(tip), {cracks.offset_x[t], cracks.offset_z[t]}, heading);
    if (step.edge < 0) return false;
    open(tip, arrived | 1u << step.edge);
    const double due = std::max(cracks.due[t], in_.time - 1.0 / in_.params.numerics.tick_rate) +
                       std::max(step.advance, 0.0) / fracture_.crack_speed;
    put_tip(lattice_, tip, step, heading, due, cracks);
    return true;
}

// A fast crack may take several steps in a tick: its new tips are at the end of the list.
void Cracking::grow_all() {
    CrackPaths& cracks = sheet_.cracks;
    std::vector<Index> left;
    for (std::size_t i = 0; i < cracks.tips.size(); ++i) {
        const Index tip = cracks.tips[i];
        const auto t = static_cast<std::size_t>(tip);
        ++counters_.fracture_visited;
        if (cracks.due[t] > in_.time || !grow(tip)) {
            left.push_back(tip);
            continue;
        }
        cracks.heading_x[t] = cracks.heading_z[t] = 0;
    }
    cracks.tips = std::move(left);
}

// Burnt places where no crack has its tip and that are loaded beyond their strength, worst first.
void Cracking::find_starts(std::vector<Start>& starts) {
    for (Index r = 0; r < lattice_.row_count; ++r) {
        const ColumnRange ash = in_.active.ash_range[static_cast<std::size_t>(r)];
        for (Index c = ash.first; c <= ash.last; ++c) {
            const Index site = lattice_.site(r, c);
            const auto s = static_cast<std::size_t>(site);
            if (!burnt(site) || sheet_.relief_until[s] > in_.time) continue;
            if (is_tip(sheet_.cracks, site)) continue;
            ++counters_.fracture_visited;
            const auto fan = parts(site);
            for (int part = 0; part < 4; ++part) {
                const auto quads = std::count(fan.begin(), fan.end(), part);
                if (quads < 2) continue;
                const PlaneTensor stress = part_stress(lattice_, sheet_, site, fan, part);
                if (!(stress.xx + stress.zz > 0)) continue;
                const double ratio = weakest(site, stress).ratio;
                if (ratio > 1.0) starts.push_back({ratio, site, part});
            }
        }
    }
    std::sort(starts.begin(), starts.end(), [](const Start& p, const Start& q) {
        return p.ratio != q.ratio ? p.ratio > q.ratio
                                  : std::pair(p.site, p.part) < std::pair(q.site, q.part);
    });
}

// A part that has a border already needs one edge to fall in two.
void Cracking::start_from_border(const Start& s, PlaneVector along) {
    const auto fan = parts(s.site);
    unsigned ways = ways_on(s.site);
    for (int d = 0; d < 4; ++d) {
        if (fan[static_cast<std::size_t>(d)] != s.part) ways &= ~(1u << d);
    }
    const PlaneVector offset = crack_offset(sheet_.cracks, s.site);
    CrackStep best;
    PlaneVector heading{};
    for (const double sign : {1.0, -1.0}) {
        const PlaneVector way{sign * along.x, sign * along.z};
        const CrackStep step = next_step(lattice_, ways, offset, way);
        if (step.edge < 0) continue;
        const PlaneVector edge = edge_vector(lattice_, step.edge);
        if (dot(edge, way) < kLeastAlignment * std::sqrt(dot(edge, edge))) continue;
        best = step, heading = way;
    }
    if (best.edge < 0 || !open(s.site, 1u << best.edge)) return;
    put_tip(lattice_, s.site, best, heading, in_.time + best.advance / fracture_.crack_speed,
            sheet_.cracks);
}

void Cracking::start(const Start& s) {
    const PlaneVector normal = weakest(s.site, mean_stress(lattice_, sheet_, s.site)).normal;
    const PlaneVector ahead{-normal.z, normal.x}, back{normal.z, -normal.x};
    if (parts(s.site) != std::array<int, 4>{0, 0, 0, 0}) return start_from_border(s, ahead);
    const unsigned ways = ways_on(s.site);
    const PlaneVector offset = crack_offset(sheet_.cracks, s.site);
    const CrackStep forth = next_step(lattice_, ways, offset, ahead);
    const CrackStep backwards = next_step(lattice_, ways, offset, back);
    if (forth.edge < 0 || backwards.edge < 0) return;
    if (!open(s.site, 1u << forth.edge | 1u << backwards.edge)) return;
    for (const auto& [step, heading] : {std::pair(forth, ahead), std::pair(backwards, back)}) {
        put_tip(lattice_, s.site, step, heading, in_.time + step.advance / fracture_.crack_speed,
                sheet_.cracks);
    }
}

void Cracking::start_all() {
    std::vector<Start> starts;
    find_starts(starts);
    for (const Start& s : starts) {
        if (sheet_.relief_until[static_cast<std::size_t>(s.site)] <= in_.time &&
            !is_tip(sheet_.cracks, s.site))
            start(s);
    }
}

}  // namespace

std::int64_t break_by_stress(const FractureInput& in, SheetState& sheet, std::vector<Index>& opened,
                             StepCounters& counters) {
    const std::size_t before = opened.size();
    Cracking cracking(in, sheet, opened, counters);
    cracking.grow_all();
    cracking.start_all();
    return static_cast<std::int64_t>(opened.size() - before);
}

}  // namespace ember
