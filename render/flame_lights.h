// The light that flames throw: fire particles gathered into a few point lights. Pure, no GL.
#pragma once

#include <Eigen/Core>
#include <array>

#include "render/fire_cells.h"

namespace ember {

inline constexpr int kMostFlameLights = 16;
inline constexpr double kDeepestFire = 4;  ///< [1] strength that all lights together stay below

/// xyz: place [m]; w: strength [1].
struct FlameLights {
    std::array<Eigen::Vector4f, kMostFlameLights> light;
    int count = 0;
};

/// The corners of cells that shine most become lights, each at the centre of what it has got.
/// Continuous in time: a light comes and goes with strength 0. Soot hides the soot behind it, so
/// particles that add up to a strength S give lights that add up to S / (1 + S / kDeepestFire). The
/// same fire gives the same lights, in the same order.
[[nodiscard]] FlameLights gather_flame_lights(const FireCells& fire);

}  // namespace ember
