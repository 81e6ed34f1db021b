// The colour of what glows because it is hot. Pure.
#pragma once

#include "render/palette.h"

namespace ember {

/// Colour of a black body at `kelvin`: Planck's law weighted with the colour matching functions of
/// the CIE 1931 observer (in the analytic fit of Wyman, Sloan and Shirley, 2013), in linear sRGB
/// primaries, its largest channel 1 and none below 0. For temperatures from 800 K.
[[nodiscard]] Colour blackbody_colour(double kelvin);

/// The same as chromaticity (x, y) of the CIE 1931 system.
[[nodiscard]] Eigen::Vector2d blackbody_chromaticity(double kelvin);

}  // namespace ember
