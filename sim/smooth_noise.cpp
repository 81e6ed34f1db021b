#include "sim/smooth_noise.h"

#include <cmath>

namespace ember {
namespace {

double smoothstep(double t) {
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace

double SmoothNoise::at(double x, double y) const {
    const double x0 = std::floor(x), y0 = std::floor(y);
    const auto corner = [&](double dx, double dy) {
        double row = y0 + dy;
        if (period_y > 0) row -= period_y * std::floor(row / period_y);
        const auto index =
            static_cast<std::uint64_t>(row) * row_length + static_cast<std::uint64_t>(x0 + dx);
        return 2.0 * random_uniform(seed, use, stream, index) - 1.0;
    };
    const double s = smoothstep(x - x0), t = smoothstep(y - y0);
    return (1 - t) * ((1 - s) * corner(0, 0) + s * corner(1, 0)) +
           t * ((1 - s) * corner(0, 1) + s * corner(1, 1));
}

}  // namespace ember
