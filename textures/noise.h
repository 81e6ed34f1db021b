// Noise that the recipes of textures share.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace ember::texture {

inline double hash(int x, int y, int seed) {
    auto h = static_cast<std::uint32_t>(x) * 0x8DA6B343u ^
             static_cast<std::uint32_t>(y) * 0xD8163841u ^
             static_cast<std::uint32_t>(seed) * 0xCB1AB31Fu;
    h ^= h >> 15;
    h *= 0x2C1B3C6Du;
    h ^= h >> 12;
    h *= 0x297A2D39u;
    h ^= h >> 15;
    return h / 4294967296.0;
}

inline double smooth(double t) {
    return t * t * (3 - 2 * t);
}

// Value noise with `period` cells per unit, tiling over the unit square.
inline double noise(double x, double y, int period_x, int period_y, int seed) {
    const double px = x * period_x, py = y * period_y;
    const int ix = static_cast<int>(std::floor(px)), iy = static_cast<int>(std::floor(py));
    const double tx = smooth(px - ix), ty = smooth(py - iy);
    const auto at = [&](int dx, int dy) {
        const int cx = ((ix + dx) % period_x + period_x) % period_x;
        const int cy = ((iy + dy) % period_y + period_y) % period_y;
        return hash(cx, cy, seed);
    };
    return (at(0, 0) * (1 - tx) + at(1, 0) * tx) * (1 - ty) +
           (at(0, 1) * (1 - tx) + at(1, 1) * tx) * ty;
}

inline double octaves(double x, double y, int period_x, int period_y, int seed, int count) {
    double sum = 0, weight = 0.5, total = 0;
    for (int i = 0; i < count; ++i) {
        sum += weight * noise(x, y, period_x << i, period_y << i, seed + i);
        total += weight;
        weight *= 0.55;
    }
    return sum / total;
}

inline std::uint8_t byte(double v) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(v, 0.0, 1.0)));
}

}  // namespace ember::texture
