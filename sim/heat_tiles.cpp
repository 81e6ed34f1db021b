#include "sim/heat_tiles.h"

#include <algorithm>
#include <cmath>

#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr Index kLanes = 8;

// Largest |t - ambient| of a tile's row is not needed, only whether it is 0; a sum of comparisons
// has no early exit and vectorises.
EMBER_VECTORISED
bool differs(const double* t, Index count, double ambient) {
    std::int64_t other = 0;
    for (Index c = 0; c < count; ++c)
        other += t[c] != ambient ? 1 : 0;
    return other != 0;
}

bool tile_differs(const Conduction& op, const std::vector<double>& t, double ambient, Index row,
                  Index column) {
    const Index last_row = std::min(op.row_count, (row + 1) * kTileRows);
    const Index first = column * kTileColumns;
    const Index count = std::min(op.column_count - first, kTileColumns);
    for (Index r = row * kTileRows; r < last_row; ++r) {
        if (differs(&t[op.row_begin(r) + static_cast<std::size_t>(first)], count, ambient)) {
            return true;
        }
    }
    return false;
}

// Active tiles of one tile row: those with a warm one at most `rings` away.
void spread(const HeatTiles& tiles, bool closed, Index row, Index rings, std::uint8_t* active) {
    const auto columns = static_cast<std::size_t>(tiles.column_count);
    // the last tile before a seam may be a single row high, so that heat crosses one tile more
    const Index reach = closed ? rings + 1 : rings;
    for (Index k = -reach; k <= reach; ++k) {
        Index from = row + k;
        if (closed) from = ((from % tiles.row_count) + tiles.row_count) % tiles.row_count;
        if (from < 0 || from >= tiles.row_count) continue;
        const std::uint8_t* warm = &tiles.warm[static_cast<std::size_t>(from) * columns];
        for (Index c = 0; c < tiles.column_count; ++c) {
            if (warm[c] == 0) continue;
            const Index last = std::min(tiles.column_count - 1, c + rings);
            for (Index n = std::max(0, c - rings); n <= last; ++n)
                active[n] = 1;
        }
    }
}

void add_segments(const Conduction& op, Index row, HeatTiles& tiles) {
    const auto columns = static_cast<std::size_t>(tiles.column_count);
    const std::uint8_t* active = &tiles.active[static_cast<std::size_t>(row / kTileRows) * columns];
    const std::uint8_t* even = &op.even[static_cast<std::size_t>(row) * columns];
    const std::size_t begin = tiles.segments.size();
    for (Index c = 0; c < tiles.column_count; ++c) {
        if (active[c] == 0) continue;
        const Index first = c * kTileColumns;
        const Index last = std::min(op.column_count, first + kTileColumns);
        tiles.nodes += last - first;
        const bool same = tiles.segments.size() > begin && tiles.segments.back().last == first &&
                          tiles.segments.back().even == (even[c] != 0);
        if (same) {
            tiles.segments.back().last = last;
        } else {
            tiles.segments.push_back({first, last, even[c] != 0});
        }
    }
}

EMBER_VECTORISED
void widen(const double* t, Index count, double* low, double* high) {
    Index c = 0;
    for (; c + kLanes <= count; c += kLanes) {
        for (Index k = 0; k < kLanes; ++k) {
            low[k] = t[c + k] < low[k] ? t[c + k] : low[k];
            high[k] = t[c + k] > high[k] ? t[c + k] : high[k];
        }
    }
    for (; c < count; ++c) {
        low[0] = t[c] < low[0] ? t[c] : low[0];
        high[0] = t[c] > high[0] ? t[c] : high[0];
    }
}

}  // namespace

void resize_tiles(const Conduction& op, HeatTiles& tiles) {
    tiles.row_count = tile_rows(op.row_count);
    tiles.column_count = tile_columns(op.column_count);
    const auto count =
        static_cast<std::size_t>(tiles.row_count) * static_cast<std::size_t>(tiles.column_count);
    tiles.warm.assign(count, 0);
    tiles.active.assign(count, 0);
    tiles.segments.reserve(count * static_cast<std::size_t>(kTileRows));
    tiles.begin.assign(static_cast<std::size_t>(op.row_count) + 1, 0);
}

bool find_warm_tiles(const Conduction& op, const std::vector<double>& temperature, double ambient,
                     bool within_active, HeatTiles& tiles) {
    bool any = false;
    std::size_t tile = 0;
    for (Index r = 0; r < tiles.row_count; ++r) {
        for (Index c = 0; c < tiles.column_count; ++c, ++tile) {
            const bool warm = (!within_active || tiles.active[tile] != 0) &&
                              tile_differs(op, temperature, ambient, r, c);
            tiles.warm[tile] = warm ? 1 : 0;
            any = any || warm;
        }
    }
    return any;
}

void activate_tiles(const Conduction& op, Index rings, bool all, HeatTiles& tiles) {
    std::fill(tiles.active.begin(), tiles.active.end(), all ? 1 : 0);
    if (!all) {
        for (Index r = 0; r < tiles.row_count; ++r) {
            const auto at =
                static_cast<std::size_t>(r) * static_cast<std::size_t>(tiles.column_count);
            spread(tiles, op.closed, r, rings, &tiles.active[at]);
        }
    }
    tiles.segments.clear();
    tiles.nodes = 0;
    for (Index r = 0; r < op.row_count; ++r) {
        add_segments(op, r, tiles);
        tiles.begin[static_cast<std::size_t>(r) + 1] = tiles.segments.size();
    }
    tiles.all = std::find(tiles.active.begin(), tiles.active.end(), 0) == tiles.active.end();
}

void prepare_field(const Conduction& op, const HeatTiles& tiles,
                   const std::vector<double>& temperature, double ambient, HeatField& field) {
    if (field.value.size() != temperature.size() || field.touched.size() != tiles.active.size() ||
        field.ambient != ambient) {
        field.value.assign(temperature.size(), ambient);
        field.touched.assign(tiles.active.size(), 0);
        field.ambient = ambient;
    }
    const auto sites = static_cast<std::ptrdiff_t>(op.main.size());
    std::copy(temperature.begin() + sites, temperature.end(), field.value.begin() + sites);
    for (std::size_t tile = 0; tile < tiles.active.size(); ++tile) {
        if (field.touched[tile] == 0 || tiles.active[tile] != 0) continue;
        const Index row = static_cast<Index>(tile) / tiles.column_count * kTileRows;
        const Index column = static_cast<Index>(tile) % tiles.column_count * kTileColumns;
        const Index count = std::min(op.column_count - column, kTileColumns);
        for (Index r = row; r < std::min(op.row_count, row + kTileRows); ++r) {
            const auto at = op.row_begin(r) + static_cast<std::size_t>(column);
            std::fill_n(field.value.begin() + static_cast<std::ptrdiff_t>(at), count, ambient);
        }
    }
    field.touched = tiles.active;
}

HeatRange range_of(const Conduction& op, const HeatTiles& tiles,
                   const std::vector<double>& temperature, double ambient) {
    const double start = tiles.all || tiles.segments.empty() ? temperature[0] : ambient;
    double low[kLanes], high[kLanes];
    std::fill(low, low + kLanes, start);
    std::fill(high, high + kLanes, start);
    for (Index row = 0; row < op.row_count; ++row) {
        const auto r = static_cast<std::size_t>(row);
        for (std::size_t s = tiles.begin[r]; s < tiles.begin[r + 1]; ++s) {
            const HeatSegment& segment = tiles.segments[s];
            widen(&temperature[op.row_begin(row) + static_cast<std::size_t>(segment.first)],
                  segment.last - segment.first, low, high);
        }
    }
    return {*std::min_element(low, low + kLanes), *std::max_element(high, high + kLanes)};
}

}  // namespace ember
