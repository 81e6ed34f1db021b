// Colours of burning paper, of flames and of quantities: pure, and the only place they are defined.
//
// Burning paper is coloured by distances on the unburnt sheet, in millimetres: ahead of the line
// where it chars, and behind the line where char burns out, which glows. The shaders look the same
// tables up in textures. All colours are linear RGB; 1 is white paper in studio light.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "sim/types.h"

namespace ember {

using Colour = Eigen::Vector3f;

/// Reflectance of paper `ahead` [mm] of the char line: char, brown, scorch, white.
inline constexpr double kScorchEnd = 32.0;  ///< [mm] everything is white from here on
[[nodiscard]] Colour scorched_albedo(double ahead);

/// Light of the ember line `behind` [mm] its front.
inline constexpr double kEmberEnd = 4.0;  ///< [mm] dark from here on
[[nodiscard]] Colour ember_light(double behind);

/// Reflectance of char, and of ash by how far it has paled, 0 to 1.
[[nodiscard]] Colour char_albedo();
[[nodiscard]] Colour ash_albedo(double pale);

/// Light of a fire particle by its heat u: 1 at birth temperature, 0 at ambient.
[[nodiscard]] Colour flame_colour(double u);

/// Flat colour of a phase in the state view.
[[nodiscard]] Colour phase_colour(Phase phase);

/// Springs in the lattice view: the paper's colours, and what burns.
enum class SpringColour { Main, Cross, Diagonal, Bending, Burning };
[[nodiscard]] Colour spring_colour(SpringColour kind);

/// Perceptual colour maps over [0, 1]: heat for temperatures, mass for shares, and stress from
/// pushed through nothing, the lightest, to pulled.
[[nodiscard]] Colour heat_map(double x);
[[nodiscard]] Colour mass_map(double x);
[[nodiscard]] Colour stress_map(double x);

inline constexpr double kHottest = 1100.0;                ///< [degC] end of the temperature scale
inline constexpr double kSoftest = 0.9, kStiffest = 1.1;  ///< [1] ends of the stiffness scale

inline constexpr int kTableSize = 256;
/// A function of [0, end] sampled at kTableSize points, for a texture.
using ColourTable = std::array<Colour, kTableSize>;
[[nodiscard]] ColourTable tabulate(Colour (*function)(double), double end);

}  // namespace ember
