#include "render/lighting.h"

#include <Eigen/Geometry>

namespace ember {

Lighting lighting_of(LightingPreset preset, double turned) {
    Lighting light;
    switch (preset) {
        case LightingPreset::Studio:
            // one large soft lamp above the viewer's right shoulder, before a charcoal cyclorama
            light.key_direction = Eigen::Vector3f(0.45f, 0.68f, 0.58f).normalized();
            light.key = Colour(0.74f, 0.71f, 0.66f);
            light.sky = Colour(0.150f, 0.165f, 0.190f);
            light.bounce = Colour(0.075f, 0.066f, 0.058f);
            light.backdrop_mid = Colour(0.036f, 0.036f, 0.040f);
            light.backdrop_edge = Colour(0.0040f, 0.0041f, 0.0048f);
            light.ground = 0.11f;
            break;
        case LightingPreset::Night:
            // a little moonlight from behind, so that the paper has an edge and the fire the room
            light.key_direction = Eigen::Vector3f(-0.62f, 0.66f, -0.43f).normalized();
            light.key = Colour(0.040f, 0.055f, 0.085f);
            light.sky = Colour(0.010f, 0.013f, 0.020f);
            light.bounce = Colour(0.003f, 0.003f, 0.004f);
            light.backdrop_mid = Colour(0.0042f, 0.0050f, 0.0078f);
            light.backdrop_edge = Colour(0.0007f, 0.0008f, 0.0013f);
            light.ground = 0.13f;
            break;
    }
    if (turned != 0)
        light.key_direction =
            Eigen::AngleAxisf(static_cast<float>(turned), Eigen::Vector3f::UnitY()) *
            light.key_direction;
    return light;
}

}  // namespace ember
