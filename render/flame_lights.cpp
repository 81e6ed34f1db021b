#include "render/flame_lights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <vector>

namespace ember {

double particle_heat(const WorldView& world, std::size_t particle) {
    const double span = world.fire_temperature - world.ambient;
    if (!(span > 0)) return 0.0;
    return std::clamp((world.particles.temperature[particle] - world.ambient) / span, 0.0, 1.0);
}

double particle_life(const WorldView& world, std::size_t particle) {
    const ParticleView& p = world.particles;
    const double span = p.death[particle] - p.birth[particle];
    if (!(span > 0)) return 1.0;
    return std::clamp((world.time - p.birth[particle]) / span, 0.0, 1.0);
}

FlameLights gather_flame_lights(const WorldView& world) {
    constexpr double kCell = 0.08;              // [m]
    constexpr double kPerParticle = 1.0 / 900;  // strength 1: a handful of burning paper
    struct Cluster {
        double x = 0, y = 0, z = 0, weight = 0;
    };
    std::map<std::tuple<int, int, int>, Cluster> clusters;
    const ParticleView& p = world.particles;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        const double u = particle_heat(world, i), life = particle_life(world, i);
        // born and dying without a jump, and shared by the cells around, so that no lamp flickers
        const double strength = u * u * std::min({1.0, 12.0 * life, 4.0 * (1.0 - life)});
        if (!(strength > 0)) continue;
        const double gx = p.x[i] / kCell, gy = p.y[i] / kCell, gz = p.z[i] / kCell;
        const double fx = std::floor(gx), fy = std::floor(gy), fz = std::floor(gz);
        for (int corner = 0; corner < 8; ++corner) {
            const int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
            const double share = std::abs(1 - dx - (gx - fx)) * std::abs(1 - dy - (gy - fy)) *
                                 std::abs(1 - dz - (gz - fz));
            const double weight = share * strength;
            if (!(weight > 0)) continue;
            Cluster& c = clusters[{static_cast<int>(fx) + dx, static_cast<int>(fy) + dy,
                                   static_cast<int>(fz) + dz}];
            c.x += weight * p.x[i];
            c.y += weight * p.y[i];
            c.z += weight * p.z[i];
            c.weight += weight;
        }
    }
    std::vector<Cluster> strongest;
    double total = 0, kept = 0;
    for (const auto& [cell, cluster] : clusters) {
        strongest.push_back(cluster);
        total += cluster.weight;
    }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const Cluster& a, const Cluster& b) { return a.weight > b.weight; });
    // the first that is left out sets the zero, so that lamps take over from each other gently
    const std::size_t count = std::min<std::size_t>(strongest.size(), kMostFlameLights);
    const double zero = strongest.size() > count ? strongest[count].weight : 0.0;
    for (std::size_t i = 0; i < count; ++i)
        kept += strongest[i].weight - zero;
    // soot hides the soot behind it: a deep fire is brighter than a shallow one, but not in
    // proportion
    const double seen = total / (1 + total * kPerParticle / kDeepestFire);
    FlameLights lights;
    for (std::size_t i = 0; i < count && kept > 0; ++i) {
        const Cluster& c = strongest[i];
        const double strength = (c.weight - zero) * seen / kept * kPerParticle;
        lights.light[i] = {static_cast<float>(c.x / c.weight), static_cast<float>(c.y / c.weight),
                           static_cast<float>(c.z / c.weight), static_cast<float>(strength)};
        ++lights.count;
    }
    return lights;
}

}  // namespace ember
