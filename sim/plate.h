// Flexural rigidity: what makes paper bend like paper and not like cloth (beyond the paper, which
// has only springs over two cells; those have no bending stiffness that a finer lattice keeps).
//
// The sheet is an orthotropic plate that bends without stretching. Its energy per area is
//
//     ½ D_x |r_x|² + D_1 r_x·r_z + ½ D_z |r_z|² + 2 D_xz |r_xz|²,
//     r_x = x_uu - κ_x n,  r_z = x_ww - κ_z n,  r_xz = x_uw - κ_xz n
//
// (Timoshenko and Woinowsky-Krieger 1959, sec. 85) with u along the main direction, w across it, n
// the unit normal x_u × x_w / |..|, and the curvatures κ at rest. On a sheet that keeps its lengths
// the second derivatives of the position are normal to it and their lengths are the curvatures, so
// that for κ = 0 the energy of large bending is quadratic in the positions, and no rigid motion
// changes it for any κ.
//
// x_uu and x_ww are second differences over three nodes in a line, together in one element around
// their middle node; x_uw is the twist of a cell. An element of a site within the sheet is a
// stencil; those at borders and cuts are listed. A quarter of an element's area is that of each of
// its quads, and a quarter bends along a line if the quads on the same side of it share the middle
// node: the rule for bending springs (spring_network.h), so there is no moment across a crack.
// Where only one of the two lines goes on, the other moment is free to vanish, which leaves
// D (1 - D_1²/(D_x D_z)) of the rigidity along the line.
#pragma once

#include <array>
#include <vector>

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/scene.h"
#include "sim/world_state.h"

namespace ember {

/// Flexural rigidities D_x, D_1, D_z, D_xz [N m].
struct Rigidity {
    double main = 0, coupling = 0, cross = 0, twist = 0;
    [[nodiscard]] bool any() const { return main > 0 || cross > 0; }
};

/// D = E h³ / 12 (1 - ν²) along and across the main direction, h the caliper, or those that
/// `plate` sets directly; D_1 = ν √(D_x D_z), and D_xz = (1 - ν)/2 √(D_x D_z), which is isotropic
/// where D_x = D_z (Huber 1923).
[[nodiscard]] Rigidity flexural_rigidity(const PaperParams& paper, const PlateParams& plate);

/// Bends the lines of nodes west - centre - east (main) and north - centre - south (cross).
struct PlateElement {
    Index centre, west, east, north, south;  ///< nodes; the centre again where the line ends
    Index site;
    /// [N/m] energies of second differences [m]: ½ main |·|², coupling, ½ cross |·|²
    double main, coupling, cross;
    double left = 1;  ///< [1] share that is left of them
};

/// Twist of a cell, corners as in a Quad.
struct PlateCell {
    Quad nodes;
    Index site;  ///< of its first corner
    double left = 1;
};

/// A held node at a border keeps the slope of the sheet, as a clip does: a mirrored node beyond
/// the border makes the second difference 2 (next - held - offset).
struct PlateClamp {
    Index held, next;
    double stiffness;  ///< [N/m] of ½ · |next - held - offset|²
    Vector3 offset;    ///< [m]
    double left = 1;
};

/// The elements of a sheet as it is now; empty without rigidity.
struct Plate {
    Rigidity rigidity;
    bool clamped = true;
    std::array<Vector3, 2> step{};  ///< [m] from a held node to the next, main and cross
    /// [N/m] energies of second differences of a whole element, and of the twist x00-x01-x10+x11.
    double main = 0, coupling = 0, cross = 0, twist = 0;
    std::vector<double> share;       ///< [1] dense elements: 1 where there is one, S
    std::vector<double> cell_share;  ///< [1] dense cells, by the site of their first corner, S
    std::vector<PlateElement> elements;
    std::vector<PlateCell> cells;
    std::vector<PlateClamp> clamps;
    // for the present masses; see weaken_plate()
    std::vector<double> left, cell_left;  ///< [1] shares that are left, S
    std::vector<double> node_left;        ///< [1] of each node, N
    std::uint64_t topology_version = ~0ull;

    [[nodiscard]] bool stiff() const { return rigidity.any(); }
};

/// The plate of `plan`; its elements come with rebuild_plate().
[[nodiscard]] Plate make_plate(const SheetPlan& plan, const Lattice& lattice,
                               const PaperParams& paper, const PlateParams& params);

/// Finds the elements of the sheet's quads and glue.
void rebuild_plate(const Lattice& lattice, const SheetState& sheet, Plate& plate);

/// Sets what the present masses leave of the rigidity: of an element as much as of its weakest
/// node, from 1 unburnt in proportion to the mass down to plate.char_rigidity at
/// burning.residual_mass. Without springs.follows_mass, all of it.
void weaken_plate(const Lattice& lattice, const SheetState& sheet, const Params& params,
                  Plate& plate);

/// Curvature across the main direction of a tube as built [1/m]; negative, since its normal points
/// outwards. 0 for a flat sheet.
[[nodiscard]] double built_curvature(const Lattice& lattice);

/// Calls visit(element) for every element, those in the stencil too, that has some rigidity left.
template <class Visitor>
void for_each_element(const Lattice& lattice, const Plate& plate, Visitor&& visit) {
    const Index columns = lattice.column_count;
    for (Index row = 0; row < lattice.row_count; ++row) {
        const Index above = lattice.row_at(row, -1), below = lattice.row_at(row, 1);
        for (Index c = 1; c + 1 < columns; ++c) {
            const Index i = lattice.site(row, c);
            const double left = plate.left[static_cast<std::size_t>(i)];
            if (left > 0) {
                visit(PlateElement{i, i - 1, i + 1, lattice.site(above, c), lattice.site(below, c),
                                   i, plate.main, plate.coupling, plate.cross, left});
            }
        }
    }
    for (const PlateElement& element : plate.elements) {
        if (element.left > 0) visit(element);
    }
}

/// Calls visit(cell) for every cell, those in the stencil too, that has some rigidity left.
template <class Visitor>
void for_each_cell(const Lattice& lattice, const Plate& plate, Visitor&& visit) {
    for (Index row = 0; row < lattice.row_count; ++row) {
        const Index below = lattice.row_at(row, 1);
        for (Index c = 0; c + 1 < lattice.column_count; ++c) {
            const Index i = lattice.site(row, c);
            const double left = plate.cell_left[static_cast<std::size_t>(i)];
            if (!(left > 0)) continue;
            const Index j = lattice.site(below, c);
            visit(PlateCell{{i, i + 1, j + 1, j}, i, left});
        }
    }
    for (const PlateCell& cell : plate.cells) {
        if (cell.left > 0) visit(cell);
    }
}

}  // namespace ember
