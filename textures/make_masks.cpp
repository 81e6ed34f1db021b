// Makes the outlines of the presets in presets/scenes: emberleaf_make_masks FOLDER.
//
// leaf.png    a leaf with a serrated rim, its tip down and its stalk up, with holes that insects
// ate. letter.png  a letter whose lower edge is torn off, with a window.
#include <stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

constexpr int kPixels = 400;  // the longer side
constexpr double kPi = 3.141592653589793;

// Whether there is paper at (u, v): u from -1 to 1 across, v from 0 at the top to 1.
using Outline = bool (*)(double u, double v);

bool in_disc(double u, double v, double cu, double cv, double radius) {
    return std::hypot(0.7 * (u - cu) / 2, v - cv) < radius;
}

bool leaf(double u, double v) {
    constexpr double kStalk = 0.14, kStalkWidth = 0.08;
    if (v < kStalk + 0.05 && std::abs(u) < kStalkWidth) return true;
    if (v < kStalk) return false;
    const double t = (v - kStalk) / (1 - kStalk);  // along the blade
    const double teeth = 0.06 * std::abs(std::fmod(14 * t, 1.0) - 0.3);
    const double half = 0.98 * std::pow(std::sin(kPi * std::pow(t, 0.72)), 0.85) - teeth;
    const bool eaten = in_disc(u, v, 0.36, 0.42, 0.035) || in_disc(u, v, 0.22, 0.49, 0.025) ||
                       in_disc(u, v, -0.42, 0.56, 0.04);
    return std::abs(u) < half && !eaten;
}

bool letter(double u, double v) {
    const double torn =
        0.86 + 0.035 * std::sin(5 * u) + 0.02 * std::sin(17 * u + 1) + 0.012 * std::sin(41 * u);
    const bool window = std::abs(u - 0.35) < 0.28 && std::abs(v - 0.2) < 0.06;
    return v < torn && !window;
}

void write(const std::string& path, int width, int height, Outline outline) {
    std::vector<std::uint8_t> grey;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const bool paper = outline(2 * (x + 0.5) / width - 1, (y + 0.5) / height);
            grey.push_back(paper ? 255 : 0);
        }
    }
    if (stbi_write_png(path.c_str(), width, height, 1, grey.data(), width) == 0) {
        std::fprintf(stderr, "cannot write %s\n", path.c_str());
        std::exit(1);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    write(std::string(argv[1]) + "/leaf.png", kPixels * 7 / 10, kPixels, leaf);
    write(std::string(argv[1]) + "/letter.png", kPixels * 7 / 10, kPixels, letter);
}
