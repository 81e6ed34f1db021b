// Counter-based random numbers: a pure function of (seed, stream, index, lane), so that nothing
// depends on the order in which numbers are drawn.
#pragma once

#include <cstdint>

namespace ember {

/// One independent use of randomness; indices within a stream are free.
enum class RandomUse : std::uint64_t {
    MainFibre = 1,
    CrossFibre,
    MainSpring,
    CrossSpring,
    Waviness,
    Particle,
    AshStrength
};

/// 64 well mixed bits; the mixing is that of SplitMix64 (Steele, Lea and Flood 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9E3779B97F4A7C15ull;
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ull;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBull;
    return x ^ (x >> 31);
}

[[nodiscard]] constexpr std::uint64_t random_bits(std::uint64_t seed, RandomUse use,
                                                  std::uint64_t stream, std::uint64_t index,
                                                  std::uint64_t lane = 0) {
    const std::uint64_t h = mix(mix(mix(seed) ^ static_cast<std::uint64_t>(use)) ^ stream);
    return mix(mix(h ^ index) ^ lane);
}

/// The part of random_bits() that a whole stream shares, and the part that an index of it does:
///     random_bits(seed, use, stream, index, lane) =
///         mix(random_index(random_stream(seed, use, stream), index) ^ lane)
[[nodiscard]] constexpr std::uint64_t random_stream(std::uint64_t seed, RandomUse use,
                                                    std::uint64_t stream) {
    return mix(mix(mix(seed) ^ static_cast<std::uint64_t>(use)) ^ stream);
}
[[nodiscard]] constexpr std::uint64_t random_index(std::uint64_t stream_bits, std::uint64_t index) {
    return mix(stream_bits ^ index);
}

/// Uniform in [0, 1), a multiple of 2^-53.
[[nodiscard]] constexpr double uniform_from(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

[[nodiscard]] constexpr double random_uniform(std::uint64_t seed, RandomUse use,
                                              std::uint64_t stream, std::uint64_t index,
                                              std::uint64_t lane = 0) {
    return uniform_from(random_bits(seed, use, stream, index, lane));
}

/// Mean 0, variance 1, within ±3.46: the sum of four uniform numbers, each of 16 of the 64 bits,
/// because a true normal needs the logarithm for tails that a flame does not.
[[nodiscard]] constexpr double bell_from(std::uint64_t bits) {
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        sum += (static_cast<double>((bits >> (16 * i)) & 0xFFFFu) + 0.5) * 0x1p-16;
    }
    return (sum - 2.0) * 1.7320508075688772;
}

}  // namespace ember
