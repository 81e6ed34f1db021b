// How far every site of a lattice is from a front, along the unburnt sheet: pure.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sim/types.h"

namespace ember {

/// The sites of a sheet as a grid; row-major, columns along the main direction.
struct SiteGrid {
    Index rows = 0, columns = 0;
    bool closed = false;           ///< the last row is followed by the first
    double across = 0, along = 0;  ///< [mm] between rows and between columns
    [[nodiscard]] std::size_t site(Index row, Index column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
};

inline constexpr float kFarthest = 200.0f;  ///< [mm] distances are cut off here

/// Signed distance [mm] of each site from the curve where `level` changes its sign: positive where
/// level >= 0. The curve crosses an edge of the grid where level, linear along it, is 0. Solves
/// |grad d| = 1 by fast sweeping (Zhao, Math. Comp. 74, 2005), first order in the spacing; exact
/// for straight fronts along the grid. Without a front everything is kFarthest away.
[[nodiscard]] std::vector<float> front_distance(const SiteGrid& grid, std::span<const float> level);

}  // namespace ember
