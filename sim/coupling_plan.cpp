#include "sim/coupling_plan.h"

#include <algorithm>
#include <cmath>

#include "sim/vectorise.h"

namespace ember {
namespace {

// Work is divided into this many blocks where sharing it between threads may pay [entries of runs].
constexpr Index kBlocks = 8;
constexpr std::int64_t kWorthSharing = 1 << 14;

struct Point {
    std::array<double, 3> at;
};

Point position_of(const SheetState& sheet, Index node) {
    const auto n = static_cast<std::size_t>(node);
    return {{sheet.position.x[n], sheet.position.y[n], sheet.position.z[n]}};
}

bool apart(const Point& a, const Point& b, double most) {
    return std::abs(a.at[0] - b.at[0]) > most || std::abs(a.at[1] - b.at[1]) > most ||
           std::abs(a.at[2] - b.at[2]) > most;
}

// Lines of cells in x near a box, and the cells of them that are within its reach.
struct Lines {
    static constexpr std::size_t kMost = 64;  // at a time: usually all that pass a patch
    std::size_t count = 0;
    std::array<Index, kMost> begin{};                     // first cell of each line
    std::array<double, kMost> miss2_y{}, miss2_z{};       // [m²] by how much it misses the box
    std::array<Index, kMost> first_cell{}, after_cell{};  // in reach; the same: none
};

// Along a line that passes the box at a distance, a sphere reaches less far: by a chord. Rounding
// is covered by what reach has to spare.
EMBER_VECTORISED void find_chords(const ParticleGrid& grid, const Box& box, Lines& lines) {
    const double reach2 = grid.reach * grid.reach, per_cell = grid.per_cell;
    const double low = box.low[0], high = box.high[0], start = grid.box.low[0];
    const auto last = static_cast<double>(grid.count[0] - 1);
    const std::size_t count = lines.count;
    for (std::size_t i = 0; i < count; ++i) {
        const double chord2 = reach2 - lines.miss2_y[i] - lines.miss2_z[i];
        // not of a negative number, which a choice between two roots would compute all the same
        const double chord = std::sqrt(0.5 * (chord2 + std::abs(chord2)));
        const double from = (low - chord - start) * per_cell,
                     to = (high + chord - start) * per_cell;
        // as ParticleGrid::cell_along
        const double first_in = from < last ? from : last, last_in = to < last ? to : last;
        const Index first = lines.begin[i] + static_cast<Index>(first_in > 0.0 ? first_in : 0.0);
        const Index after = lines.begin[i] + static_cast<Index>(last_in > 0.0 ? last_in : 0.0) + 1;
        lines.first_cell[i] = first;
        lines.after_cell[i] = chord2 < 0.0 ? first : after;
    }
}

// Without a branch for each line, since which of them are empty cannot be foreseen.
void add_runs(const ParticleGrid& grid, const Box& box, Lines& lines,
              std::vector<ParticleRun>& runs) {
    find_chords(grid, box, lines);
    std::size_t kept = runs.size();
    runs.resize(kept + lines.count);
    for (std::size_t i = 0; i < lines.count; ++i) {
        const ParticleRun run{grid.begin[static_cast<std::size_t>(lines.first_cell[i])],
                              grid.begin[static_cast<std::size_t>(lines.after_cell[i])]};
        runs[kept] = run;
        kept += run.begin < run.end ? 1 : 0;
    }
    runs.resize(kept);
    lines.count = 0;
}

// The runs of particles that may be within reach of a box.
void list_runs(const ParticleGrid& grid, const Box& box, std::vector<ParticleRun>& runs) {
    const double reach = grid.reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(box.low[axis] - reach <= grid.box.high[axis])) return;
        if (!(box.high[axis] + reach >= grid.box.low[axis])) return;
    }
    const Index y0 = grid.cell_along(1, box.low[1] - reach);
    const Index y1 = grid.cell_along(1, box.high[1] + reach);
    const Index z0 = grid.cell_along(2, box.low[2] - reach);
    const Index z1 = grid.cell_along(2, box.high[2] + reach);
    const auto miss2 = [&](std::size_t axis, Index cell) {
        const double low = grid.box.low[axis] + cell * grid.cell;
        const double miss =
            std::max({0.0, low - box.high[axis], box.low[axis] - (low + grid.cell)});
        return miss * miss;
    };
    Lines lines;
    for (Index z = z0; z <= z1; ++z) {
        const double miss2_z = miss2(2, z);
        for (Index y = y0; y <= y1; ++y) {
            if (lines.count == Lines::kMost) add_runs(grid, box, lines, runs);
            const std::size_t i = lines.count++;
            lines.begin[i] = (z * grid.count[1] + y) * grid.count[0];
            lines.miss2_y[i] = miss2(1, y);
            lines.miss2_z[i] = miss2_z;
        }
    }
    add_runs(grid, box, lines, runs);
}

// Nodes of a tile that are within a radius of the first of `waiting`, which they leave. Pieces
// that have come apart would make a patch with a box so large that it looks at everything.
std::array<bool, kLanes> take_cluster(const std::array<Point, kLanes>& points, double radius,
                                      std::array<bool, kLanes>& waiting) {
    std::array<bool, kLanes> taken{};
    std::size_t seed = 0;
    while (!waiting[seed])
        ++seed;
    for (std::size_t l = 0; l < kLanes; ++l) {
        taken[l] = l == seed || (waiting[l] && !apart(points[l], points[seed], radius));
        waiting[l] = waiting[l] && !taken[l];
    }
    return taken;
}

Box box_of(const std::array<Point, kLanes>& points, const std::array<bool, kLanes>& taken) {
    constexpr double kFar = 1e300;
    Box box{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
    for (std::size_t l = 0; l < kLanes; ++l) {
        if (!taken[l]) continue;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min(box.low[axis], points[l].at[axis]);
            box.high[axis] = std::max(box.high[axis], points[l].at[axis]);
        }
    }
    return box;
}

void fill_patch(const Params& params, const SheetState& sheet, const ParticleGrid& grid,
                const Index* nodes, const std::array<Point, kLanes>& points,
                const std::array<bool, kLanes>& taken, NodePatch& patch) {
    const double radius = params.fire.kernel_radius;
    const double per_area = params.fire.absorption > 0 ? 1.0 / (radius * radius) : 0.0;
    for (std::size_t l = 0; l < kLanes; ++l) {
        const auto n = static_cast<std::size_t>(nodes[l]);
        patch.node[l] = taken[l] ? nodes[l] : kNone;
        patch.x[l] = taken[l] ? points[l].at[0] : grid.box.low[0] - 4 * grid.reach;
        patch.y[l] = taken[l] ? points[l].at[1] : grid.box.low[1];
        patch.z[l] = taken[l] ? points[l].at[2] : grid.box.low[2];
        const bool heats = taken[l] && sheet.phase[n] != Phase::BurntOut;
        patch.share[l] = heats ? sheet.initial_mass[n] / params.paper.grammage * per_area : 0.0;
    }
}

void plan_tile(const Params& params, bool all, const SheetState& sheet, std::size_t number,
               const Index* nodes, const ParticleGrid& grid, CouplingPlan& plan) {
    std::array<Point, kLanes> points{};
    std::array<bool, kLanes> waiting{};
    for (std::size_t l = 0; l < kLanes; ++l) {
        waiting[l] = nodes[l] != kNone;
        if (waiting[l]) points[l] = position_of(sheet, nodes[l]);
    }
    while (std::find(waiting.begin(), waiting.end(), true) != waiting.end()) {
        const auto taken = take_cluster(points, grid.reach, waiting);
        const std::size_t first = plan.runs.size();
        const Box box = box_of(points, taken);
        list_runs(grid, box, plan.runs);
        if (plan.runs.size() == first && !all) continue;
        NodePatch& patch = plan.patches.emplace_back();
        fill_patch(params, sheet, grid, nodes, points, taken, patch);
        patch.box = box;
        patch.sheet = number;
        patch.first_run = first;
        patch.last_run = plan.runs.size();
    }
}

// Patches of about the same work, in order.
void divide(CouplingPlan& plan) {
    std::int64_t total = 0, before = 0;
    for (const ParticleRun& run : plan.runs)
        total += run.end - run.begin;
    plan.blocks = total < kWorthSharing ? 1 : kBlocks;
    for (NodePatch& patch : plan.patches) {
        patch.block = static_cast<Index>(before * plan.blocks / (total + 1));
        for (std::size_t r = patch.first_run; r < patch.last_run; ++r)
            before += plan.runs[r].end - plan.runs[r].begin;
    }
}

}  // namespace

void plan_coupling(const Params& params, bool all, const std::vector<SheetState>& sheets,
                   const std::vector<NodeTiles>& tiles, const ParticleGrid& grid,
                   CouplingPlan& plan) {
    plan.patches.clear();
    plan.runs.clear();
    if (grid.sorted == 0 && !all) return;
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        for (std::size_t t = 0; t < tiles[s].size(); ++t) {
            plan_tile(params, all, sheets[s], s, tiles[s].node.data() + t * kLanes, grid, plan);
        }
    }
    divide(plan);
}

}  // namespace ember
