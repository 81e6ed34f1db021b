#include "render/quantity.h"

#include <algorithm>

namespace ember {

std::vector<float> node_quantity(ViewMode mode, const SheetView& sheet,
                                 std::span<const SpringSegment> springs) {
    std::vector<float> values;
    const auto fill = [&](auto&& value) {
        for (std::size_t n = 0; n < sheet.x.size(); ++n)
            values.push_back(static_cast<float>(value(n)));
    };
    if (mode == ViewMode::Temperature) fill([&](auto n) { return sheet.temperature[n] - 273.15; });
    if (mode == ViewMode::Mass) {
        fill([&](auto n) {  // of what is no paper nothing is drawn
            return sheet.initial_mass[n] > 0 ? sheet.mass[n] / sheet.initial_mass[n] : 1.0;
        });
    }
    if (mode == ViewMode::State) fill([&](auto n) { return static_cast<int>(sheet.phase[n]); });
    if (mode == ViewMode::Stress) {
        std::vector<int> count(sheet.x.size(), 0);
        values.assign(sheet.x.size(), 0.0f);
        for (const SpringSegment& spring : springs) {
            if (spring.kind != SpringKind::Structural) continue;
            for (const Index node : {spring.a, spring.b}) {
                const auto n = static_cast<std::size_t>(node);
                values[n] += static_cast<float>(1e-3 * spring.stress);
                ++count[n];
            }
        }
        for (std::size_t n = 0; n < values.size(); ++n)
            values[n] /= static_cast<float>(std::max(count[n], 1));
    }
    return values;
}

}  // namespace ember
