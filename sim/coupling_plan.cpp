#include "sim/coupling_plan.h"

#include <algorithm>
#include <cmath>

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

// The runs of particles that may be within reach of a box. Along a line of cells in x that passes
// the box at a distance, a sphere reaches less far: the run is cut down to that chord.
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
    // by how much the cells miss the box; rounding is covered by what reach has to spare
    const auto gap = [&](std::size_t axis, Index cell) {
        const double low = grid.box.low[axis] + cell * grid.cell;
        return std::max({0.0, low - box.high[axis], box.low[axis] - (low + grid.cell)});
    };
    for (Index z = z0; z <= z1; ++z) {
        const double dz = gap(2, z);
        for (Index y = y0; y <= y1; ++y) {
            const double dy = gap(1, y);
            const double chord2 = reach * reach - dy * dy - dz * dz;
            if (chord2 < 0) continue;
            const double chord = std::sqrt(chord2);
            const Index line = (z * grid.count[1] + y) * grid.count[0];
            const auto first =
                static_cast<std::size_t>(line + grid.cell_along(0, box.low[0] - chord));
            const auto last =
                static_cast<std::size_t>(line + grid.cell_along(0, box.high[0] + chord));
            const ParticleRun run{grid.begin[first], grid.begin[last + 1]};
            if (run.begin < run.end) runs.push_back(run);
        }
    }
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
        list_runs(grid, box_of(points, taken), plan.runs);
        if (plan.runs.size() == first && !all) continue;
        NodePatch& patch = plan.patches.emplace_back();
        fill_patch(params, sheet, grid, nodes, points, taken, patch);
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
