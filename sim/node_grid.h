// Nodes of all sheets by cubic cells of space, through a table of buckets that far cells share, so
// that its size does not depend on how far nodes are strewn. Nodes stand where they will be at half
// the tick.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/swept_box.h"

namespace ember {

/// One sheet as the search for contacts sees it.
struct SheetInSpace {
    const Lattice* lattice;
    const SheetState* sheet;
};

/// A node of a sheet, by number.
struct SheetNode {
    Index sheet, node;
};

class NodeGrid {
  public:
    /// The nodes to be sorted in; changing them needs another fill().
    std::vector<SheetNode> nodes;

    /// Sorts `nodes`, which move on for `dt` [s], into cells of `size` [m].
    void fill(std::span<const SheetInSpace> sheets, double size, double dt);

    /// Calls visit(node) for all nodes whose path may come within `reach` [m] of `box`, and for
    /// others, each at most once.
    template <class Visitor>
    void visit(const SweptBox& box, double reach, Visitor&& visit) const {
        std::array<Index, 3> low, high, at;
        double cells = 1;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = place(box.low[axis] - reach - half_path_);
            high[axis] = place(box.high[axis] + reach + half_path_);
            cells *= 1.0 + high[axis] - low[axis];
        }
        if (cells > static_cast<double>(nodes.size())) {
            for (const SheetNode& node : nodes)
                visit(node);
            return;
        }
        for (at[0] = low[0]; at[0] <= high[0]; ++at[0]) {
            for (at[1] = low[1]; at[1] <= high[1]; ++at[1]) {
                for (at[2] = low[2]; at[2] <= high[2]; ++at[2])
                    visit_cell(at, visit);
            }
        }
    }

  private:
    template <class Visitor>
    void visit_cell(const std::array<Index, 3>& cell, Visitor& visit) const {
        const std::size_t b = bucket(cell);
        for (Index k = bucket_begin_[b]; k < bucket_begin_[b + 1]; ++k) {
            const auto i = static_cast<std::size_t>(bucketed_[static_cast<std::size_t>(k)]);
            if (cell_[i] == cell) visit(nodes[i]);
        }
    }
    [[nodiscard]] Index place(double x) const;
    [[nodiscard]] std::size_t bucket(const std::array<Index, 3>& cell) const;

    std::vector<std::array<Index, 3>> cell_;  ///< of each node
    std::vector<Index> bucket_begin_;         ///< 2^k + 1 places in `bucketed_`
    std::vector<Index> bucketed_;             ///< node numbers, by bucket
    double per_metre_ = 1, half_path_ = 0;    ///< [1/m], [m] longest half path along an axis
    std::size_t mask_ = 0;
};

}  // namespace ember
