// Makes flame.png of this folder: emberleaf_make_flames FOLDER.
//
// 1024×640, a flipbook of 16×5 cells: four rows of tongues of flame, each 16 pictures of its life
// from left to right, and a row of puffs of smoke; the first cell of the last row is a soft spot.
// Density in alpha, heat in colour. The base is at a cell's bottom.
#include <stb_image_write.h>

#include <cstdio>
#include <string>
#include <vector>

#include "noise.h"

namespace {

using namespace ember::texture;

constexpr int kFrames = 16, kTongues = 4, kWide = 64, kTall = 128;  // of the flipbook

double ramp(double from, double to, double x) {
    return smooth(std::clamp((x - from) / (to - from), 0.0, 1.0));
}

// Noise that does not repeat where it is used, around 0.
double turbulence(double x, double y, int seed, int count) {
    return octaves(x / 64 + 0.5, y / 64 + 0.5, 64, 64, seed, count) - 0.5;
}

struct Texel {
    double density, heat;
};

// No sprite may show the border of its cell: 1 inside, 0 at the border. u from -1 to 1, v to 1.
double inside(double u, double v) {
    return (1 - ramp(0.78, 0.97, std::abs(u))) * ramp(0.0, 0.03, v) * (1 - ramp(0.93, 0.99, v));
}

// A tongue of flame at age p (0 .. 1): a swaying leaf, torn by noise that rises through it, which
// comes off its base in the middle of its life and breaks up from the tip.
Texel tongue(double u, double v, double p, int seed) {
    const double sway = v * (1.3 * turbulence(0.3, 1.3 * v - 1.2 * p, seed, 1) +
                             1.1 * turbulence(0.7, 3.2 * v - 2.6 * p, seed + 1, 2));
    const double width = 0.66 * std::sqrt(ramp(-0.06, 0.30, v)) * (1 - 0.66 * v);
    const double rip = turbulence(2.3 * u, 2.3 * v - 3.0 * p, seed + 2, 4);
    const double reach = 0.80 + 0.5 * turbulence(0.9 * u, 1.1 * p, seed + 3, 2);
    double body = 1 - std::abs(u - sway) / width + 2.9 * rip * (0.22 + v);
    body -= 1.7 * ramp(reach - 0.45, reach + 0.15, v);
    body -= 1.3 * ramp(0.35, 0.9, p) * (1 - ramp(0.05, 0.5, v));
    body -= 0.75 * ramp(0.45, 1.0, p) * (0.35 + 0.65 * v);
    const double strands = turbulence(3.4 * u - sway, 1.5 * v - 2.4 * p, seed + 4, 3);
    // a flame is a hollow shell: its outline shines more than its middle
    const double shell = 1 - 0.30 * ramp(0.45, 0.95, body);
    const double density =
        ramp(0.0, 0.42, body) * ramp(0.0, 0.16, v) * shell * std::max(0.0, 0.72 + 1.5 * strands);
    return {density * inside(u, v), (0.50 + 0.5 * ramp(0.0, 0.7, body)) * (1 - 0.42 * v)};
}

// A puff of smoke, or of anything soft and torn.
Texel puff(double u, double v, double p, int seed) {
    const double y = 2 * v - 1, r = std::sqrt(u * u + y * y);
    const double curls = turbulence(2.2 * u, 2.2 * y + 1.4 * p, seed, 4);
    return {
        ramp(0.0, 1.1, 1 - r + 1.0 * curls * (0.3 + r)) * inside(u, v) * (1 - ramp(0.7, 0.98, r)),
        0.5};
}

Texel spot(double u, double v) {
    const double y = 2 * v - 1, r = std::sqrt(u * u + y * y);
    return {std::pow(1 - ramp(0.0, 0.95, r), 1.5), 1.0};
}

std::vector<std::uint8_t> flames() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < kTall * (kTongues + 1); ++y) {
        for (int x = 0; x < kWide * kFrames; ++x) {
            const int frame = x / kWide, row = y / kTall;
            const double u = 2 * (x % kWide + 0.5) / kWide - 1;
            const double v = 1 - (y % kTall + 0.5) / kTall;
            const double p = (frame + 0.5) / kFrames;
            const Texel t = row < kTongues ? tongue(u, v, p, 100 + 37 * row)
                            : frame == 0   ? spot(u, v)
                                           : puff(u, v, p, 500);
            const std::uint8_t heat = byte(t.heat);
            rgba.insert(rgba.end(), {heat, heat, heat, byte(t.density)});
        }
    }
    return rgba;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    const std::string path = std::string(argv[1]) + "/flame.png";
    const std::vector<std::uint8_t> rgba = flames();
    if (stbi_write_png(path.c_str(), kWide * kFrames, kTall * (kTongues + 1), 4, rgba.data(),
                       4 * kWide * kFrames) == 0) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
        return 1;
    }
}
