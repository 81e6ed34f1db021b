#include "sim/lattice.h"

#include <cmath>
#include <numbers>

#include "sim/math.h"
#include "sim/random.h"

namespace ember {
namespace {

// The paper's own sheet (table 2): A4, 32×48 cells, 33×49 nodes.
constexpr double kReferenceNodeArea = 0.21 * 0.297 / (33.0 * 49.0);  // [m^2]
constexpr double kReferenceRowSpacing = 0.21 / 32.0;                 // [m]
constexpr double kReferenceColumnSpacing = 0.297 / 48.0;             // [m]

// Extent of a slot in rows and columns.
struct Extent {
    Index rows, columns;
};
constexpr Extent extent(Slot kind) {
    switch (kind) {
        case Slot::Main:
            return {0, 1};
        case Slot::Cross:
            return {1, 0};
        case Slot::DiagDown:
        case Slot::DiagUp:
            return {1, 1};
        case Slot::BendMain:
            return {0, 2};
        case Slot::BendCross:
            return {2, 0};
    }
    return {0, 0};
}

double length(Slot kind, double row_spacing, double column_spacing) {
    const Extent e = extent(kind);
    const double z = e.rows * row_spacing, x = e.columns * column_spacing;
    return std::sqrt(x * x + z * z);
}

// Rest length of a slot. Across a tube the bending springs are chords of the polygon, so that the
// tube is the shape at rest.
double rest_length(Slot kind, const Lattice& lattice) {
    const double flat = length(kind, lattice.row_spacing, lattice.column_spacing);
    if (!lattice.closed || kind != Slot::BendCross) return flat;
    return flat * ember::cos(std::numbers::pi / lattice.row_count);
}

double per_weight(Slot kind, const SpringParams& springs) {
    switch (spring_kind(kind)) {
        case SpringKind::Structural:
            return springs.structural;
        case SpringKind::Diagonal:
            return springs.diagonal;
        case SpringKind::Bending:
            return springs.bending;
    }
    return 0;
}

// A spring of length L in a cell of area A adds k L²/A to the membrane stiffness; keeping that at
// its value on the paper's lattice makes the sheet's stiffness independent of the lattice.
double base_stiffness(Slot kind, const Lattice& lattice, double grammage,
                      const SpringParams& springs) {
    const double per_kg = per_weight(kind, springs) * springs.stiffness_scale;
    if (springs.stiffness_law == StiffnessLaw::PerNodeMass) return per_kg * lattice.node_weight;
    const double l = length(kind, lattice.row_spacing, lattice.column_spacing);
    const double l_ref = length(kind, kReferenceRowSpacing, kReferenceColumnSpacing);
    const double cell = lattice.row_spacing * lattice.column_spacing;
    const double cell_ref = kReferenceRowSpacing * kReferenceColumnSpacing;
    return reference_stiffness(grammage, per_kg) * (cell / (l * l)) * (l_ref * l_ref / cell_ref);
}

// ±variation, uniform. Along the main direction one factor per fibre row; cross springs one
// factor per row of cross springs, the same all along that row (section 4.1, figure 3).
double variation(Slot kind, Index row, Index anchor, const SpringParams& springs,
                 std::uint64_t seed, std::size_t sheet) {
    if (spring_kind(kind) != SpringKind::Structural) return 1.0;
    const bool main = kind == Slot::Main;
    const bool per_fibre = springs.variation_pattern == VariationPattern::PerFibre;
    const RandomUse use = per_fibre ? (main ? RandomUse::MainFibre : RandomUse::CrossFibre)
                                    : (main ? RandomUse::MainSpring : RandomUse::CrossSpring);
    const auto index = static_cast<std::uint64_t>(per_fibre ? row : anchor);
    return 1.0 + springs.variation * (2.0 * random_uniform(seed, use, sheet, index) - 1.0);
}

std::array<Index, 2> find_ends(const Lattice& lattice, Slot kind, Index anchor) {
    const Extent e = extent(kind);
    const Index c = lattice.column_of(anchor), far_column = c + e.columns;
    const Index r = lattice.row_of(anchor), far_row = lattice.row_at(r, e.rows);
    if (far_row == kNone || far_column >= lattice.column_count) return {kNone, kNone};
    if (kind == Slot::DiagUp) return {lattice.site(r, far_column), lattice.site(far_row, c)};
    return {anchor, lattice.site(far_row, far_column)};
}

// Quads exist only where there is paper.
void number_cells(const SheetPlan& plan, Lattice& lattice) {
    lattice.cell_count = 0;
    lattice.cell_number.reserve(plan.paper.size());
    for (const std::uint8_t paper : plan.paper)
        lattice.cell_number.push_back(paper != 0 ? lattice.cell_count++ : kNone);
}

}  // namespace

double reference_stiffness(double grammage, double per_weight) {
    return per_weight * grammage * kReferenceNodeArea;
}

Index Lattice::sector_cell(Index site, int sector) const {
    const Index r = row_of(site), c = column_of(site);
    const Index dr = sector >= 2 ? -1 : 0;
    const Index dc = sector == 1 || sector == 2 ? -1 : 0;
    return cell(r + dr, c + dc);
}

bool Lattice::has_paper(Index site) const {
    for (int sector = 0; sector < 4; ++sector) {
        if (sector_cell(site, sector) != kNone) return true;
    }
    return false;
}

Index Lattice::neighbour(Index site, int direction) const {
    const Index r = row_of(site), c = column_of(site);
    if (direction == 0) return c + 1 < column_count ? site + 1 : kNone;
    if (direction == 2) return c > 0 ? site - 1 : kNone;
    const Index row = row_at(r, direction == 1 ? 1 : -1);
    return row == kNone ? kNone : this->site(row, c);
}

Lattice make_lattice(const SheetPlan& plan, const PaperParams& paper, const SpringParams& springs,
                     std::uint64_t seed, std::size_t sheet) {
    Lattice lattice;
    lattice.closed = plan.shape == SheetShape::Cylinder;
    lattice.border = plan.border;
    lattice.cell_rows = plan.rows;
    lattice.cell_columns = plan.columns;
    lattice.cell_count = plan.rows * plan.columns;
    if (!plan.paper.empty()) number_cells(plan, lattice);
    lattice.row_count = lattice.closed ? plan.rows : plan.rows + 1;
    lattice.column_count = plan.columns + 1;
    lattice.row_spacing = plan.width / plan.rows;
    lattice.column_spacing = plan.height / plan.columns;
    const double sheet_mass = paper.grammage * plan.width * plan.height;
    lattice.node_weight = sheet_mass / lattice.site_count();

    const auto slots = static_cast<std::size_t>(kSlotCount * lattice.site_count());
    lattice.stiffness.assign(slots, 0.0);
    lattice.damping.assign(slots, 0.0);
    lattice.initial_length.assign(slots, 0.0);
    lattice.slot_ends.resize(slots);
    for (int k = 0; k < kSlotCount; ++k) {
        const auto kind = static_cast<Slot>(k);
        const double stiffness = base_stiffness(kind, lattice, paper.grammage, springs);
        const double rest = rest_length(kind, lattice);
        for (Index anchor = 0; anchor < lattice.site_count(); ++anchor) {
            const auto slot = static_cast<std::size_t>(lattice.slot(kind, anchor));
            lattice.slot_ends[slot] = find_ends(lattice, kind, anchor);
            if (lattice.slot_ends[slot][0] == kNone) continue;
            const Index row = lattice.row_of(anchor);
            lattice.stiffness[slot] =
                stiffness * variation(kind, row, anchor, springs, seed, sheet);
            lattice.damping[slot] = springs.damping * lattice.node_weight;
            lattice.initial_length[slot] = rest;
        }
    }
    // a whole edge carries the heat of one cell width: D · caliper · width / length
    const double sheet_conductance = paper.conductivity * paper.grammage / paper.density;
    lattice.edge_conductance = {sheet_conductance * lattice.row_spacing / lattice.column_spacing,
                                sheet_conductance * lattice.column_spacing / lattice.row_spacing};
    return lattice;
}

}  // namespace ember
