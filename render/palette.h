// Colours of burning paper, of flames and of quantities: pure, and the only place they are defined.
//
// Paper is coloured along one coordinate, the burn progress p of a point:
//     0 .. 1   unburnt, from 120 degC to ignition      paper, scorch, brown
//     1 .. 2   burning, by the mass already lost       black char with a glowing rim
//     2 .. 4   burnt out, by the time since            black char turning to pale ash
// The shaders look the same tables up in textures. All colours are linear RGB; 1 is white paper in
// studio light.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/types.h"

namespace ember {

using Colour = Eigen::Vector3f;

inline constexpr double kBurnProgressEnd = 4.0;
inline constexpr double kAshTime = 2.5;  ///< [s] per unit of p after burning out

/// Burn progress of a node. temperature and ignition [K], burnt: share of the combustible mass that
/// is gone [1], age: time since the node burnt out [s].
[[nodiscard]] double burn_progress(Phase phase, double temperature, double ignition, double burnt,
                                   double age);

/// Diffuse reflectance at burn progress p, and the light that glowing paper emits there.
[[nodiscard]] Colour paper_albedo(double p);
[[nodiscard]] Colour paper_glow(double p);

/// Light of a fire particle by its heat u: 1 at birth temperature, 0 at ambient.
[[nodiscard]] Colour flame_colour(double u);

/// Flat colour of a phase in the state view.
[[nodiscard]] Colour phase_colour(Phase phase);

/// Perceptual colour maps over [0, 1]: heat for temperatures, mass for shares.
[[nodiscard]] Colour heat_map(double x);
[[nodiscard]] Colour mass_map(double x);

inline constexpr int kTableSize = 256;
/// A function of [0, end] sampled at kTableSize points, for a texture.
using ColourTable = std::array<Colour, kTableSize>;
[[nodiscard]] ColourTable tabulate(Colour (*function)(double), double end);

}  // namespace ember
