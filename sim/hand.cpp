#include "sim/hand.h"

namespace ember {

void pull_by_hand(const HandParams& hand, const Lattice& lattice, const SheetState& sheet,
                  NodeLoads& loads) {
    if (hand.row >= lattice.row_count || hand.column >= lattice.column_count) return;
    const auto held = static_cast<std::size_t>(
        lattice.site(static_cast<Index>(hand.row), static_cast<Index>(hand.column)));
    const double omega = 1.0 / hand.response;
    const Vector3 pull =
        omega * omega * (Vector3(hand.x, hand.y, hand.z) - sheet.position.at(held));
    const double reach = hand.radius * hand.radius;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        if (loads.inverse_mass[n] == 0) continue;
        const auto rows = static_cast<double>(lattice.row_of(sheet.site[n]) - hand.row);
        const auto columns = static_cast<double>(lattice.column_of(sheet.site[n]) - hand.column);
        const double across = rows * lattice.row_spacing, along = columns * lattice.column_spacing;
        const double left = 1.0 - (across * across + along * along) / reach;
        if (left <= 0) continue;
        const Vector3 force =
            sheet.mass[n] * left * left * (pull - 2.0 * omega * sheet.velocity.at(n));
        loads.fire.set(n, loads.fire.at(n) + force);
        loads.force.set(n, loads.force.at(n) + force);
    }
}

}  // namespace ember
