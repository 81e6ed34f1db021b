#include "render/torn_edges.h"

#include <algorithm>

namespace ember {

std::vector<std::array<double, 2>> torn_edge_shifts(const SheetView& sheet) {
    std::vector<std::array<double, 2>> shifts;
    if (sheet.crack_x.empty()) return shifts;
    const double half_x = 0.5 * sheet.height / (sheet.column_count - 1);
    const double half_z =
        0.5 * sheet.width / (sheet.closed ? sheet.row_count : sheet.row_count - 1);
    const Index last_row = sheet.row_count - 1, last_column = sheet.column_count - 1;
    shifts.reserve(sheet.site.size());
    for (const Index site : sheet.site) {
        const auto s = static_cast<std::size_t>(site);
        const Index row = site / sheet.column_count, column = site % sheet.column_count;
        // the outline of the sheet stays what it is
        const bool end = column == 0 || column == last_column;
        const bool side = !sheet.closed && (row == 0 || row == last_row);
        shifts.push_back({end ? 0.0 : std::clamp(sheet.crack_x[s], -half_x, half_x),
                          side ? 0.0 : std::clamp(sheet.crack_z[s], -half_z, half_z)});
    }
    return shifts;
}

std::vector<Vector3> torn_positions(const SheetView& sheet,
                                    std::span<const std::array<double, 2>> shifts) {
    if (shifts.empty()) return {};
    const double hx = sheet.height / (sheet.column_count - 1);
    const double hz = sheet.width / (sheet.closed ? sheet.row_count : sheet.row_count - 1);
    const auto at = [&](Index node) {
        const auto n = static_cast<std::size_t>(node);
        return Vector3(sheet.x[n], sheet.y[n], sheet.z[n]);
    };
    std::vector<Vector3> moved(shifts.size(), Vector3(Vector3::Zero()));
    std::vector<double> quads(shifts.size(), 0.0);
    for (const Quad& q : sheet.quads) {
        for (int k = 0; k < 4; ++k) {
            const auto corner = [&](int i) { return q[static_cast<std::size_t>(i)]; };
            const auto n = static_cast<std::size_t>(corner(k));
            const auto& s = shifts[n];
            quads[n] += 1.0;
            if (s[0] == 0 && s[1] == 0) continue;
            // edges of the quad at this corner, along the main and the cross direction
            const Vector3 along = (at(corner(k ^ 1)) - at(corner(k))) / (k % 3 == 0 ? hx : -hx);
            const Vector3 across = (at(corner(3 - k)) - at(corner(k))) / (k < 2 ? hz : -hz);
            moved[n] += s[0] * along + s[1] * across;
        }
    }
    for (std::size_t n = 0; n < moved.size(); ++n)
        moved[n] = at(static_cast<Index>(n)) + (quads[n] > 0 ? moved[n] / quads[n] : moved[n]);
    return moved;
}

}  // namespace ember
