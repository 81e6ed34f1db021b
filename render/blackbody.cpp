#include "render/blackbody.h"

#include <cmath>

namespace ember {
namespace {

// A bell whose two flanks differ in width: x and the widths in nanometres.
double lobe(double x, double middle, double below, double above) {
    const double t = (x - middle) / (x < middle ? below : above);
    return std::exp(-0.5 * t * t);
}

Eigen::Vector3d matching_functions(double nm) {
    return {1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) -
                0.065 * lobe(nm, 501.1, 20.4, 26.2),
            0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
            1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

Eigen::Vector3d tristimulus(double kelvin) {
    constexpr double kSecondRadiation = 1.438776877e7;  // [nm K]
    // relative to the middle of the spectrum, so that nothing underflows when it is cold
    constexpr double kMiddle = 600.0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (double nm = 380.0; nm <= 780.0; nm += 5.0) {
        const double radiance = std::pow(kMiddle / nm, 5) *
                                std::exp(kSecondRadiation / kelvin * (1.0 / kMiddle - 1.0 / nm)) /
                                (1.0 - std::exp(-kSecondRadiation / (nm * kelvin)));
        sum += radiance * matching_functions(nm);
    }
    return sum;
}

}  // namespace

Eigen::Vector2d blackbody_chromaticity(double kelvin) {
    const Eigen::Vector3d xyz = tristimulus(kelvin);
    return xyz.head<2>() / xyz.sum();
}

Colour blackbody_colour(double kelvin) {
    Eigen::Matrix3d srgb_from_xyz;
    srgb_from_xyz << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
    const Eigen::Vector3d rgb = (srgb_from_xyz * tristimulus(kelvin)).cwiseMax(0.0);
    return (rgb / rgb.maxCoeff()).cast<float>();
}

}  // namespace ember
