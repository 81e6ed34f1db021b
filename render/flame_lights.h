// The light that flames throw: fire particles gathered into a few point lights. Pure, no GL.
#pragma once

#include <Eigen/Core>
#include <array>

#include "sim/world_view.h"

namespace ember {

inline constexpr int kMostFlameLights = 16;
inline constexpr double kDeepestFire = 4;  ///< [1] strength that all lights together stay below

/// xyz: place [m]; w: strength [1].
struct FlameLights {
    std::array<Eigen::Vector4f, kMostFlameLights> light;
    int count = 0;
};

/// Shares particles out to the corners of coarse cells of the world; the strongest corners become
/// lights, each at the centre of what it has got. Continuous in time: a light comes and goes with
/// strength 0. Soot hides the soot behind it, so particles that add up
/// to a strength S give lights that add up to S / (1 + S / kDeepestFire). The same fire gives the
/// same lights, in the same order.
[[nodiscard]] FlameLights gather_flame_lights(const WorldView& world);

/// Share of its life that a particle has lived, 0 .. 1.
[[nodiscard]] double particle_life(const WorldView& world, std::size_t particle);

/// Heat u of a particle: 1 at birth temperature, 0 at ambient.
[[nodiscard]] double particle_heat(const WorldView& world, std::size_t particle);

}  // namespace ember
