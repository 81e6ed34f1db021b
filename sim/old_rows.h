// Copies of the rows beside the places where a sweep over a sheet is split.
//
// A leapfrog step moves nodes in place, row after row. The springs anchored in a row reach the two
// rows below, which are still where they were; except in the last two rows of a part of the sheet,
// as the part below is another thread's, and in the two rows above a part, which it evaluates too.
// For these, the rows around each such place are kept as they were before the step.
#pragma once

#include <vector>

#include "sim/lattice.h"
#include "sim/spring_forces.h"

namespace ember {

class OldRows {
  public:
    std::vector<Index> splits;  ///< rows at which parts begin

    /// Copies the rows around each split from the present motion.
    void prepare(const Lattice& lattice, const NodeMotion& motion);

    /// The motion for the springs anchored at `row`, and the index that the row has in it; without
    /// nodes when the row needs no copies.
    struct View {
        NodeMotion motion;
        Index row;
    };
    [[nodiscard]] View find(Index row) const;

    /// Keeps what has become of a row, if it is beside a split, for the next step. To be called by
    /// the thread that moved the row.
    void keep(Index row, const NodeMotion& motion);

    /// To be called between steps: what was kept is old now.
    void turn() { old_ = 1 - old_; }

  private:
    // Vectors read a little beyond a row, so that the third row above a split would touch the rows
    // of another thread too, if only to multiply them by 0.
    static constexpr Index kAbove = 3, kBelow = 2, kRows = kAbove + kBelow;
    struct Copies {
        Index first;                  // row; may be negative on a closed sheet
        std::vector<double> kept[2];  // x, y, z, u, v, w of kRows rows; padded as all motions
    };
    void copy(Index row, const NodeMotion& motion, int into);
    // How far `row` is below `first`, going round a closed sheet.
    [[nodiscard]] Index below(Index first, Index row) const {
        const Index distance = row - first;
        return closed_ ? (distance + row_count_) % row_count_ : distance;
    }

    std::vector<Copies> copies_;
    Index row_count_ = 0, columns_ = 0;
    bool closed_ = false;
    std::size_t stride_ = 0;  // between components
    int old_ = 0;
};

}  // namespace ember
