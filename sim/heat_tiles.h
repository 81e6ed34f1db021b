// Which parts of a sheet heat can be in: tiles of 8 rows by 16 columns, and the field that solvers
// write to, which is at ambient wherever no tile is active.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/heat_conduction.h"
#include "sim/types.h"

namespace ember {

inline constexpr Index kTileRows = 8, kTileColumns = 16;

[[nodiscard]] constexpr Index tile_rows(Index rows) {
    return (rows + kTileRows - 1) / kTileRows;
}
[[nodiscard]] constexpr Index tile_columns(Index columns) {
    return (columns + kTileColumns - 1) / kTileColumns;
}

/// Columns first..last-1 of a row; even: all conductances per capacity are the sheet's usual ones.
struct HeatSegment {
    Index first, last;
    bool even;
};

struct HeatTiles {
    Index row_count = 0, column_count = 0;   ///< tiles
    std::vector<std::uint8_t> warm, active;  ///< per tile
    std::vector<HeatSegment> segments;       ///< the active part of every lattice row, in order
    std::vector<std::size_t> begin;          ///< row r has segments begin[r] .. begin[r+1]
    std::int64_t nodes = 0;                  ///< sites in active tiles
    bool all = false;                        ///< every tile is active
};

/// Makes room for the sheet; all tiles inactive.
void resize_tiles(const Conduction& op, HeatTiles& tiles);

/// Marks as warm the tiles that hold any temperature other than ambient. Returns whether any does.
/// within_active: only active tiles can be warm, look at no others.
bool find_warm_tiles(const Conduction& op, const std::vector<double>& temperature, double ambient,
                     bool within_active, HeatTiles& tiles);

/// Makes active all tiles within `rings` tiles of a warm one, or all there are; fills the segments.
void activate_tiles(const Conduction& op, Index rings, bool all, HeatTiles& tiles);

/// Temperatures that a solver writes: ambient in all tiles that are not `touched`.
struct HeatField {
    std::vector<double> value;          ///< [K], N
    std::vector<std::uint8_t> touched;  ///< per tile
    double ambient = -1;                ///< [K]
};

/// Brings `field` to ambient outside the active tiles; inside its contents are arbitrary. Copies
/// of sites, which do not conduct, take their value from `temperature`.
void prepare_field(const Conduction& op, const HeatTiles& tiles,
                   const std::vector<double>& temperature, double ambient, HeatField& field);

/// Lowest and highest temperature [K].
struct HeatRange {
    double low, high;

    void include(double t) {
        low = t < low ? t : low;
        high = t > high ? t : high;
    }
    /// Whether `other` leaves this range by more than rounding: a solver computes a temperature by
    /// some tens of roundings of numbers of that size.
    [[nodiscard]] bool left_by(const HeatRange& other) const {
        const double margin = 64 * 2.220446049250313e-16 * (high > -low ? high : -low);
        return !(other.low >= low - margin && other.high <= high + margin);
    }
};

/// Range over all sites; inactive tiles count as ambient.
[[nodiscard]] HeatRange range_of(const Conduction& op, const HeatTiles& tiles,
                                 const std::vector<double>& temperature, double ambient);

}  // namespace ember
