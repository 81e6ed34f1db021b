// Pictures in floating point with named channels.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace ember {

/// Channels of width×height values each, rows from the top.
struct FloatImage {
    int width = 0, height = 0;
    std::vector<std::pair<std::string, std::vector<float>>> channels;
};

}  // namespace ember
