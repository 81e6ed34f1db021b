// The lattice of one sheet as it was made: sites, cells, and the six spring slots of each site.
//
//        column →  (main direction x)            slots anchored at site (r, c):
//      (r,c)───Main───(r,c+1)──────(r,c+2)        Main      (r,c)   – (r,c+1)    structural
//   row  │ ╲        ╱ │                           Cross     (r,c)   – (r+1,c)    structural
//    ↓ Cross Diag↘  ╳ │                           DiagDown  (r,c)   – (r+1,c+1)  diagonal
//   (z)  │ ╱        ╲ │                           DiagUp    (r,c+1) – (r+1,c)    diagonal
//      (r+1,c)─────(r+1,c+1)                      BendMain  (r,c)   – (r,c+2)    bending
//                                                 BendCross (r,c)   – (r+2,c)    bending
//
// Slot number = slot kind × site count + anchor site, so each kind is one dense array over sites.
// Slots that would leave the sheet exist and have stiffness 0. Never changes after it is built.
#pragma once

#include <array>
#include <vector>

#include "sim/params.h"
#include "sim/scene.h"
#include "sim/types.h"
#include "sim/world_view.h"

namespace ember {

enum class Slot : std::uint8_t { Main, Cross, DiagDown, DiagUp, BendMain, BendCross };
inline constexpr Index kSlotCount = 6;

[[nodiscard]] constexpr SpringKind spring_kind(Slot slot) {
    if (slot == Slot::Main || slot == Slot::Cross) return SpringKind::Structural;
    return slot == Slot::DiagDown || slot == Slot::DiagUp ? SpringKind::Diagonal
                                                          : SpringKind::Bending;
}

/// Sheet geometry and unburnt spring constants.
struct Lattice {
    Index row_count = 0, column_count = 0;  ///< sites
    Index cell_rows = 0, cell_columns = 0;  ///< quads; cell_rows == row_count when closed
    Index cell_count = 0;                   ///< of these, cells that are paper
    std::vector<Index> cell_number;         ///< of each cell, kNone in a hole; empty: no holes
    bool closed = false;                    ///< the last row is followed by the first
    Border border = Border::Tributary;
    double row_spacing = 0;                       ///< [m] d1, cross direction
    double column_spacing = 0;                    ///< [m] d2, main direction
    double node_weight = 0;                       ///< [kg] sheet mass / number of sites
    std::vector<double> stiffness;                ///< [N/m] of each slot where whole, 6×S
    std::vector<double> damping;                  ///< [kg/s], 6×S
    std::vector<double> initial_length;           ///< [m], 6×S
    std::vector<std::array<Index, 2>> slot_ends;  ///< end sites, {kNone, kNone} outside, 6×S
    std::array<double, 2> edge_conductance{};     ///< [W/K] of a whole main and cross edge

    [[nodiscard]] Index site_count() const { return row_count * column_count; }
    [[nodiscard]] Index site(Index row, Index column) const { return row * column_count + column; }
    [[nodiscard]] Index row_of(Index site) const { return site / column_count; }
    [[nodiscard]] Index column_of(Index site) const { return site % column_count; }
    /// Row `offset` after `row`, around the seam if there is one; kNone outside the sheet.
    [[nodiscard]] Index row_at(Index row, Index offset) const {
        const Index r = row + offset;
        if (r >= 0 && r < row_count) return r;
        return closed ? (r + row_count) % row_count : kNone;
    }
    [[nodiscard]] Index slot(Slot kind, Index anchor) const {
        return static_cast<Index>(kind) * site_count() + anchor;
    }
    /// The cell whose first corner is (row, column), or kNone outside the paper.
    [[nodiscard]] Index cell(Index row, Index column) const {
        const Index r = closed ? (row + row_count) % row_count : row;
        const bool inside = r >= 0 && r < cell_rows && column >= 0 && column < cell_columns;
        if (!inside) return kNone;
        const Index at = r * cell_columns + column;
        return cell_number.empty() ? at : cell_number[static_cast<std::size_t>(at)];
    }
    /// Whether the site has any paper around it.
    [[nodiscard]] bool has_paper(Index site) const;
    /// Cell in sector k around a site: 0 between +x and +z, then on from +z to -x, and so forth.
    /// The site is that cell's corner number k.
    [[nodiscard]] Index sector_cell(Index site, int sector) const;
    /// Neighbour in direction d: 0 +x (column+1), 1 +z (row+1), 2 -x, 3 -z; kNone outside.
    [[nodiscard]] Index neighbour(Index site, int direction) const;
    /// The two end sites of a slot; {kNone, kNone} when it would leave the sheet.
    [[nodiscard]] std::array<Index, 2> ends(Slot kind, Index anchor) const {
        return slot_ends[static_cast<std::size_t>(slot(kind, anchor))];
    }
};

/// Calls visit(count, a, b, slot) for every kind of springs anchored at a row: `count` springs
/// between nodes a+i and b+i whose slots are slot+i. Springs without stiffness are among them.
template <class Visitor>
void for_springs_of_row(const Lattice& lattice, Index row, Visitor&& visit) {
    for (int k = 0; k < kSlotCount; ++k) {
        const auto kind = static_cast<Slot>(k);
        const bool across = kind == Slot::Cross || kind == Slot::BendCross;
        const Index count = lattice.column_count - (across ? 0 : kind == Slot::BendMain ? 2 : 1);
        const Index anchor = lattice.site(row, 0);
        const auto [a, b] = lattice.ends(kind, anchor);
        if (count > 0 && a != kNone)
            visit(count, a, b, static_cast<std::size_t>(lattice.slot(kind, anchor)));
    }
}

/// Builds the lattice of `plan`. Spring constants are those of section 4.1 times stiffness_scale,
/// with the random variation of structural springs from fibre to fibre (figure 3).
/// `sheet` numbers the sheet in the scene, so that sheets differ.
[[nodiscard]] Lattice make_lattice(const SheetPlan& plan, const PaperParams& paper,
                                   const SpringParams& springs, std::uint64_t seed,
                                   std::size_t sheet);

/// Stiffness of the paper's structural springs on its own A4 lattice [N/m]: 7e3 · G · A_ref with
/// A_ref = 0.21·0.297/(33·49) m². This is k_s of eq. 4 whatever the lattice.
[[nodiscard]] double reference_stiffness(double grammage, double per_weight = 7e3);

}  // namespace ember
