#include "render/image_difference.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace ember {
namespace {

struct PixelDifference {
    int worst = 0;    // over the channels
    double mean = 0;  // over the colours, or alpha's if larger
    int sum = 0;      // over the channels
    int squares = 0;
};

PixelDifference pixel_difference(const Image& a, const Image& b, std::size_t at) {
    PixelDifference d;
    int colours = 0, alpha = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        const int levels = std::abs(int(a.rgba[at + c]) - int(b.rgba[at + c]));
        d.worst = std::max(d.worst, levels);
        d.sum += levels;
        d.squares += levels * levels;
        (c < 3 ? colours : alpha) += levels;
    }
    d.mean = std::max(colours / 3.0, double(alpha));
    return d;
}

template <class... Numbers>
std::string text(const char* format, Numbers... numbers) {
    char out[160];
    std::snprintf(out, sizeof out, format, numbers...);
    return out;
}

// Sums of PixelDifference::mean per block of an image, row by row.
class Blocks {
  public:
    explicit Blocks(const Image& image)
        : width_(image.width),
          height_(image.height),
          columns_((image.width + kDifferenceBlock - 1) / kDifferenceBlock),
          sums_(
              static_cast<std::size_t>(columns_) *
              static_cast<std::size_t>((image.height + kDifferenceBlock - 1) / kDifferenceBlock)) {}
    void add(int x, int y, double mean) {
        sums_[static_cast<std::size_t>(y / kDifferenceBlock * columns_ + x / kDifferenceBlock)] +=
            mean;
    }
    void find_worst(ImageDifference& result) const {
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            const int x = static_cast<int>(i) % columns_ * kDifferenceBlock;
            const int y = static_cast<int>(i) / columns_ * kDifferenceBlock;
            const int area = std::min(kDifferenceBlock, width_ - x) *
                             std::min(kDifferenceBlock, height_ - y);  // less at the edges
            const double mean = sums_[i] / area;
            if (mean <= result.worst_block) continue;
            result.worst_block = mean;
            result.block_x = x, result.block_y = y;
        }
    }

  private:
    int width_, height_, columns_;
    std::vector<double> sums_;
};

}  // namespace

std::int64_t ImageDifference::pixels_over(int levels) const {
    std::int64_t count = 0;
    for (std::size_t d = static_cast<std::size_t>(std::clamp(levels, -1, 255) + 1);
         d < histogram.size(); ++d)
        count += histogram[d];
    return count;
}

double ImageDifference::percent_over(int levels) const {
    return total == 0 ? 0 : 100.0 * double(pixels_over(levels)) / double(total);
}

double ImageDifference::psnr() const {
    return rms > 0 ? 20 * std::log10(255 / rms) : std::numeric_limits<double>::infinity();
}

ImageDifference compare(const Image& a, const Image& b) {
    ImageDifference result;
    result.comparable =
        a.width == b.width && a.height == b.height && a.rgba.size() == b.rgba.size();
    if (!result.comparable) return result;
    result.total = std::int64_t(a.width) * a.height;
    Blocks blocks(a);
    std::int64_t sum = 0, squares = 0;
    std::size_t at = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x, at += 4) {
            const PixelDifference d = pixel_difference(a, b, at);
            ++result.histogram[static_cast<std::size_t>(d.worst)];
            if (d.worst == 0) continue;
            if (d.worst > result.max_difference) {
                result.max_difference = d.worst;
                result.max_x = x, result.max_y = y;
            }
            sum += d.sum, squares += d.squares;
            blocks.add(x, y, d.mean);
        }
    }
    result.pixels = result.pixels_over(0);
    blocks.find_worst(result);
    const double values = std::max(1.0, 4.0 * double(result.total));
    result.mean = double(sum) / values;
    result.rms = std::sqrt(double(squares) / values);
    return result;
}

std::string excess(const ImageDifference& d, const DifferenceLimits& limits) {
    if (!d.comparable) return "the sizes differ";
    std::string why;
    const auto add = [&why](const std::string& reason) {
        why += (why.empty() ? "" : "; ") + reason;
    };
    if (d.percent_over(limits.fail) > limits.fail_percent) {
        add(text("%lld of %lld pixels (%.4g %%) differ by more than %d levels, %g %% may",
                 static_cast<long long>(d.pixels_over(limits.fail)),
                 static_cast<long long>(d.total), d.percent_over(limits.fail), limits.fail,
                 limits.fail_percent));
    }
    if (d.max_difference > limits.hard_fail) {
        add(text("pixel %d,%d differs by %d levels, none may by more than %d", d.max_x, d.max_y,
                 d.max_difference, limits.hard_fail));
    }
    if (d.worst_block > limits.block) {
        add(text("the block at %d,%d differs by %.4g levels on average, %g are allowed", d.block_x,
                 d.block_y, d.worst_block, limits.block));
    }
    return why;
}

Image difference_image(const Image& a, const Image& b, int gain) {
    Image out{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
    for (std::size_t i = 0; i < a.rgba.size(); ++i) {
        if (i % 4 == 3) continue;
        const int d = std::abs(int(a.rgba[i]) - int(b.rgba[i])) * gain;
        out.rgba[i] = static_cast<std::uint8_t>(std::min(d, 255));
    }
    return out;
}

Image heat_image(const Image& a, const Image& b) {
    // black, blue, magenta, orange, white, at equal steps
    static constexpr std::uint8_t kStops[5][3] = {
        {0, 0, 0}, {40, 60, 200}, {200, 40, 160}, {255, 160, 40}, {255, 255, 255}};
    Image out{a.width, a.height, std::vector<std::uint8_t>(a.rgba.size(), 255)};
    for (std::size_t at = 0; at < a.rgba.size(); at += 4) {
        const int worst = pixel_difference(a, b, at).worst;
        const double heat = 4 * std::log2(1.0 + worst) / 8;
        const auto from = static_cast<std::size_t>(std::min(heat, 3.0));
        const double share = heat - double(from);
        for (std::size_t c = 0; c < 3; ++c)
            out.rgba[at + c] = static_cast<std::uint8_t>(
                std::lround((1 - share) * kStops[from][c] + share * kStops[from + 1][c]));
    }
    return out;
}

std::uint64_t hash_of(const Image& image) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    const auto add = [&hash](std::uint8_t byte) { hash = (hash ^ byte) * 0x100000001B3u; };
    for (const int side : {image.width, image.height}) {
        for (int shift = 0; shift < 32; shift += 8)
            add(static_cast<std::uint8_t>(static_cast<unsigned>(side) >> shift));
    }
    for (const std::uint8_t byte : image.rgba)
        add(byte);
    return hash;
}

}  // namespace ember
