#include "sim/border_edges.h"

#include <algorithm>

namespace ember {

void find_border_edges(const SheetState& sheet, BorderEdges& border) {
    if (border.topology_version == sheet.topology_version) return;
    border.topology_version = sheet.topology_version;
    border.sides.clear();
    for (const Quad& quad : sheet.quads) {
        for (std::size_t k = 0; k < 4; ++k) {
            const Index a = quad[k], b = quad[(k + 1) % 4];
            border.sides.push_back({std::min(a, b), std::max(a, b), a, b});
        }
    }
    std::sort(border.sides.begin(), border.sides.end());
    border.ends.clear();
    for (std::size_t i = 0; i < border.sides.size();) {
        const auto& side = border.sides[i];
        std::size_t next = i + 1;
        while (next < border.sides.size() && border.sides[next][0] == side[0] &&
               border.sides[next][1] == side[1]) {
            ++next;
        }
        if (next == i + 1) border.ends.push_back({side[2], side[3]});
        i = next;
    }
    std::sort(border.ends.begin(), border.ends.end());
    border.first.assign(sheet.mass.size() + 1, 0);
    for (const auto& edge : border.ends)
        ++border.first[static_cast<std::size_t>(edge[0]) + 1];
    for (std::size_t n = 0; n < sheet.mass.size(); ++n)
        border.first[n + 1] += border.first[n];
}

}  // namespace ember
