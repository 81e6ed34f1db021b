// How far two images differ.
#pragma once

#include "render/image.h"

namespace ember {

struct ImageDifference {
    bool comparable = false;  ///< same size
    int max_difference = 0;   ///< [levels] largest over all channels
    std::int64_t pixels = 0;  ///< that differ at all
    [[nodiscard]] bool identical() const { return comparable && pixels == 0; }
};

[[nodiscard]] ImageDifference compare(const Image& a, const Image& b);

/// |a - b| per channel times `gain`, opaque. Images must have the same size.
[[nodiscard]] Image difference_image(const Image& a, const Image& b, int gain = 16);

}  // namespace ember
