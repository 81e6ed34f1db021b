#include "render/flame_lights.h"

#include <algorithm>
#include <vector>

namespace ember {

FlameLights gather_flame_lights(const FireCells& fire) {
    constexpr double kPerParticle = 1.0 / 900;  // strength 1: a handful of burning paper
    using Corner = FireCells::Corner;
    std::vector<Corner> strongest;
    double total = 0, kept = 0;
    for (const auto& [place, corner] : fire.corners()) {
        if (!(corner.light > 0)) continue;
        strongest.push_back(corner);
        total += corner.light;
    }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const Corner& a, const Corner& b) { return a.light > b.light; });
    // the first that is left out sets the zero, so that lamps take over from each other gently
    const std::size_t count = std::min<std::size_t>(strongest.size(), kMostFlameLights);
    const double zero = strongest.size() > count ? strongest[count].light : 0.0;
    for (std::size_t i = 0; i < count; ++i)
        kept += strongest[i].light - zero;
    // soot hides the soot behind it: a deep fire is brighter than a shallow one, but not in
    // proportion
    const double seen = total / (1 + total * kPerParticle / kDeepestFire);
    FlameLights lights;
    for (std::size_t i = 0; i < count && kept > 0; ++i) {
        const Corner& c = strongest[i];
        const double strength = (c.light - zero) * seen / kept * kPerParticle;
        lights.light[i] = {static_cast<float>(c.x / c.light), static_cast<float>(c.y / c.light),
                           static_cast<float>(c.z / c.light), static_cast<float>(strength)};
        ++lights.count;
    }
    return lights;
}

}  // namespace ember
