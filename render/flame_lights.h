// The light that flames throw: fire particles gathered into a few point lights. Pure, no GL.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/world_view.h"

namespace ember {

inline constexpr int kMostFlameLights = 8;

/// xyz: place [m]; w: strength [1].
struct FlameLights {
    std::array<Eigen::Vector4f, kMostFlameLights> light;
    int count = 0;
};

/// Gathers particles by coarse cells of the world; the strongest cells become lights, each at the
/// centre of its particles. The same fire gives the same lights, in the same order.
[[nodiscard]] FlameLights gather_flame_lights(const WorldView& world);

/// Heat u of a particle: 1 at birth temperature, 0 at ambient.
[[nodiscard]] double particle_heat(const WorldView& world, std::size_t particle);

}  // namespace ember
