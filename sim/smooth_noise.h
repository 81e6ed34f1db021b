// Random numbers that vary smoothly over a plane.
#pragma once

#include <cstdint>

#include "sim/random.h"

namespace ember {

/// Random values at the points with integer coordinates, blended in between.
struct SmoothNoise {
    std::uint64_t seed;
    RandomUse use;
    std::uint64_t stream;
    std::uint64_t row_length;  ///< points along x, numbered row by row
    double period_y;  ///< [1] whole: the pattern repeats along y after so many rows; 0: never

    /// Uniform in [-1, 1] at integer coordinates x, y >= 0, x < row_length - 1; smaller in between.
    [[nodiscard]] double at(double x, double y) const;
};

}  // namespace ember
