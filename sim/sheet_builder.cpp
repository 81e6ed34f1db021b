#include "sim/sheet_builder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/held_places.h"
#include "sim/math.h"
#include "sim/plate.h"
#include "sim/random.h"
#include "sim/smooth_noise.h"
#include "sim/topology.h"

namespace ember {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr Index kWaves = 6;  // control points of the waviness per side

// Smooth random height in [-1, 1] at (u, v) in [0, 1]², the same at v = 0 and 1 of a tube.
double waviness(double u, double v, bool closed, std::uint64_t seed, std::size_t sheet) {
    const SmoothNoise noise{seed, RandomUse::Waviness, sheet, kWaves + 2, closed ? kWaves : 0.0};
    return noise.at(u * kWaves, v * kWaves);
}

// Position of a site: on the plane of the plan, or on the polygon of the tube, plus waviness.
Vector3 place(const SheetPlan& plan, const Lattice& lattice, Index row, Index column,
              std::uint64_t seed, std::size_t sheet) {
    const Vector3 normal = plan.cross.cross(plan.main);
    const double along = column * lattice.column_spacing;
    const double u = double(column) / std::max(lattice.column_count - 1, 1);
    const double bump =
        plan.imperfection * waviness(u, double(row) / plan.rows, lattice.closed, seed, sheet);
    if (!lattice.closed) {
        return plan.origin + along * plan.main + row * lattice.row_spacing * plan.cross +
               bump * normal;
    }
    // regular polygon whose sides are one row spacing; its axis runs along `main`
    const double angle = kTwoPi * row / lattice.row_count;
    const double radius = 0.5 * lattice.row_spacing / ember::sin(0.5 * kTwoPi / lattice.row_count);
    const Vector3 out = ember::cos(angle) * plan.cross + ember::sin(angle) * normal;
    return plan.origin + along * plan.main + (radius + bump) * out;
}

// Mass of every site [kg].
std::vector<double> site_masses(const SheetPlan& plan, const Lattice& lattice, double grammage) {
    const auto n = static_cast<std::size_t>(lattice.site_count());
    const bool whole = plan.paper.empty();
    if (plan.border == Border::Uniform && whole) {
        return std::vector<double>(n, lattice.node_weight);
    }
    const double cell = grammage * lattice.row_spacing * lattice.column_spacing;
    std::vector<double> mass(n, 0.0);
    if (plan.border == Border::Uniform) {
        Index sites = 0;
        for (Index site = 0; site < lattice.site_count(); ++site)
            sites += lattice.has_paper(site) ? 1 : 0;
        for (Index site = 0; site < lattice.site_count(); ++site) {
            if (lattice.has_paper(site))
                mass[static_cast<std::size_t>(site)] = cell * lattice.cell_count / sites;
        }
        return mass;
    }
    const double quarter = 0.25 * cell;
    for (Index site = 0; site < lattice.site_count(); ++site) {
        for (int sector = 0; sector < 4; ++sector) {
            if (lattice.sector_cell(site, sector) != kNone) {
                mass[static_cast<std::size_t>(site)] += quarter;
            }
        }
    }
    return mass;
}

}  // namespace

SheetState make_sheet(const SheetPlan& plan, const Lattice& lattice, const Params& params,
                      std::size_t sheet) {
    const auto n = static_cast<std::size_t>(lattice.site_count());
    const auto seed = static_cast<std::uint64_t>(params.numerics.seed);
    constexpr double kNever = std::numeric_limits<double>::infinity();
    SheetState state;
    state.position.resize(n);
    state.velocity.resize(n);
    state.temperature.assign(n, params.heat.ambient);
    state.initial_mass = site_masses(plan, lattice, params.paper.grammage);
    state.mass = state.initial_mass;
    state.ignition_time.assign(n, kNever);
    state.burnout_time.assign(n, kNever);
    state.phase.assign(n, Phase::Unburnt);
    state.site.resize(n);
    state.held = held_sites(plan);
    state.glue.assign(n, 0);
    state.relief_until.assign(n, 0.0);
    state.quiet_ticks.assign(static_cast<std::size_t>(lattice.row_count), 0);
    state.rest_length = lattice.initial_length;
    for (Index site = 0; site < lattice.site_count(); ++site) {
        const auto i = static_cast<std::size_t>(site);
        const Index row = lattice.row_of(site), column = lattice.column_of(site);
        state.position.set(i, place(plan, lattice, row, column, seed, sheet));
        state.velocity.set(i, Vector3::Zero());
        state.site[i] = site;
        // what is not there does not move either
        if (!plan.paper.empty() && !lattice.has_paper(site)) state.held[i] = 1;
        for (int d = 0; d < 4; ++d) {
            const bool both = lattice.sector_cell(site, (d + 3) % 4) != kNone &&
                              lattice.sector_cell(site, d) != kNone;
            if (both) state.glue[i] = static_cast<std::uint8_t>(state.glue[i] | (1u << d));
        }
    }
    state.quads.resize(static_cast<std::size_t>(lattice.cell_count));
    for (Index site = 0; site < lattice.site_count(); ++site) {
        for (int sector = 0; sector < 4; ++sector) {
            const Index cell = lattice.sector_cell(site, sector);
            if (cell == kNone) continue;
            state.quads[static_cast<std::size_t>(cell)][static_cast<std::size_t>(sector)] = site;
        }
    }
    const bool stiff = flexural_rigidity(params.paper, params.plate).any();
    if (stiff && (lattice.closed || params.curl.any())) {
        state.rest_curvature.main.assign(n, 0.0);
        state.rest_curvature.cross.assign(n, built_curvature(lattice));
        state.rest_curvature.twist.assign(n, 0.0);
    }
    if (stiff && params.curl.any()) {
        for (auto* array : {&state.faces.heat, &state.faces.charred, &state.faces.progress})
            array->assign(n, 0.0);
    }
    state.piece_held.assign(n, 0);
    for (Index site = 0; site < lattice.site_count() && !plan.paper.empty(); ++site)
        separate(lattice, state, site);
    find_pieces(state);
    return state;
}

}  // namespace ember
