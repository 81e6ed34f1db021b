#include "sim/ash_stress.h"

#include <algorithm>
#include <cmath>

#include "sim/math.h"
#include "sim/smooth_noise.h"
#include "sim/topology.h"

namespace ember {
namespace {

constexpr double kReferenceGrammage = 0.080;  // [kg/m^2] of the paper's standard sheet

// Adds `share` of the virial of a slot's spring, held by nodes a and b, to `sum`.
struct Virial {
    const Lattice& lattice;
    const SheetState& sheet;
    PlaneTensor sum{};

    void add(Slot kind, Index anchor, Index a, Index b, PlaneVector d, double share) {
        const auto slot = static_cast<std::size_t>(lattice.slot(kind, anchor));
        const auto p = static_cast<std::size_t>(a), q = static_cast<std::size_t>(b);
        const Vector3Array& at = sheet.position;
        const double x = at.x[q] - at.x[p], y = at.y[q] - at.y[p], z = at.z[q] - at.z[p];
        const double stretch = std::sqrt(x * x + y * y + z * z) - sheet.rest_length[slot];
        const double f = share * lattice.stiffness[slot] * stretch / std::sqrt(dot(d, d));
        sum += {f * d.x * d.x, f * d.z * d.z, f * d.x * d.z};
    }
};

Index corner(const SheetState& sheet, Index cell, int number) {
    return sheet.quads[static_cast<std::size_t>(cell)][static_cast<std::size_t>(number)];
}

// The springs of one quad at its corner `sector`: half of either edge there belongs to the quad,
// half of that to the corner; and a quarter of the diagonals.
void add_quad(Virial& virial, Index site, int sector) {
    const Lattice& lattice = virial.lattice;
    const double hx = lattice.column_spacing, hz = lattice.row_spacing;
    const Index cell = lattice.sector_cell(site, sector);
    // its first corner
    const Index r = lattice.row_at(lattice.row_of(site), sector >= 2 ? -1 : 0);
    const Index c = lattice.column_of(site) - (sector == 1 || sector == 2 ? 1 : 0);
    const auto at = [&](int k) { return corner(virial.sheet, cell, k); };
    const Index anchor = lattice.site(r, c);
    virial.add(Slot::Main, lattice.site(lattice.row_of(site), c), at(sector), at(sector ^ 1),
               {hx, 0}, 0.25);
    virial.add(Slot::Cross, lattice.site(r, lattice.column_of(site)), at(sector), at(3 - sector),
               {0, hz}, 0.25);
    virial.add(Slot::DiagDown, anchor, at(0), at(2), {hx, hz}, 0.25);
    virial.add(Slot::DiagUp, anchor, at(1), at(3), {hx, -hz}, 0.25);
}

// Half of the bending spring through a site that two quads on one side of it hold: `edge` is the
// glued edge between them.
void add_bending(Virial& virial, Index site, int edge) {
    const Lattice& lattice = virial.lattice;
    const int before = (edge + 3) % 4, after = edge;  // sectors
    const Index first = lattice.sector_cell(site, before), last = lattice.sector_cell(site, after);
    const bool along_x = edge % 2 == 1;
    const auto outer = [&](Index cell, int sector) {
        return corner(virial.sheet, cell, along_x ? sector ^ 1 : 3 - sector);
    };
    const Index anchor = lattice.neighbour(site, along_x ? 2 : 3);
    const PlaneVector d = along_x ? PlaneVector{2.0 * lattice.column_spacing, 0.0}
                                  : PlaneVector{0.0, 2.0 * lattice.row_spacing};
    virial.add(along_x ? Slot::BendMain : Slot::BendCross, anchor, outer(first, before),
               outer(last, after), d, 0.5);
}

// n / sqrt(n·n), or the main direction for a vector without one.
PlaneVector normalised(PlaneVector v) {
    const double length = std::sqrt(dot(v, v));
    return length > 0 ? PlaneVector{v.x / length, v.z / length} : PlaneVector{1, 0};
}

// When the paper at a site burnt out, or a little later than everything else [s].
double burnout(const SheetState& sheet, Index site, double latest) {
    return std::min(sheet.burnout_time[static_cast<std::size_t>(site)], latest);
}

}  // namespace

double main_modulus(const Lattice& lattice) {
    const double hx = lattice.column_spacing, hz = lattice.row_spacing;
    const auto k = [&](Slot kind) {
        return lattice.stiffness[static_cast<std::size_t>(lattice.slot(kind, 0))];
    };
    const double diagonal = 2.0 * k(Slot::DiagDown) / (hx * hx + hz * hz);
    const double xxxx =
        (k(Slot::Main) + 4.0 * k(Slot::BendMain)) * hx * hx + diagonal * hx * hx * hx * hx;
    const double zzzz =
        (k(Slot::Cross) + 4.0 * k(Slot::BendCross)) * hz * hz + diagonal * hz * hz * hz * hz;
    const double xxzz = diagonal * hx * hx * hz * hz;
    return (xxxx - xxzz * xxzz / zzzz) / (hx * hz);
}

PlaneTensor part_stress(const Lattice& lattice, const SheetState& sheet, Index site,
                        const std::array<int, 4>& parts, int part) {
    Virial virial{lattice, sheet};
    const unsigned glue = sheet.glue[static_cast<std::size_t>(site)];
    int quads = 0;
    for (int k = 0; k < 4; ++k) {
        if (parts[static_cast<std::size_t>(k)] != part) continue;
        ++quads;
        add_quad(virial, site, k);
        if ((glue >> k & 1u) != 0) add_bending(virial, site, k);
    }
    const double area = 0.25 * quads * lattice.row_spacing * lattice.column_spacing;
    const double scale = 1.0 / (area * main_modulus(lattice));
    return {virial.sum.xx * scale, virial.sum.zz * scale, virial.sum.xz * scale};
}

PlaneTensor mean_stress(const Lattice& lattice, const SheetState& sheet, Index site) {
    constexpr Index kReach = 2;  // sites
    PlaneTensor sum;
    double total = 0;
    for (Index dr = -kReach; dr <= kReach; ++dr) {
        const Index row = lattice.row_at(lattice.row_of(site), dr);
        if (row == kNone) continue;
        for (Index dc = -kReach; dc <= kReach; ++dc) {
            const Index column = lattice.column_of(site) + dc;
            if (column < 0 || column >= lattice.column_count) continue;
            const Index near = lattice.site(row, column);
            const auto n = static_cast<std::size_t>(near);
            if (sheet.phase[n] != Phase::BurntOut) continue;
            const auto parts = fan_parts(lattice, near, sheet.glue[n]);
            const double closeness = 1.0 / (1.0 + dr * dr + dc * dc);
            for (int part = 0; part < 4; ++part) {
                const auto quads = std::count(parts.begin(), parts.end(), part);
                if (quads == 0) break;
                const double weight = closeness * static_cast<double>(quads);
                const PlaneTensor s = part_stress(lattice, sheet, near, parts, part);
                sum += {weight * s.xx, weight * s.zz, weight * s.xz};
                total += weight;
            }
        }
    }
    return total > 0 ? PlaneTensor{sum.xx / total, sum.zz / total, sum.xz / total} : sum;
}

double relative_strength(const Lattice& lattice, const SheetState& sheet, const Params& params,
                         std::size_t sheet_number, Index site, double time) {
    const FractureParams& f = params.fracture;
    double strength = 1.0;
    if (f.ash_strength < 1.0) {
        // as burning itself, glowing out takes longer the more there is of it
        const double life = f.ash_time * params.paper.grammage / kReferenceGrammage;
        const double age = time - sheet.burnout_time[static_cast<std::size_t>(site)];
        strength = f.ash_strength + (1.0 - f.ash_strength) * ember::exp(-age / life);
    }
    if (f.strength_noise > 0) {
        const double columns = lattice.cell_columns * lattice.column_spacing / f.noise_length;
        const double rows = lattice.cell_rows * lattice.row_spacing / f.noise_length;
        // a whole number of waves around a tube
        const double around = lattice.closed ? std::max(1.0, std::floor(rows + 0.5)) : 0.0;
        const double pitch = (lattice.closed ? around : rows) / lattice.cell_rows;
        const SmoothNoise noise{static_cast<std::uint64_t>(params.numerics.seed),
                                RandomUse::AshStrength, sheet_number,
                                static_cast<std::uint64_t>(columns) + 2, around};
        strength *= 1.0 + f.strength_noise *
                              noise.at(lattice.column_of(site) * columns / lattice.cell_columns,
                                       lattice.row_of(site) * pitch);
    }
    return strength;
}

PlaneTensor strength_tensor(const Lattice& lattice, const SheetState& sheet,
                            const FractureParams& fracture, Index site) {
    PlaneTensor s{1.0, fracture.grain, 0.0};
    if (fracture.boundary == 0) return s;
    double latest = sheet.burnout_time[static_cast<std::size_t>(site)];
    std::array<Index, 4> near{};
    for (int d = 0; d < 4; ++d) {
        const Index n = lattice.neighbour(site, d);
        near[static_cast<std::size_t>(d)] = n == kNone ? site : n;
        const double t = n == kNone ? latest : sheet.burnout_time[static_cast<std::size_t>(n)];
        if (std::isfinite(t)) latest = std::max(latest, t);
    }
    latest += 1.0;  // [s] paper that is still there lies ahead of the front
    const PlaneVector gradient{
        (burnout(sheet, near[0], latest) - burnout(sheet, near[2], latest)) /
            lattice.column_spacing,
        (burnout(sheet, near[1], latest) - burnout(sheet, near[3], latest)) / lattice.row_spacing};
    if (!(dot(gradient, gradient) > 0)) return s;
    const PlaneVector g = normalised(gradient);
    const double b = fracture.boundary;
    return {s.xx * (1.0 - b * g.x * g.x), s.zz * (1.0 - b * g.z * g.z),
            -std::sqrt(s.xx * s.zz) * b * g.x * g.z};
}

WeakestDirection weakest_direction(const PlaneTensor& stress, const PlaneTensor& strength) {
    // S = L L^T turns the problem into the ordinary one of M = L^-1 σ L^-T
    const double l11 = std::sqrt(strength.xx), l21 = strength.xz / l11;
    const double l22 = std::sqrt(strength.zz - l21 * l21);
    const double a = stress.xx / (l11 * l11);
    const double b = (stress.xz - l21 * stress.xx / l11) / (l11 * l22);
    const double d =
        (stress.zz - 2.0 * l21 * stress.xz / l11 + l21 * l21 * stress.xx / (l11 * l11)) /
        (l22 * l22);
    const double half = 0.5 * (a - d), root = std::sqrt(half * half + b * b);
    const double top = 0.5 * (a + d) + root;
    const PlaneVector m = half >= 0 ? PlaneVector{half + root, b} : PlaneVector{b, root - half};
    const PlaneVector unit = normalised(m);
    const double z = unit.z / l22;
    return {normalised({(unit.x - l21 * z) / l11, z}), top};
}

}  // namespace ember
