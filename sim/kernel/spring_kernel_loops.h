// The loops of spring_kernel.h for vectors of EMBER_LANES doubles. Included by the files that
// compile them for one instruction set each; it must not use any inline function from elsewhere,
// since the linker would keep one copy of it for all processors.
//
// EMBER_FAST: fused multiply-add (by the compiler's flags) and an estimated reciprocal root.

#include "sim/kernel/spring_kernel.h"
#if EMBER_FAST
#include <immintrin.h>
#endif

namespace ember {
namespace {

constexpr std::ptrdiff_t kWidth = EMBER_LANES;
using Doubles [[gnu::vector_size(8 * EMBER_LANES)]] = double;
using Floats [[gnu::vector_size(4 * EMBER_LANES)]] = float;

inline Doubles load(const double* from) {
    Doubles v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

inline void store(double* to, const Doubles& v) {
    __builtin_memcpy(to, &v, sizeof v);
}

// 1/√s. A division and a root in double precision would take twice as long as the rest of a
// spring, so both are taken in single precision, correctly rounded and hence the same on every
// processor, and one step of third order, error 5/16 e³ with |e| < 2^-22, makes them double.
// Springs shorter than 1e-15 m have no direction; the offset keeps their result finite, and since
// it multiplies their extent, they exert no force.
inline Doubles inverse_root(const Doubles& square) {
    const Doubles s = square + 1e-30;
#if EMBER_FAST
    const Doubles y =
        reinterpret_cast<Doubles>(_mm512_maskz_rsqrt14_pd(0xFF, reinterpret_cast<__m512d>(s)));
    const Doubles e = 1.0 - (s * y) * y;
    return y + (y * e) * (0.5 + e * (0.375 + e * 0.3125));
#else
    Floats root = __builtin_convertvector(s, Floats);
    for (int lane = 0; lane < EMBER_LANES; ++lane)
        root[lane] = __builtin_sqrtf(root[lane]);
    const Doubles y = __builtin_convertvector(1.0f / root, Doubles);
    const Doubles e = 1.0 - (s * y) * y;
    return y + (y * e) * (0.5 + e * 0.375);
#endif
}

// Positions and velocities of as many nodes as there are lanes.
struct Ends {
    Doubles x, y, z, u, v, w;
    Doubles p{}, q{}, r{};  // velocity of the last drift
};

template <bool kDrift>
inline Ends ends_at(const SpringRow& row, int below, std::ptrdiff_t column) {
    const double* x = row.x[below] + column;
    const double* v = row.v[below] + column;
    const std::ptrdiff_t n = row.node_count;
    Ends ends{load(x), load(x + n), load(x + 2 * n), load(v), load(v + n), load(v + 2 * n)};
    if constexpr (kDrift) {
        const double* drift = row.drift[below] + column;
        ends.p = load(drift), ends.q = load(drift + n), ends.r = load(drift + 2 * n);
    }
    return ends;
}

// Springs from a to b, F = [k (1 - l/L) + d (Δv·Δx)/L²] Δx. Returns the power lost d (Δv·n)².
template <bool kDrift>
inline Doubles spring(const double* constants, double* force, std::ptrdiff_t pitch, const Ends& a,
                      const Ends& b, double* kept) {
    const Doubles dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
    const Doubles inverse = inverse_root(dx * dx + dy * dy + dz * dz);
    const Doubles rate = ((b.u - a.u) * dx + (b.v - a.v) * dy + (b.w - a.w) * dz) * inverse;
    const Doubles friction = load(constants + 2 * kBlockColumns) * rate;
    const Doubles scale = load(constants) + inverse * (friction - load(constants + kBlockColumns));
    store(force, scale * dx);
    store(force + pitch, scale * dy);
    store(force + 2 * pitch, scale * dz);
    if constexpr (!kDrift) return friction * rate;
    const Doubles mean = 0.5 * (friction + load(kept));
    store(kept, friction);
    return mean * (((b.p - a.p) * dx + (b.q - a.q) * dy + (b.r - a.r) * dz) * inverse);
}

template <bool kDrift>
void evaluate(const SpringRow& given) {
    const SpringRow row = given;  // a copy that the stores below cannot be thought to change
    const std::ptrdiff_t next_kind = 3 * row.pitch, next_constants = kConstants * kBlockColumns;
    for (std::ptrdiff_t column = 0; column < row.columns; column += kWidth) {
        const std::ptrdiff_t block = column / kBlockColumns, lane = column % kBlockColumns;
        const double* k = row.constants + block * kKinds * next_constants + lane;
        double* f = row.force + column;
        double* kept = kDrift ? row.friction + block * kKinds * kBlockColumns + lane : nullptr;
        std::ptrdiff_t kind = 0;
        const auto add = [&](const Ends& a, const Ends& b) {
            const Doubles loss = spring<kDrift>(k + kind * next_constants, f + kind * next_kind,
                                                row.pitch, a, b, kept + kind * kBlockColumns);
            ++kind;
            return loss;
        };
        const Ends here = ends_at<kDrift>(row, 0, column);
        const Ends right = ends_at<kDrift>(row, 0, column + 1);
        const Ends below = ends_at<kDrift>(row, 1, column);
        Doubles loss = add(here, right);
        loss += add(here, below);
        loss += add(here, ends_at<kDrift>(row, 1, column + 1));
        loss += add(right, below);
        loss += add(here, ends_at<kDrift>(row, 0, column + 2));
        loss += add(here, ends_at<kDrift>(row, 2, column));
        store(row.loss + column, loss);
    }
}

#ifdef EMBERLEAF_PLANT_FORCE_ERROR
// For the test of the energy ledger only: a law that breaks Newton's third by one per cent.
constexpr double kReaction = 1.01;
#else
constexpr double kReaction = 1.0;
#endif

void gather(const ForceRows& given) {
    const ForceRows rows = given;
    const std::ptrdiff_t kind = 3 * rows.pitch;
    for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
        const double* own = rows.own + axis * rows.pitch;
        const double* above = rows.above + axis * rows.pitch;
        const double* two_above = rows.two_above + axis * rows.pitch;
        double* total = rows.total + axis * rows.pitch;
        for (std::ptrdiff_t c = 0; c < rows.columns; c += kWidth) {
            Doubles f = load(own + c) - kReaction * load(own + c - 1);
            f += load(own + kind + c) - kReaction * load(above + kind + c);
            f += load(own + 2 * kind + c) - kReaction * load(above + 2 * kind + c - 1);
            f += load(own + 3 * kind + c - 1) - kReaction * load(above + 3 * kind + c);
            f += load(own + 4 * kind + c) - kReaction * load(own + 4 * kind + c - 2);
            f += load(own + 5 * kind + c) - kReaction * load(two_above + 5 * kind + c);
            store(total + c, f);
        }
    }
}

}  // namespace

extern const SpringKernel EMBER_KERNEL_NAME;
const SpringKernel EMBER_KERNEL_NAME{evaluate<false>, evaluate<true>, gather};

}  // namespace ember
