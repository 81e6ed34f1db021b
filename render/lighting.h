// The light of the set: where it comes from and what it looks like. Pure, no GL.
#pragma once

#include <Eigen/Core>

#include "render/palette.h"
#include "render/view_params.h"

namespace ember {

/// Light without flames. Colours are linear RGB; an irradiance of 1 on white paper is paper white.
struct Lighting {
    Eigen::Vector3f key_direction;       ///< towards the lamp, a unit vector
    Colour key;                          ///< irradiance of a surface that faces the lamp
    Colour sky, bounce;                  ///< ambient irradiance of surfaces that face up and down
    Colour backdrop_mid, backdrop_edge;  ///< the set behind the paper, in the middle and far off
    float ground;                        ///< reflectance of the ground
};

/// `turned` [rad]: the lamp, turned around the paper to the right from where the set has it.
[[nodiscard]] Lighting lighting_of(LightingPreset preset, double turned = 0);

}  // namespace ember
