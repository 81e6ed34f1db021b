#include "render/image_difference.h"

#include <algorithm>
#include <cstdlib>

namespace ember {

ImageDifference compare(const Image& a, const Image& b) {
    ImageDifference result;
    result.comparable = a.width == b.width && a.height == b.height;
    if (!result.comparable) return result;
    for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
        int worst = 0;
        for (std::size_t c = pixel; c < pixel + 4; ++c) {
            worst = std::max(worst, std::abs(int(a.rgba[c]) - int(b.rgba[c])));
        }
        result.max_difference = std::max(result.max_difference, worst);
        result.pixels += worst > 0 ? 1 : 0;
    }
    return result;
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

}  // namespace ember
