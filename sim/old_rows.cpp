#include "sim/old_rows.h"

#include <algorithm>

namespace ember {

void OldRows::prepare(const Lattice& lattice, const NodeMotion& motion) {
    row_count_ = lattice.row_count;
    columns_ = lattice.column_count;
    closed_ = lattice.closed;
    stride_ = static_cast<std::size_t>(kRows * columns_) + kMotionPadding;
    copies_.resize(splits.size());
    for (std::size_t i = 0; i < splits.size(); ++i) {
        copies_[i].first = splits[i] - kAbove;
        for (auto& kept : copies_[i].kept)
            kept.assign(6 * stride_, 0.0);
    }
    for (const Index split : splits) {
        for (Index row = split - kAbove; row < split + kBelow; ++row) {
            const Index r = lattice.row_at(split, row - split);
            if (r == kNone) continue;
            copy(r, motion, 0);
            copy(r, motion, 1);
        }
    }
}

OldRows::View OldRows::find(Index row) const {
    for (const Copies& c : copies_) {
        const Index at = below(c.first, row);
        if (at < 0 || at >= kAbove) continue;
        const double* kept = c.kept[old_].data();
        return {{kept, kept + 3 * stride_, stride_}, at};
    }
    return {};
}

void OldRows::keep(Index row, const NodeMotion& motion) {
    copy(row, motion, 1 - old_);
}

void OldRows::copy(Index row, const NodeMotion& motion, int into) {
    const std::size_t from = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_);
    for (Copies& c : copies_) {
        // around a small tube the same row comes by twice
        for (Index at = below(c.first, row); at >= 0 && at < kRows;
             at += closed_ ? row_count_ : kRows) {
            double* to = c.kept[into].data() +
                         static_cast<std::size_t>(at) * static_cast<std::size_t>(columns_);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t component = axis * motion.node_count + from;
                std::copy_n(motion.x + component, columns_, to + axis * stride_);
                std::copy_n(motion.v + component, columns_, to + (3 + axis) * stride_);
            }
        }
    }
}

}  // namespace ember
