#include "sim/plate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/math.h"
#include "sim/param_table.h"

namespace ember {
namespace {

Index corner(const SheetState& sheet, Index cell, int number) {
    return sheet.quads[static_cast<std::size_t>(cell)][static_cast<std::size_t>(number % 4)];
}

bool glued(const SheetState& sheet, Index site, int direction) {
    return (sheet.glue[static_cast<std::size_t>(site)] >> (direction % 4) & 1) != 0;
}

// The nodes around a site as one of its quads sees them, in the four directions of
// Lattice::neighbour: its own two, and those beyond the site if the quads on the same side of the
// line share the site's node. kNone where a line ends. In sector k the site is corner k, the next
// node in direction k is corner k + 1, and in direction k + 1 it is corner k + 3.
std::array<Index, 4> nodes_around(const Lattice& lattice, const SheetState& sheet, Index site,
                                  int sector) {
    std::array<Index, 4> around{kNone, kNone, kNone, kNone};
    const auto at = [&](int direction) -> Index& {
        return around[static_cast<std::size_t>(direction % 4)];
    };
    const Index own = lattice.sector_cell(site, sector);
    at(sector) = corner(sheet, own, sector + 1);
    at(sector + 1) = corner(sheet, own, sector + 3);
    const Index after = lattice.sector_cell(site, (sector + 1) % 4);
    if (after != kNone && glued(sheet, site, sector + 1))
        at(sector + 2) = corner(sheet, after, sector + 4);
    const Index before = lattice.sector_cell(site, (sector + 3) % 4);
    if (before != kNone && glued(sheet, site, sector))
        at(sector + 3) = corner(sheet, before, sector + 4);
    return around;
}

PlateElement make_element(const Plate& plate, Index centre, Index site,
                          const std::array<Index, 4>& around) {
    const auto node = [&](std::size_t direction) {
        return around[direction] == kNone ? centre : around[direction];
    };
    const bool main = around[0] != kNone && around[2] != kNone;
    const bool cross = around[1] != kNone && around[3] != kNone;
    PlateElement element{centre, node(2), node(0), node(3), node(1), site, 0, 0, 0};
    const double product = plate.main * plate.cross;
    const double free = product > 0 ? 1.0 - plate.coupling * plate.coupling / product : 1.0;
    constexpr double kQuarter = 0.25;
    element.main = main ? kQuarter * plate.main * (cross ? 1.0 : free) : 0.0;
    element.cross = cross ? kQuarter * plate.cross * (main ? 1.0 : free) : 0.0;
    element.coupling = main && cross ? kQuarter * plate.coupling : 0.0;
    return element;
}

bool same_nodes(const PlateElement& a, const PlateElement& b) {
    return a.centre == b.centre && a.west == b.west && a.east == b.east && a.north == b.north &&
           a.south == b.south;
}

// Adds to the last element if that has the same nodes.
void add_element(const PlateElement& element, std::size_t first, Plate& plate) {
    if (element.main == 0 && element.cross == 0) return;
    for (std::size_t e = first; e < plate.elements.size(); ++e) {
        PlateElement& other = plate.elements[e];
        if (!same_nodes(element, other)) continue;
        other.main += element.main;
        other.coupling += element.coupling;
        other.cross += element.cross;
        return;
    }
    plate.elements.push_back(element);
}

// Whether the element of a site within the sheet is as it was made.
bool is_whole(const Lattice& lattice, const SheetState& sheet, Index site) {
    for (int sector = 0; sector < 4; ++sector) {
        const Index cell = lattice.sector_cell(site, sector);
        if (cell == kNone || !glued(sheet, site, sector)) return false;
        if (corner(sheet, cell, sector) != site ||
            corner(sheet, cell, sector + 1) != lattice.neighbour(site, sector) ||
            corner(sheet, cell, sector + 3) != lattice.neighbour(site, (sector + 1) % 4)) {
            return false;
        }
    }
    return true;
}

void add_elements_of(const Lattice& lattice, const SheetState& sheet, Index site, Plate& plate) {
    if (is_whole(lattice, sheet, site)) {
        plate.share[static_cast<std::size_t>(site)] = 1.0;
        return;
    }
    const std::size_t first = plate.elements.size();
    for (int sector = 0; sector < 4; ++sector) {
        const Index cell = lattice.sector_cell(site, sector);
        if (cell == kNone) continue;
        const Index centre = corner(sheet, cell, sector);
        add_element(make_element(plate, centre, site, nodes_around(lattice, sheet, site, sector)),
                    first, plate);
    }
}

// Clamps of a held site in every direction in which the sheet begins there, a quarter for each quad
// on the line.
void add_clamps_of(const Lattice& lattice, const SheetState& sheet, Index site, Plate& plate) {
    for (int direction = 0; direction < 4; ++direction) {
        const int back = (direction + 2) % 4;
        if (lattice.sector_cell(site, back) != kNone ||
            lattice.sector_cell(site, (back + 3) % 4) != kNone) {
            continue;
        }
        const bool main = direction % 2 == 0;
        const Vector3 step = (direction < 2 ? 1.0 : -1.0) * plate.step[main ? 0 : 1];
        for (const int sector : {direction, (direction + 3) % 4}) {
            const Index cell = lattice.sector_cell(site, sector);
            if (cell == kNone) continue;
            const Index held = corner(sheet, cell, sector);
            const Index next = corner(sheet, cell, sector == direction ? sector + 1 : sector + 3);
            if (sheet.held[static_cast<std::size_t>(next)] != 0) continue;
            // ½ · ¼ main |2 (..)|²
            plate.clamps.push_back({held, next, main ? plate.main : plate.cross, step});
        }
    }
}

double least(const std::vector<double>& of, std::initializer_list<Index> nodes) {
    double smallest = 1.0;
    for (const Index n : nodes)
        smallest = std::min(smallest, of[static_cast<std::size_t>(n)]);
    return smallest;
}

}  // namespace

Rigidity flexural_rigidity(const PaperParams& paper, const PlateParams& plate) {
    const double h = caliper(paper);
    const double per_modulus = h * h * h / (12.0 * (1.0 - plate.poisson * plate.poisson));
    Rigidity d;
    d.main = plate.rigidity_main > 0 ? plate.rigidity_main : plate.youngs_main * per_modulus;
    d.cross = plate.rigidity_cross > 0 ? plate.rigidity_cross : plate.youngs_cross * per_modulus;
    const double mean = std::sqrt(d.main * d.cross);
    d.coupling = plate.poisson * mean;
    d.twist = 0.5 * (1.0 - plate.poisson) * mean;
    return d;
}

Plate make_plate(const SheetPlan& plan, const Lattice& lattice, const PaperParams& paper,
                 const PlateParams& params) {
    Plate plate;
    plate.rigidity = flexural_rigidity(paper, params);
    plate.clamped = params.clamped;
    const double dx = lattice.column_spacing, dz = lattice.row_spacing, area = dx * dz;
    plate.step = {dx * plan.main, dz * plan.cross};
    plate.main = area * plate.rigidity.main / (dx * dx * dx * dx);
    plate.coupling = area * plate.rigidity.coupling / (dx * dx * dz * dz);
    plate.cross = area * plate.rigidity.cross / (dz * dz * dz * dz);
    plate.twist = area * 4.0 * plate.rigidity.twist / (dx * dx * dz * dz);
    return plate;
}

void rebuild_plate(const Lattice& lattice, const SheetState& sheet, Plate& plate) {
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    plate.share.assign(sites, 0.0);
    plate.cell_share.assign(sites, 0.0);
    plate.elements.clear();
    plate.cells.clear();
    plate.clamps.clear();
    for (Index site = 0; site < lattice.site_count(); ++site) {
        add_elements_of(lattice, sheet, site, plate);
        if (plate.clamped && sheet.held[static_cast<std::size_t>(site)] != 0)
            add_clamps_of(lattice, sheet, site, plate);
        const Index cell = lattice.sector_cell(site, 0);
        if (cell == kNone) continue;
        const Quad& nodes = sheet.quads[static_cast<std::size_t>(cell)];
        const Index below = lattice.neighbour(site, 1);
        if (nodes == Quad{site, site + 1, below + 1, below}) {
            plate.cell_share[static_cast<std::size_t>(site)] = 1.0;
        } else {
            plate.cells.push_back({nodes, site});
        }
    }
    plate.topology_version = sheet.topology_version;
}

void weaken_plate(const Lattice& lattice, const SheetState& sheet, const Params& params,
                  Plate& plate) {
    const std::size_t nodes = sheet.mass.size();
    const double burnt = params.springs.follows_mass ? 1.0 - params.plate.char_rigidity : 0.0;
    const double slope = burnt / (1.0 - params.burning.residual_mass);
    std::vector<double>& left = plate.node_left;
    left.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        const bool paper = sheet.initial_mass[n] > 0;
        const double gone = paper ? slope * (1.0 - sheet.mass[n] / sheet.initial_mass[n]) : 0.0;
        left[n] = std::max(0.0, 1.0 - gone);
    }
    plate.left = plate.share;
    plate.cell_left = plate.cell_share;
    for (Index site = 0; site < lattice.site_count(); ++site) {
        const auto i = static_cast<std::size_t>(site);
        const Index below = lattice.neighbour(site, 1);
        if (plate.share[i] > 0) {
            plate.left[i] =
                least(left, {site, site - 1, site + 1, lattice.neighbour(site, 3), below});
        }
        if (plate.cell_share[i] > 0)
            plate.cell_left[i] = least(left, {site, site + 1, below, below + 1});
    }
    for (PlateElement& e : plate.elements)
        e.left = least(left, {e.centre, e.west, e.east, e.north, e.south});
    for (PlateCell& c : plate.cells)
        c.left = least(left, {c.nodes[0], c.nodes[1], c.nodes[2], c.nodes[3]});
    for (PlateClamp& c : plate.clamps)
        c.left = least(left, {c.held, c.next});
}

double built_curvature(const Lattice& lattice) {
    if (!lattice.closed) return 0.0;
    return -2.0 * ember::sin(std::numbers::pi / lattice.row_count) / lattice.row_spacing;
}

}  // namespace ember
