// How far two images differ, and whether that is too far.
#pragma once

#include <array>
#include <limits>
#include <string>

#include "render/image.h"

namespace ember {

inline constexpr int kDifferenceBlock = 16;  ///< [pixels] width and height of a block

/// All figures in levels of 8 bits, 0 to 255. `a` is what was expected.
struct ImageDifference {
    bool comparable = false;       ///< same size
    int max_difference = 0;        ///< largest over all pixels and channels
    int max_x = 0, max_y = 0;      ///< the first pixel that has it
    std::int64_t total = 0;        ///< pixels
    std::int64_t pixels = 0;       ///< that differ at all
    double mean = 0;               ///< of |a - b| over pixels and the four channels
    double rms = 0;                ///< root of the mean of (a - b)^2 over the same
    double worst_block = 0;        ///< largest mean over the pixels of an aligned block of the mean
                                   ///< of |a - b| over red, green, blue, or of alpha's if larger
    int block_x = 0, block_y = 0;  ///< upper left pixel of the first block that has it
    /// Number of pixels by the largest difference of their channels.
    std::array<std::int64_t, 256> histogram{};

    [[nodiscard]] bool identical() const { return comparable && pixels == 0; }
    /// Pixels in which a channel differs by more than `levels`.
    [[nodiscard]] std::int64_t pixels_over(int levels) const;
    /// Of pixels_over, in percent of all.
    [[nodiscard]] double percent_over(int levels) const;
    /// Peak signal to noise [dB]; infinite for equal images.
    [[nodiscard]] double psnr() const;
};

[[nodiscard]] ImageDifference compare(const Image& a, const Image& b);

/// What is still taken for the same picture; as it stands, nothing but equality.
struct DifferenceLimits {
    int fail = 0;             ///< [levels] a pixel counts when a channel differs by more
    double fail_percent = 0;  ///< [%] of pixels that may count
    int hard_fail = 255;      ///< [levels] no pixel may differ by more
    double block = std::numeric_limits<double>::infinity();  ///< [levels] ImageDifference's
};

/// The same drawing by another software rasteriser, which rounds otherwise; and the same where thin
/// lines are drawn, whose pixels it may put elsewhere. docs/GOLDEN.md has the measurements.
inline constexpr DifferenceLimits kCloseLimits{2, 0.01, 255, 0.2};
inline constexpr DifferenceLimits kCloseLineLimits{2, 0.2, 255, 0.5};

/// Which limits are exceeded and by how much, in one line; empty when none is.
[[nodiscard]] std::string excess(const ImageDifference& difference, const DifferenceLimits& limits);

/// |a - b| per channel times `gain`, opaque. Images must have the same size.
[[nodiscard]] Image difference_image(const Image& a, const Image& b, int gain = 16);

/// The largest difference of each pixel's channels as a colour, black for none, each doubling one
/// step brighter: faint differences show beside great ones. Images must have the same size.
[[nodiscard]] Image heat_image(const Image& a, const Image& b);

/// 64-bit FNV-1a hash of size and pixels.
[[nodiscard]] std::uint64_t hash_of(const Image& image);

}  // namespace ember
