#include "sim/curl.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/kernel/plate_law.h"
#include "sim/loads.h"
#include "sim/math.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr double kCharringDifference = 100.0;  // [K] θ_c
constexpr double kNoDifference = 1e-6;         // [K] faces that differ by less are alike

plate::Triple at(const Vector3Array& p, Index node) {
    const auto i = static_cast<std::size_t>(node);
    return {p.x[i], p.y[i], p.z[i]};
}

// Adds the present curvatures of an element along its two lines, weighted by their rigidity.
void add_present(const Lattice& lattice, const SheetState& sheet, const PlateElement& e,
                 CurlScratch& s) {
    const Vector3Array& p = sheet.position;
    const plate::Triple centre = at(p, e.centre), west = at(p, e.west), east = at(p, e.east),
                        north = at(p, e.north), south = at(p, e.south);
    const plate::Triple n = plate::normal_of(east - west, south - north).n;
    const auto site = static_cast<std::size_t>(e.site);
    const double dx = lattice.column_spacing, dz = lattice.row_spacing;
    s.main[site] += e.main * plate::dot(plate::second(west, centre, east), n) / (dx * dx);
    s.cross[site] += e.cross * plate::dot(plate::second(north, centre, south), n) / (dz * dz);
    s.main_share[site] += e.main;
    s.cross_share[site] += e.cross;
}

// Present curvatures of all sites and twists of all cells.
void find_present(const Lattice& lattice, const Plate& plate, const SheetState& sheet,
                  CurlScratch& s) {
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    for (auto* array : {&s.main, &s.cross, &s.twist, &s.main_share, &s.cross_share}) {
        array->resize(sites);
        std::fill(array->begin(), array->end(), 0.0);
    }
    for_each_element(lattice, plate,
                     [&](const PlateElement& e) { add_present(lattice, sheet, e, s); });
    for (std::size_t i = 0; i < sites; ++i) {
        s.main[i] = s.main_share[i] > 0 ? s.main[i] / s.main_share[i] : 0.0;
        s.cross[i] = s.cross_share[i] > 0 ? s.cross[i] / s.cross_share[i] : 0.0;
    }
    const double area = lattice.column_spacing * lattice.row_spacing;
    for_each_cell(lattice, plate, [&](const PlateCell& c) {
        const plate::Triple i = at(sheet.position, c.nodes[0]), j = at(sheet.position, c.nodes[1]),
                            k = at(sheet.position, c.nodes[2]), l = at(sheet.position, c.nodes[3]);
        const plate::Triple n = plate::normal_of(k - i, l - j).n;
        s.twist[static_cast<std::size_t>(c.site)] = plate::dot(i - j + k - l, n) / area;
    });
}

// Where the curvature at rest goes while a share df of a node chars.
double creep(double from, double to, double set, double df) {
    return from + (1.0 - ember::exp(-set * df)) * (to - from);
}

// The plastic set of all sites and cells that have charred.
void set_curvature(const Lattice& lattice, const CurlParams& curl, SheetState& sheet,
                   const CurlScratch& s) {
    RestCurvature& rest = sheet.rest_curvature;
    for (Index site = 0; site < lattice.site_count(); ++site) {
        const auto i = static_cast<std::size_t>(site);
        if (s.charred[i] > 0) {
            const double df = s.charred[i];
            rest.main[i] =
                creep(rest.main[i], resolved_curvature(lattice, s.main[i]), curl.set, df);
            rest.cross[i] =
                creep(rest.cross[i], resolved_curvature(lattice, s.cross[i]), curl.set, df);
        }
        const Index below = lattice.neighbour(site, 1);
        if (lattice.sector_cell(site, 0) == kNone) continue;
        const auto j = static_cast<std::size_t>(below);
        const double df =
            0.25 * (s.charred[i] + s.charred[i + 1] + s.charred[j] + s.charred[j + 1]);
        if (df > 0)
            rest.twist[i] =
                creep(rest.twist[i], resolved_curvature(lattice, s.twist[i]), curl.set, df);
    }
}

// The curvature at rest that two different faces ask for.
struct Free {
    double main, cross;
};
Free free_curvature(const Lattice& lattice, const Params& params, const FaceDifference& faces,
                    std::size_t i) {
    const CurlParams& curl = params.curl;
    const double strain = curl.heat * faces.heat[i] + curl.charring * faces.charred[i] +
                          curl.two_sided * faces.progress[i];
    const double curvature = bilayer_curvature(strain, caliper(params.paper));
    return {resolved_curvature(lattice, curvature),
            resolved_curvature(lattice, curl.cross_ratio * curvature)};
}

}  // namespace

double resolved_curvature(const Lattice& lattice, double curvature) {
    const double share = 2.0 * std::max(lattice.column_spacing, lattice.row_spacing) * curvature;
    return curvature / std::sqrt(1.0 + share * share);
}

double face_relaxation_time(const PaperParams& paper) {
    const double h = caliper(paper);
    if (!(paper.conductivity > 0)) return std::numeric_limits<double>::infinity();
    return paper.density * paper.specific_heat * h * h / (8.0 * paper.conductivity);
}

bool advance_curl(const Lattice& lattice, const Plate& plate, const Params& params,
                  const NodeFire& fire, double dt, SheetState& sheet, CurlScratch& scratch,
                  StepCounters& counters) {
    FaceDifference& faces = sheet.faces;
    if (faces.heat.empty()) return false;
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    const bool fed = fire.direction.size() >= sites;
    if (fed) node_normals(sheet, scratch.normal);
    scratch.charred.resize(sites);
    std::fill(scratch.charred.begin(), scratch.charred.end(), 0.0);
    const double tau = face_relaxation_time(params.paper);
    const double decay = std::isfinite(tau) ? ember::exp(-dt / tau) : 1.0;
    const double gain = std::isfinite(tau) ? tau * (1.0 - decay) : dt;  // [s]
    const double span = params.heat.flame_limit - params.heat.ambient;
    bool changed = false, charring = false;
    for (std::size_t i = 0; i < sites; ++i) {
        if (!(sheet.initial_mass[i] > 0)) continue;  // no paper
        const double lost =
            (1.0 - sheet.mass[i] / sheet.initial_mass[i]) / (1.0 - params.burning.residual_mass);
        const double df = std::max(0.0, lost - faces.progress[i]);
        scratch.charred[i] = df;
        const double given = fed && sheet.held[i] == 0 ? fire.heating[i] : 0.0;
        if (given == 0 && faces.heat[i] == 0 && df == 0) continue;
        ++counters.curl_visited;
        const Free before = free_curvature(lattice, params, faces, i);
        double heat = decay * faces.heat[i];
        if (given > 0) {
            // as the exchange of heat has it: nothing is heated above flame_limit
            const double room = 1.0 - (sheet.temperature[i] - params.heat.ambient) / span;
            const double side = scratch.normal.at(i).dot(fire.direction.at(i));
            heat += 2.0 * given * std::max(0.0, room) * side * gain;
        }
        faces.heat[i] = std::abs(heat) < kNoDifference ? 0.0 : heat;
        faces.charred[i] +=
            df * heat / std::sqrt(heat * heat + kCharringDifference * kCharringDifference);
        faces.progress[i] += df;
        const Free after = free_curvature(lattice, params, faces, i);
        sheet.rest_curvature.main[i] += after.main - before.main;
        sheet.rest_curvature.cross[i] += after.cross - before.cross;
        sheet.quiet_ticks[static_cast<std::size_t>(lattice.row_of(static_cast<Index>(i)))] = 0;
        changed = true;
        charring |= df > 0;
    }
    if (charring && params.curl.set > 0) {
        find_present(lattice, plate, sheet, scratch);
        set_curvature(lattice, params.curl, sheet, scratch);
    }
    return changed;
}

}  // namespace ember
