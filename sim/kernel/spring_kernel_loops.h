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

// One vector for each kind of springs.
using Kinds = Doubles[kKinds];

// 1/√s, in place. A division and a root in double precision would take twice as long as the rest of
// a spring, so both are taken in single precision, correctly rounded and hence the same on every
// processor, and one step of third order, error 5/16 e³ with |e| < 2^-22, makes them double.
[[gnu::always_inline]] inline void invert_roots(Kinds& s) {
    Kinds y, e;
#if EMBER_FAST
    for (int i = 0; i < kKinds; ++i) {
        y[i] = reinterpret_cast<Doubles>(
            _mm512_maskz_rsqrt14_pd(0xFF, reinterpret_cast<__m512d>(s[i])));
    }
    for (int i = 0; i < kKinds; ++i)
        e[i] = 1.0 - (s[i] * y[i]) * y[i];
    for (int i = 0; i < kKinds; ++i)
        s[i] = y[i] + (y[i] * e[i]) * (0.5 + e[i] * (0.375 + e[i] * 0.3125));
#else
    Floats root[kKinds];
    for (int i = 0; i < kKinds; ++i)
        root[i] = narrowed(s[i]);
    for (auto& each : root) {
        for (int lane = 0; lane < EMBER_LANES; ++lane)
            each[lane] = __builtin_sqrtf(each[lane]);
    }
    for (int i = 0; i < kKinds; ++i)
        y[i] = widened(1.0f / root[i]);
    for (int i = 0; i < kKinds; ++i)
        e[i] = 1.0 - (s[i] * y[i]) * y[i];
    for (int i = 0; i < kKinds; ++i)
        s[i] = y[i] + (y[i] * e[i]) * (0.5 + e[i] * 0.375);
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

// Springs of all kinds as they lie: Δx, Δv·Δx, and 1/|Δx|.
struct Spans {
    Kinds x, y, z, along, inverse;

    // Puts |Δx|² where its inverse root will be. Springs shorter than 1e-15 m have no direction;
    // the offset keeps their result finite, and since that multiplies Δx, they exert no force.
    void set(int kind, const Ends& a, const Ends& b) {
        const Doubles dx = b.x - a.x, dy = b.y - a.y, dz = b.z - a.z;
        x[kind] = dx, y[kind] = dy, z[kind] = dz;
        inverse[kind] = dx * dx + dy * dy + dz * dz + 1e-30;
        along[kind] = (b.u - a.u) * dx + (b.v - a.v) * dy + (b.w - a.w) * dz;
    }
};

// This and invert_roots() are inlined by order: shared between the two kinds of forces, they would
// hand everything on through memory.
[[gnu::always_inline]] inline void find_spans(const SpringRow& row, std::ptrdiff_t column,
                                              Spans& spans) {
    const Ends here = ends_at(row, 0, column), right = ends_at(row, 0, column + 1),
               below = ends_at(row, 1, column);
    spans.set(5, here, ends_at(row, 2, column));
    spans.set(4, here, ends_at(row, 0, column + 2));
    spans.set(2, here, ends_at(row, 1, column + 1));
    spans.set(1, here, below);
    spans.set(0, here, right);
    spans.set(3, right, below);
    invert_roots(spans.inverse);
}

// Pull on the first ends, F = [k (1 - l/L) + d (Δv·Δx)/L²] Δx. Adds the power lost, d (Δv·n)².
inline void pull(const double* constants, const Spans& spans, int kind, Doubles& lost, Force& f,
                 Force* part) {
    constants += kind * kConstants * kBlockColumns;
    const Doubles inverse = spans.inverse[kind], rate = spans.along[kind] * inverse;
    const Doubles friction = load(constants + 2 * kBlockColumns) * rate;
    const Doubles scale = load(constants) + inverse * (friction - load(constants + kBlockColumns));
    f = {scale * spans.x[kind], scale * spans.y[kind], scale * spans.z[kind]};
    if (part == nullptr) {
        lost += friction * rate;
        return;
    }
    const Doubles share = inverse * friction;
    *part = {share * spans.x[kind], share * spans.y[kind], share * spans.z[kind]};
}

inline void pull(const double* constants, const Spans& spans, int kind, Doubles& lost, Force& f) {
    pull(constants, spans, kind, lost, f, nullptr);
}

inline void pull(const double* constants, const Spans& spans, int kind, Doubles& lost,
                 SplitForce& f) {
    pull(constants, spans, kind, lost, f.all, &f.friction);
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
//
// All kinds go through each stage together. From the ends of a spring to its pull every operation
// waits for the one before, more than a hundred cycles in all, and a processor that looks ahead by
// two or three springs would mostly wait if they came one after the other.
template <class F>
inline void add_springs(const SpringRow& row, std::ptrdiff_t column, Carried<F>& carried,
                        Doubles& lost) {
    const std::ptrdiff_t block = column / kBlockColumns, lane = column % kBlockColumns;
    const double* k = row.constants + block * kKinds * kConstants * kBlockColumns + lane;
    Spans spans;
    find_spans(row, column, spans);
    Carried<F> now;
    F own, down, f;  // pulls on the nodes, and reactions on those below

    pull(k, spans, 5, lost, f);
    own = f;
    store_force(row.reaction[2] + column, row.pitch, f);
    pull(k, spans, 4, lost, f);
    own += f;
    now.right_2 = f;
    pull(k, spans, 2, lost, f);
    own += f;
    now.below_right = f;
    pull(k, spans, 1, lost, f);
    own += f;
    down = f;
    pull(k, spans, 0, lost, f);
    own += f;
    now.right = f;
    pull(k, spans, 3, lost, f);
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
