// Conduction between the first copies of sites (section 4.2, eq. 2) as an operator on the lattice.
//
//     C_i dT_i/dt = Σ_j g_ij (T_j - T_i)
//
// with the conductance g of every structural spring between i and its up to four neighbours, and
// C_i = c_s c m_i of the unburnt mass m_i. A cut edge has g = 0. Around a closed sheet the last row
// is followed by the first.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/lattice.h"
#include "sim/params.h"
#include "sim/spring_network.h"
#include "sim/world_state.h"

namespace ember {

/// Conductances and capacities of one sheet as it is now; follows the topology only.
struct Conduction {
    Index row_count = 0, column_count = 0;
    bool closed = false;
    std::vector<double> main, cross;   ///< [W/K] g of the edges to column+1 and to row+1, S
    std::vector<double> per_capacity;  ///< [K/J] 1/C, S
    std::vector<double> none;          ///< zeros: the conductances beyond the border, one row
    double most_per_capacity = 0;      ///< [1/s] largest Σ g / C of any site; of both directions
    double most_main = 0, most_cross = 0;  ///< [1/s] ... and of one direction each
    // where the sheet is as it was made, one number stands for a whole array
    double even_main = 0, even_cross = 0;           ///< [1/s] g/C of the greatest part of the sheet
    std::vector<std::uint8_t> even;                 ///< per row and tile column: all g/C are those
    Index model_row = kNone, model_column = kNone;  ///< lines that most others equal, if any
    std::vector<std::uint8_t> row_as_model, column_as_model;  ///< which lines equal them
    std::uint64_t topology_version = ~0ull;

    [[nodiscard]] std::size_t row_begin(Index row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(column_count);
    }
    /// The rows before and after `row`; `row` itself where there is none (then g = 0).
    [[nodiscard]] Index row_above(Index row) const {
        return row > 0 ? row - 1 : (closed ? row_count - 1 : row);
    }
    [[nodiscard]] Index row_below(Index row) const {
        return row + 1 < row_count ? row + 1 : (closed ? 0 : row);
    }
    /// Conductances to the row above; zeros where there is none.
    [[nodiscard]] const double* cross_above(Index row) const {
        return row > 0 || closed ? &cross[row_begin(row_above(row))] : none.data();
    }
};

/// Heat capacity of a node [J/K] = c_s · c · unburnt mass: eq. 2 per node.
[[nodiscard]] inline double heat_capacity(const PaperParams& paper, double initial_mass) {
    return paper.c_s * paper.specific_heat * initial_mass;
}

/// Fills `conduction` for the present topology.
void rebuild_conduction(const Lattice& lattice, const SheetState& sheet,
                        const SpringNetwork& network, const PaperParams& paper,
                        Conduction& conduction);

}  // namespace ember
