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

FlameLights gather_flame_lights(const WorldView& world) {
    constexpr double kCell = 0.10;              // [m]
    constexpr double kPerParticle = 1.0 / 900;  // strength 1: a handful of burning paper
    struct Cluster {
        double x = 0, y = 0, z = 0, weight = 0;
    };
    std::map<std::tuple<int, int, int>, Cluster> clusters;
    const ParticleView& p = world.particles;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        const double u = particle_heat(world, i), weight = u * u;
        const auto cell = [](double v) { return static_cast<int>(std::floor(v / kCell)); };
        Cluster& c = clusters[{cell(p.x[i]), cell(p.y[i]), cell(p.z[i])}];
        c.x += weight * p.x[i];
        c.y += weight * p.y[i];
        c.z += weight * p.z[i];
        c.weight += weight;
    }
    std::vector<Cluster> strongest;
    for (const auto& [cell, cluster] : clusters) {
        if (cluster.weight > 0) strongest.push_back(cluster);
    }
    std::stable_sort(strongest.begin(), strongest.end(),
                     [](const Cluster& a, const Cluster& b) { return a.weight > b.weight; });
    FlameLights lights;
    for (const Cluster& c : strongest) {
        if (lights.count == kMostFlameLights) break;
        lights.light[static_cast<std::size_t>(lights.count++)] = {
            static_cast<float>(c.x / c.weight), static_cast<float>(c.y / c.weight),
            static_cast<float>(c.z / c.weight), static_cast<float>(c.weight * kPerParticle)};
    }
    return lights;
}

}  // namespace ember
