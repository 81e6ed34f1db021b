#include "sim/node_tiles.h"

namespace ember {
namespace {
constexpr Index kTileRows = 2, kTileColumns = 4;
}

void group_nodes(const Lattice& lattice, const SheetState& sheet, NodeTiles& tiles) {
    const Index per_row = (lattice.column_count + kTileColumns - 1) / kTileColumns;
    const Index count = per_row * ((lattice.row_count + kTileRows - 1) / kTileRows);
    const auto tile_of = [&](std::size_t node) {
        const Index site = sheet.site[node];
        return static_cast<std::size_t>(lattice.row_of(site) / kTileRows * per_row +
                                        lattice.column_of(site) / kTileColumns);
    };
    // counting sort; each tile begins at a multiple of kLanes
    std::vector<std::size_t> next(static_cast<std::size_t>(count) + 1, 0);
    for (std::size_t n = 0; n < sheet.site.size(); ++n) {
        if (sheet.held[n] == 0) ++next[tile_of(n)];
    }
    std::size_t begin = 0;
    for (std::size_t& entry : next) {
        const std::size_t nodes = entry;
        entry = begin;
        begin += (nodes + kLanes - 1) / kLanes * kLanes;
    }
    tiles.node.assign(begin, kNone);
    for (std::size_t n = 0; n < sheet.site.size(); ++n) {
        if (sheet.held[n] == 0) tiles.node[next[tile_of(n)]++] = static_cast<Index>(n);
    }
    tiles.topology_version = sheet.topology_version;
}

}  // namespace ember
