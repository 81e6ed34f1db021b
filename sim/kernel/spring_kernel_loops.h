// The loops of spring_kernel.h for vectors of EMBER_LANES doubles. Included by the files that
// compile them for one instruction set each; it must not use any inline function from elsewhere,
// since the linker would keep one copy of it for all processors.
//
// EMBER_FAST: fused multiply-add (by the compiler's flags) and an estimated reciprocal root.

#include "sim/kernel/spring_kernel.h"
#if EMBER_LANES == 8
#include <immintrin.h>
#endif

namespace ember {
namespace {

constexpr std::ptrdiff_t kWidth = EMBER_LANES;
using Doubles [[gnu::vector_size(8 * EMBER_LANES)]] = double;
using Floats [[gnu::vector_size(4 * EMBER_LANES)]] = float;

// Between precisions, rounding to nearest. The compiler's own conversion works on half vectors.
inline Floats narrowed(const Doubles& v) {
#if EMBER_LANES == 8
    return reinterpret_cast<Floats>(_mm512_maskz_cvtpd_ps(0xFF, reinterpret_cast<__m512d>(v)));
#else
    return __builtin_convertvector(v, Floats);
#endif
}

inline Doubles widened(const Floats& v) {
#if EMBER_LANES == 8
    return reinterpret_cast<Doubles>(_mm512_maskz_cvtps_pd(0xFF, reinterpret_cast<__m256>(v)));
#else
    return __builtin_convertvector(v, Doubles);
#endif
}

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
    Floats root = narrowed(s);
    for (int lane = 0; lane < EMBER_LANES; ++lane)
        root[lane] = __builtin_sqrtf(root[lane]);
    const Doubles y = widened(1.0f / root);
    const Doubles e = 1.0 - (s * y) * y;
    return y + (y * e) * (0.5 + e * 0.375);
#endif
}

// Positions and velocities of as many nodes as there are lanes.
struct Ends {
    Doubles x, y, z, u, v, w;
};

inline Ends ends_at(const SpringRow& row, int below, std::ptrdiff_t column) {
    const double* x = row.x[below] + column;
    const double* v = row.v[below] + column;
    const std::ptrdiff_t n = row.node_count;
    return {load(x), load(x + n), load(x + 2 * n), load(v), load(v + n), load(v + 2 * n)};
}

struct Force {
    Doubles x{}, y{}, z{};

    void operator+=(const Force& f) { x += f.x, y += f.y, z += f.z; }
    void operator-=(const Force& f) { x -= f.x, y -= f.y, z -= f.z; }
};

// All of a force, and its friction.
struct SplitForce {
    Force all, friction;

    void operator+=(const SplitForce& f) { all += f.all, friction += f.friction; }
    void operator-=(const SplitForce& f) { all -= f.all, friction -= f.friction; }
};

// Springs from a to b, F = [k (1 - l/L) + d (Δv·Δx)/L²] Δx on a. Adds the power lost, d (Δv·n)².
inline void pull(const double* constants, const Ends& a, const Ends& b, Doubles& lost, Force& f,
                 Force* part) {
    const Doubles dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
    const Doubles inverse = inverse_root(dx * dx + dy * dy + dz * dz);
    const Doubles rate = ((b.u - a.u) * dx + (b.v - a.v) * dy + (b.w - a.w) * dz) * inverse;
    const Doubles friction = load(constants + 2 * kBlockColumns) * rate;
    const Doubles scale = load(constants) + inverse * (friction - load(constants + kBlockColumns));
    f = {scale * dx, scale * dy, scale * dz};
    if (part == nullptr) {
        lost += friction * rate;
        return;
    }
    const Doubles share = inverse * friction;
    *part = {share * dx, share * dy, share * dz};
}

inline void pull(const double* constants, const Ends& a, const Ends& b, Doubles& lost, Force& f) {
    pull(constants, a, b, lost, f, nullptr);
}

inline void pull(const double* constants, const Ends& a, const Ends& b, Doubles& lost,
                 SplitForce& f) {
    pull(constants, a, b, lost, f.all, &f.friction);
}

// What belongs to nodes `kColumns` to the right of where it was found: the last lanes of the
// vector before, and the first ones of this.
template <int kColumns>
inline Doubles shifted(const Doubles& before, const Doubles& here) {
    constexpr int k = EMBER_LANES - kColumns;
#if EMBER_LANES == 8
    return __builtin_shufflevector(before, here, k, k + 1, k + 2, k + 3, k + 4, k + 5, k + 6,
                                   k + 7);
#elif EMBER_LANES == 4
    return __builtin_shufflevector(before, here, k, k + 1, k + 2, k + 3);
#else
    return __builtin_shufflevector(before, here, k, k + 1);
#endif
}

template <int kColumns>
inline Force shifted(const Force& before, const Force& here) {
    return {shifted<kColumns>(before.x, here.x), shifted<kColumns>(before.y, here.y),
            shifted<kColumns>(before.z, here.z)};
}

template <int kColumns>
inline SplitForce shifted(const SplitForce& before, const SplitForce& here) {
    return {shifted<kColumns>(before.all, here.all),
            shifted<kColumns>(before.friction, here.friction)};
}

inline void load_force(const double* from, std::ptrdiff_t pitch, Force& f) {
    f = {load(from), load(from + pitch), load(from + 2 * pitch)};
}

inline void load_force(const double* from, std::ptrdiff_t pitch, SplitForce& f) {
    load_force(from, pitch, f.all);
    load_force(from + 3 * pitch, pitch, f.friction);
}

inline void store_force(double* to, std::ptrdiff_t pitch, const Force& f) {
    store(to, f.x), store(to + pitch, f.y), store(to + 2 * pitch, f.z);
}

inline void store_force(double* to, std::ptrdiff_t pitch, const SplitForce& f) {
    store_force(to, pitch, f.all);
    store_force(to + 3 * pitch, pitch, f.friction);
}

// Reactions on nodes one and two columns to the right, and below and one to the right.
template <class F>
struct Carried {
    F right, right_2, below_right;
};

// The springs of as many columns as there are lanes. Forces stay in registers until they belong to
// the nodes at hand.
template <class F>
inline void add_springs(const SpringRow& row, std::ptrdiff_t column, Carried<F>& carried,
                        Doubles& lost) {
    const std::ptrdiff_t block = column / kBlockColumns, lane = column % kBlockColumns;
    const double* k = row.constants + block * kKinds * kConstants * kBlockColumns + lane;
    constexpr std::ptrdiff_t kKind = kConstants * kBlockColumns;
    const Ends here = ends_at(row, 0, column), right = ends_at(row, 0, column + 1),
               below = ends_at(row, 1, column);
    Carried<F> now;
    F own, down, f;  // pulls on the nodes, and reactions on those below

    pull(k + 5 * kKind, here, ends_at(row, 2, column), lost, f);
    own = f;
    store_force(row.reaction[2] + column, row.pitch, f);
    pull(k + 4 * kKind, here, ends_at(row, 0, column + 2), lost, f);
    own += f;
    now.right_2 = f;
    pull(k + 2 * kKind, here, ends_at(row, 1, column + 1), lost, f);
    own += f;
    now.below_right = f;
    pull(k + 1 * kKind, here, below, lost, f);
    own += f;
    down = f;
    pull(k, here, right, lost, f);
    own += f;
    now.right = f;
    pull(k + 3 * kKind, right, below, lost, f);
    now.right -= f;
    down += f;

    own -= shifted<1>(carried.right, now.right);
    own -= shifted<2>(carried.right_2, now.right_2);
    load_force(row.reaction[0] + column, row.pitch, f);
    own -= f;
    store_force(row.force + column, row.pitch, own);
    down += shifted<1>(carried.below_right, now.below_right);
    load_force(row.reaction[1] + column, row.pitch, f);
    down += f;
    store_force(row.reaction[1] + column, row.pitch, down);
    carried = now;
}

template <class F>
void evaluate(const SpringRow& given) {
    const SpringRow row = given;  // a copy that the stores cannot be thought to change
    constexpr std::ptrdiff_t kParts = kBlockColumns / kWidth;
    Carried<F> carried{};
    Doubles lost[kParts]{};
    for (std::ptrdiff_t column = 0; column < row.columns; column += kBlockColumns) {
        for (std::ptrdiff_t part = 0; part < kParts; ++part)
            add_springs<F>(row, column + part * kWidth, carried, lost[part]);
    }
    for (std::ptrdiff_t part = 0; part < kParts; ++part)
        store(row.loss + part * kWidth, lost[part]);
}

}  // namespace

extern const SpringKernel EMBER_KERNEL_NAME;
const SpringKernel EMBER_KERNEL_NAME{evaluate<Force>, evaluate<SplitForce>};

}  // namespace ember
