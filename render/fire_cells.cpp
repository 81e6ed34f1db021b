#include "render/fire_cells.h"

#include <algorithm>
#include <cmath>

namespace ember {
namespace {

// Calls use(corner, share) for the corners of the cell that holds `place`; shares add up to 1.
template <class Use>
void for_corners(const Eigen::Vector3d& place, const Use& use) {
    const Eigen::Array3d grid = place.array() / FireCells::kSize, first = grid.floor();
    const Eigen::Array3d within = grid - first;
    for (int k = 0; k < 8; ++k) {
        const Eigen::Array3i step(k & 1, k >> 1 & 1, k >> 2);
        const double share = (1.0 - step.cast<double>() - within).abs().prod();
        if (!(share > 0)) continue;
        const Eigen::Array3i at = first.cast<int>() + step;
        use(std::array<int, 3>{at.x(), at.y(), at.z()}, share);
    }
}

}  // namespace

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

FireCells::FireCells(const WorldView& world) {
    const ParticleView& p = world.particles;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        const double u = particle_heat(world, i), life = particle_life(world, i);
        const double gas = std::min({1.0, 12.0 * life, 4.0 * (1.0 - life)});
        if (!(gas > 0)) continue;
        for_corners({p.x[i], p.y[i], p.z[i]}, [&](const std::array<int, 3>& at, double share) {
            Corner& c = corners_[at];
            const double light = share * u * u * gas;
            c.x += light * p.x[i];
            c.y += light * p.y[i];
            c.z += light * p.z[i];
            c.light += light;
            c.gas += share * gas;
        });
    }
}

double FireCells::gas_at(const Eigen::Vector3d& place) const {
    double sum = 0;
    for_corners(place, [&](const std::array<int, 3>& at, double share) {
        if (const auto corner = corners_.find(at); corner != corners_.end())
            sum += share * corner->second.gas;
    });
    return sum;
}

}  // namespace ember
