#include "sim/fire_coupling.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/exp_array.h"
#include "sim/math.h"
#include "sim/patch_sums.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// One coupling; threads share it by reference.
struct Coupling {
    const Params& params;
    const std::vector<SheetState>& sheets;
    CouplingScratch& scratch;
    std::vector<NodeFire>& received;
    std::size_t particles;  // listed in the grid
};

// Push on a node: force · area · Σ W (v_p - v), limited to a greatest acceleration.
void push_nodes(const Coupling& c, const NodePatch& patch, const PatchSums& sums) {
    const SheetState& sheet = c.sheets[patch.sheet];
    NodeFire& received = c.received[patch.sheet];
    const FireParams& f = c.params.fire;
    for (std::size_t l = 0; l < kLanes; ++l) {
        if (patch.node[l] == kNone || !(sums.weight[l] > 0)) continue;
        const auto n = static_cast<std::size_t>(patch.node[l]);
        const double factor = f.force * (sheet.initial_mass[n] / c.params.paper.grammage);
        double x = factor * (sums.momentum_x[l] - sums.weight[l] * sheet.velocity.x[n]);
        double y = factor * (sums.momentum_y[l] - sums.weight[l] * sheet.velocity.y[n]);
        double z = factor * (sums.momentum_z[l] - sums.weight[l] * sheet.velocity.z[n]);
        const double limit = f.force_limit * sheet.mass[n], size2 = x * x + y * y + z * z;
        if (size2 > limit * limit) {
            const double scale = limit / std::sqrt(size2);
            x *= scale, y *= scale, z *= scale;
        }
        received.force.x[n] = x;
        received.force.y[n] = y;
        received.force.z[n] = z;
    }
}

// A node takes S_max (1 - exp(-S/S_max)) of the sum S.
void heat_nodes(const Coupling& c, const NodePatch& patch, const PatchSums& sums) {
    const SheetState& sheet = c.sheets[patch.sheet];
    const double limit = c.params.fire.heating_limit;
    std::array<double, kLanes> passed{};
    for (std::size_t l = 0; l < kLanes; ++l)
        passed[l] = -sums.heating[l] / limit;
    exp_array(passed.data(), static_cast<std::ptrdiff_t>(kLanes));
    for (std::size_t l = 0; l < kLanes; ++l) {
        if (patch.node[l] == kNone || !(sums.weight[l] > 0)) continue;
        const auto n = static_cast<std::size_t>(patch.node[l]);
        if (sheet.phase[n] == Phase::BurntOut) continue;
        c.received[patch.sheet].heating[n] = limit * (1.0 - passed[l]);
    }
}

// From where nodes are heated; zero for those that are not.
void direct_nodes(const Coupling& c, const NodePatch& patch, const Index* particles,
                  std::size_t count, double inverse_r2, const PatchSums& sums) {
    PatchDirections from;
    add_directions(c.scratch.grid, patch, particles, count, inverse_r2, from);
    Vector3Array& direction = c.received[patch.sheet].direction;
    for (std::size_t l = 0; l < kLanes; ++l) {
        if (patch.node[l] == kNone || !(sums.heating[l] > 0)) continue;
        const double scale = 1.0 / (sums.heating[l] * c.params.fire.kernel_radius);
        direction.set(static_cast<std::size_t>(patch.node[l]),
                      scale * Vector3(from.x[l], from.y[l], from.z[l]));
    }
}

// All patches of one block. What particles give to the nodes of a block is summed up apart, so
// that the order of additions does not depend on who does which block.
void couple_block(const Coupling& c, Index block) {
    CouplingScratch& s = c.scratch;
    const auto order = [](const NodePatch& patch, Index b) { return patch.block < b; };
    const auto first = std::lower_bound(s.plan.patches.begin(), s.plan.patches.end(), block, order);
    const auto last = std::lower_bound(first, s.plan.patches.end(), block + 1, order);
    const bool all = !c.params.numerics.skip;
    const ParticleRun everything{0, static_cast<Index>(c.particles)};
    ParticleRun touched{everything.end, 0};
    for (auto patch = first; patch != last; ++patch) {
        for (std::size_t r = patch->first_run; r < patch->last_run; ++r) {
            touched.begin = std::min(touched.begin, s.plan.runs[r].begin);
            touched.end = std::max(touched.end, s.plan.runs[r].end);
        }
    }
    if (all) touched = everything;
    double* absorbed = s.absorbed.data() + static_cast<std::size_t>(block) * c.particles;
    if (touched.begin < touched.end)
        std::fill(absorbed + touched.begin, absorbed + touched.end, 0.0);
    s.touched[static_cast<std::size_t>(block)] = touched;
    const double radius = c.params.fire.kernel_radius, inverse_r2 = 1.0 / (radius * radius);
    PatchSums sums;
    Index* near = s.near.data() + static_cast<std::size_t>(block) * (c.particles + kLanes);
    std::size_t count = c.particles;
    if (all) std::iota(near, near + c.particles, 0);
    for (auto patch = first; patch != last; ++patch) {
        if (!all) {
            count = list_near(s.grid, *patch, s.plan.runs.data() + patch->first_run,
                              patch->last_run - patch->first_run, near);
        }
        add_patch(s.grid, *patch, near, count, inverse_r2, absorbed, sums);
        heat_nodes(c, *patch, sums);
        push_nodes(c, *patch, sums);
        if (!c.sheets[patch->sheet].faces.heat.empty())
            direct_nodes(c, *patch, near, count, inverse_r2, sums);
    }
}

EMBER_VECTORISED void add_to(const double* __restrict from, std::ptrdiff_t count,
                             double* __restrict to) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        to[i] += from[i];
}

// exponent = -rate · freshness · absorbed
EMBER_VECTORISED void find_exponents(double rate, const double* __restrict freshness,
                                     const double* __restrict absorbed, std::ptrdiff_t count,
                                     double* __restrict exponent) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        exponent[i] = -rate * freshness[i] * absorbed[i];
}

// Particles lose what they gave.
void cool_particles(const Params& params, double dt, std::size_t particles, FireState& fire,
                    CouplingScratch& s) {
    std::vector<double>& kept = s.kept;
    kept.resize(particles);  // assign() would make room for no more than these
    std::fill(kept.begin(), kept.end(), 0.0);
    for (std::size_t b = 0; b < static_cast<std::size_t>(s.plan.blocks); ++b) {
        const ParticleRun run = s.touched[b];
        if (run.begin >= run.end) continue;
        add_to(s.absorbed.data() + b * particles + run.begin, run.end - run.begin,
               kept.data() + run.begin);
    }
    const double ambient = params.heat.ambient;
    const auto count = static_cast<std::ptrdiff_t>(particles);
    find_exponents(params.fire.absorption * dt, s.grid.freshness.data(), kept.data(), count,
                   kept.data());
    exp_array(kept.data(), count);
    for (std::size_t i = 0; i < particles; ++i) {
        double& t = fire.temperature[static_cast<std::size_t>(s.grid.order[i])];
        if (kept[i] < 1.0) t = ambient + (t - ambient) * kept[i];
    }
}

std::int64_t count_pairs(const CouplingPlan& plan, std::size_t particles, bool all) {
    std::int64_t pairs = 0;
    for (const NodePatch& patch : plan.patches) {
        const auto idle = std::count(patch.node.begin(), patch.node.end(), kNone);
        const std::int64_t nodes = static_cast<std::int64_t>(kLanes) - idle;
        std::int64_t looked_at = all ? static_cast<std::int64_t>(particles) : 0;
        for (std::size_t r = patch.first_run; !all && r < patch.last_run; ++r)
            looked_at += plan.runs[r].end - plan.runs[r].begin;
        pairs += nodes * looked_at;
    }
    return pairs;
}

}  // namespace

double particle_heating(const FireParams& fire, const PaperParams& paper) {
    return fire.heating * ember::pow(0.080 / paper.grammage, fire.grammage_exponent) *
           ember::pow(2e-4 / paper.c_s, fire.stability_exponent);
}

void couple_fire(const Params& params, double time, double dt,
                 const std::vector<SheetState>& sheets, const std::vector<NodeTiles>& tiles,
                 FireState& fire, ThreadPool& pool, CouplingScratch& scratch,
                 std::vector<NodeFire>& received, StepCounters& counters) {
    received.resize(sheets.size());
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const std::size_t nodes = fire.size() > 0 ? sheets[s].mass.size() : 0;
        received[s].heating.assign(nodes, 0.0);
        received[s].force.x.assign(nodes, 0.0);
        received[s].force.y.assign(nodes, 0.0);
        received[s].force.z.assign(nodes, 0.0);
        const std::size_t directed = sheets[s].faces.heat.empty() ? 0 : nodes;
        for (auto* axis :
             {&received[s].direction.x, &received[s].direction.y, &received[s].direction.z})
            axis->assign(directed, 0.0);
    }
    if (fire.size() == 0 || !(params.fire.temperature > params.heat.ambient)) return;
    const bool all = !params.numerics.skip;
    sort_particles(params, particle_heating(params.fire, params.paper), time, all, sheets, fire,
                   scratch.grid);
    plan_coupling(params, all, sheets, tiles, scratch.grid, scratch.plan);
    const auto particles = static_cast<std::size_t>(scratch.grid.listed);
    counters.coupling_pairs += count_pairs(scratch.plan, particles, all);
    if (scratch.plan.patches.empty()) return;
    const auto blocks = static_cast<std::size_t>(scratch.plan.blocks);
    scratch.absorbed.resize(blocks * particles);
    scratch.touched.resize(blocks);
    scratch.near.resize(blocks * (particles + kLanes));
    const Coupling coupling{params, sheets, scratch, received, particles};
    pool.for_rows(scratch.plan.blocks, counters.coupling_pairs / scratch.plan.blocks + 1,
                  [&coupling](std::ptrdiff_t begin, std::ptrdiff_t end) {
                      for (std::ptrdiff_t b = begin; b < end; ++b)
                          couple_block(coupling, static_cast<Index>(b));
                  });
    cool_particles(params, dt, particles, fire, scratch);
}

}  // namespace ember
