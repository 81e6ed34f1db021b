// Makes the textures of this folder: emberleaf_make_textures FOLDER.
//
// fibre.png    256×256, tileable, 40 mm wide: grain of paper fibres in red, slow blotches in green,
//              noise of 7 mm and finer in blue, single fibres in alpha.
// crackle.png  256×256, tileable, 48 mm wide, how char cracks: distance to the nearest crack in red
//              (255: 4 mm), a random number of the flake in green, distance to the nearest fine
//              crack in blue (255: 1 mm).
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "noise.h"

namespace {

using namespace ember::texture;

constexpr int kSize = 256;

void write(const std::string& path, const std::vector<std::uint8_t>& pixels, int width, int height,
           int channels) {
    if (stbi_write_png(path.c_str(), width, height, channels, pixels.data(), channels * width) ==
        0) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
    }
}

// Single fibres, mainly along x: strokes that bend a little, drawn one over the other.
std::vector<double> strokes() {
    std::vector<double> depth(kSize * kSize, 0.0);
    constexpr int kFibres = 2600;
    for (int i = 0; i < kFibres; ++i) {
        const double x0 = hash(i, 0, 1) * kSize, y0 = hash(i, 1, 1) * kSize;
        const double angle = (hash(i, 2, 1) - 0.5) * (i % 4 == 0 ? 3.1 : 1.0);
        const double bend = (hash(i, 3, 1) - 0.5) * 0.05, length = 6 + 18 * hash(i, 4, 1);
        const double strength = 0.35 + 0.65 * hash(i, 5, 1);
        for (double t = 0; t < length; t += 0.5) {
            const int x = static_cast<int>(std::floor(x0 + t * std::cos(angle + bend * t)));
            const int y = static_cast<int>(std::floor(y0 + t * std::sin(angle + bend * t)));
            double& d =
                depth[static_cast<std::size_t>((y & (kSize - 1)) * kSize + (x & (kSize - 1)))];
            d = std::max(d, strength * std::sin(3.14159265 * (t + 0.5) / (length + 1)));
        }
    }
    return depth;
}

std::vector<std::uint8_t> fibres() {
    std::vector<std::uint8_t> rgba;
    const std::vector<double> fibre = strokes();
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            const double u = (x + 0.5) / kSize, v = (y + 0.5) / kSize;
            // fibres lie mainly along the main direction (x), some across
            const double along = octaves(u, v, 8, 46, 7, 3), across = octaves(u, v, 36, 11, 21, 3);
            const double grain = std::max(along, 0.85 * across) * 1.3 - 0.25;
            const double rough = (octaves(u, v, 6, 6, 83, 5) - 0.5) * 1.5 + 0.5;
            rgba.insert(rgba.end(), {byte(grain), byte(octaves(u, v, 4, 5, 55, 4)), byte(rough),
                                     byte(fibre[static_cast<std::size_t>(y * kSize + x)])});
        }
    }
    return rgba;
}

// Distance from (x, y) in the unit square, which tiles, to the borders between the cells of
// period × period scattered points, in units of the square; and a random number of its cell.
struct CellPlace {
    double border, random;
};
CellPlace cells(double x, double y, int period, int seed) {
    const double px = x * period, py = y * period;
    const int ix = static_cast<int>(std::floor(px)), iy = static_cast<int>(std::floor(py));
    struct Point {
        double x, y, random;
    };
    std::vector<Point> near;
    for (int dy = -2; dy <= 2; ++dy) {
        for (int dx = -2; dx <= 2; ++dx) {
            const int cx = ((ix + dx) % period + period) % period;
            const int cy = ((iy + dy) % period + period) % period;
            near.push_back({ix + dx + 0.1 + 0.8 * hash(cx, cy, seed),
                            iy + dy + 0.1 + 0.8 * hash(cx, cy, seed + 1), hash(cx, cy, seed + 2)});
        }
    }
    const auto away = [&](const Point& p) { return std::hypot(p.x - px, p.y - py); };
    const Point home = *std::min_element(near.begin(), near.end(),
                                         [&](auto& a, auto& b) { return away(a) < away(b); });
    double border = 1e9;
    for (const Point& p : near) {
        const double dx = p.x - home.x, dy = p.y - home.y, apart = std::hypot(dx, dy);
        if (apart < 1e-9) continue;
        const double along = ((px - home.x) * dx + (py - home.y) * dy) / apart;
        border = std::min(border, 0.5 * apart - along);
    }
    return {border / period, home.random};
}

std::vector<std::uint8_t> crackle() {
    constexpr double kMillimetres = 48;
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            double u = (x + 0.5) / kSize, v = (y + 0.5) / kSize;
            // cracks wander: the place is displaced before its cell is looked up
            const double du = octaves(u, v, 7, 7, 301, 4) - 0.5,
                         dv = octaves(u, v, 7, 7, 401, 4) - 0.5;
            const CellPlace coarse = cells(u + 0.06 * du, v + 0.06 * dv, 7, 500);
            const CellPlace fine = cells(u + 0.03 * dv, v + 0.03 * du, 30, 600);
            rgb.insert(rgb.end(), {byte(coarse.border * kMillimetres / 4), byte(coarse.random),
                                   byte(fine.border * kMillimetres)});
        }
    }
    return rgb;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    const std::string folder = std::string(argv[1]) + '/';
    write(folder + "fibre.png", fibres(), kSize, kSize, 4);
    write(folder + "crackle.png", crackle(), kSize, kSize, 3);
}
