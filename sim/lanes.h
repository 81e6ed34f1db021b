// Eight numbers that are computed side by side, whatever the width of the processor's registers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

// EMBER_LANES_ENTRY(name, parameters, call) defines a function `name` of its own file, which does
// `call` with kWidth as the width [doubles] of the processor's vector registers: the same eight
// lanes in one, two or four of them, so the same bits. As in vectorise.h, the sanitizers' builds
// have the plain version only. Calls from other files would not be dispatched.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(EMBER_PLAIN) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define EMBER_LANES_DISPATCHED
#include <immintrin.h>
#define EMBER_LANES_CLONE(isa, width, name, parameters, call) \
    __attribute__((target(isa))) void name parameters {       \
        constexpr std::size_t kWidth = width;                 \
        call;                                                 \
    }
#define EMBER_LANES_ENTRY(name, parameters, call)           \
    EMBER_LANES_CLONE("default", 2, name, parameters, call) \
    EMBER_LANES_CLONE("avx2", 4, name, parameters, call)    \
    EMBER_LANES_CLONE("avx512f", 8, name, parameters, call)
#else
#define EMBER_LANES_ENTRY(name, parameters, call) \
    void name parameters {                        \
        constexpr std::size_t kWidth = 2;         \
        call;                                     \
    }
#endif
#define EMBER_LANES_INLINE __attribute__((always_inline)) inline

namespace ember {

inline constexpr std::size_t kLanes = 8;

/// kLanes doubles in registers of `kWidth` each. Everything is passed by reference and inlined,
/// because how wide registers are passed differs between the instruction sets.
template <std::size_t kWidth>
struct Lanes {
    static constexpr std::size_t kParts = kLanes / kWidth;
    typedef double Part __attribute__((vector_size(kWidth * sizeof(double))));
    typedef std::int64_t Bits __attribute__((vector_size(kWidth * sizeof(double))));
    Part part[kParts];

    EMBER_LANES_INLINE void load(const double* from) { std::memcpy(part, from, sizeof part); }
    EMBER_LANES_INLINE void store(double* to) const { std::memcpy(to, part, sizeof part); }
    EMBER_LANES_INLINE void clear() {
        for (std::size_t k = 0; k < kParts; ++k)
            part[k] = Part{};
    }
};

/// Sum of all lanes: l and l + 4 first, then l and l + 2, then the last two.
EMBER_LANES_INLINE double sum_of(const Lanes<2>& a) {
    const auto even = a.part[0] + a.part[2], odd = a.part[1] + a.part[3];
    const auto both = even + odd;
    return both[0] + both[1];
}
EMBER_LANES_INLINE double sum_of(const Lanes<4>& a) {
    typedef double Half __attribute__((vector_size(16)));
    const auto four = a.part[0] + a.part[1];
    const Half both =
        __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return both[0] + both[1];
}
EMBER_LANES_INLINE double sum_of(const Lanes<8>& a) {
    typedef double Half __attribute__((vector_size(16)));
    const auto four = __builtin_shufflevector(a.part[0], a.part[0], 0, 1, 2, 3) +
                      __builtin_shufflevector(a.part[0], a.part[0], 4, 5, 6, 7);
    const Half both =
        __builtin_shufflevector(four, four, 0, 1) + __builtin_shufflevector(four, four, 2, 3);
    return both[0] + both[1];
}

}  // namespace ember
