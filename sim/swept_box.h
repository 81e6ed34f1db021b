// Boxes that nodes, quads and rows of a sheet sweep while they move on with their velocity.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "sim/lattice.h"
#include "sim/world_state.h"

namespace ember {

/// Axis-aligned box [m]; empty while low > high.
struct SweptBox {
    std::array<double, 3> low, high;

    void include(std::size_t axis, double from, double to) {
        low[axis] = from < low[axis] ? from : low[axis];
        high[axis] = to > high[axis] ? to : high[axis];
    }
    void include(const SweptBox& other) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            include(axis, other.low[axis], other.high[axis]);
    }
};

inline constexpr double kFarAway = std::numeric_limits<double>::infinity();
inline constexpr SweptBox kEmptyBox = {{kFarAway, kFarAway, kFarAway},
                                       {-kFarAway, -kFarAway, -kFarAway}};

/// Whether two boxes come within `reach` [m] of each other along every axis.
[[nodiscard]] bool overlap(const SweptBox& a, const SweptBox& b, double reach);

/// The box of a node, or of the corners of a quad, from now until `dt` [s] later.
[[nodiscard]] SweptBox swept_by_node(const SheetState& sheet, std::size_t node, double dt);
[[nodiscard]] SweptBox swept_by_quad(const SheetState& sheet, std::size_t quad, double dt);

/// The same of all rows with the copies of their nodes, R, along the axes `first` to `last`; other
/// axes stay empty. Returns the box of the whole sheet.
SweptBox swept_by_rows(const Lattice& lattice, const SheetState& sheet, double dt,
                       std::size_t first, std::size_t last, std::vector<SweptBox>& rows);

}  // namespace ember
