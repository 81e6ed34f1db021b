#include "sim/patch_sums.h"

namespace ember {
namespace {

// How far lanes are outside an interval; 0 inside.
template <class Part>
EMBER_LANES_INLINE void outside(const Part& at, double low, double high, Part& by) {
    const Part below = low - at, above = at - high;
    by = below > above ? below : above;
    by = by > 0.0 ? by : Part{};
}

// Writes down `first` + l for the first lanes l, `left` of them, whose bits are set. There is no
// branch, as which they are cannot be foreseen.
template <std::size_t kWidth>
EMBER_LANES_INLINE void append(const typename Lanes<kWidth>::Bits (&bits)[Lanes<kWidth>::kParts],
                               Index first, Index left, Index* to, std::size_t& size) {
#ifdef EMBER_LANES_DISPATCHED
    if constexpr (kWidth == kLanes) {
        typedef long long Longs __attribute__((vector_size(64)));
        typedef int Ints __attribute__((vector_size(64)));
        const Ints numbers = first + Ints{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
        const auto valid = static_cast<unsigned char>(left < 8 ? (1 << left) - 1 : 0xFF);
        const unsigned char in = __builtin_ia32_ptestmq512((Longs)bits[0], (Longs)bits[0], valid);
        __builtin_ia32_compressstoresi512_mask((Ints*)(to + size), numbers, in);
        size += static_cast<std::size_t>(__builtin_popcount(in));
        return;
    }
#endif
    // all are written, and only the right ones kept
    std::int64_t lane[kLanes];
    std::memcpy(lane, bits, sizeof lane);
#pragma GCC unroll 8
    for (Index l = 0; l < static_cast<Index>(kLanes); ++l) {
        to[size] = first + l;
        size += static_cast<std::size_t>(lane[l] & (l < left ? 1 : 0));
    }
}

// One particle in each lane.
template <std::size_t kWidth>
EMBER_LANES_INLINE void list(const ParticleGrid& grid, const NodePatch& patch,
                             const ParticleRun* runs, std::size_t count, Index* particles,
                             std::size_t& size) {
    using L = Lanes<kWidth>;
    const Box box = patch.box;
    const double reach2 = grid.reach * grid.reach;
    std::size_t n = 0;
    for (std::size_t r = 0; r < count; ++r) {
        for (Index i = runs[r].begin; i < runs[r].end; i += static_cast<Index>(kLanes)) {
            L x, y, z;
            x.load(&grid.x[static_cast<std::size_t>(i)]);
            y.load(&grid.y[static_cast<std::size_t>(i)]);
            z.load(&grid.z[static_cast<std::size_t>(i)]);
            typename L::Bits near[L::kParts];
            for (std::size_t k = 0; k < L::kParts; ++k) {
                typename L::Part dx, dy, dz;
                outside(x.part[k], box.low[0], box.high[0], dx);
                outside(y.part[k], box.low[1], box.high[1], dy);
                outside(z.part[k], box.low[2], box.high[2], dz);
                near[k] = (typename L::Bits)(dx * dx + dy * dy + dz * dz <= reach2);
            }
            append<kWidth>(near, i, runs[r].end - i, particles, n);
        }
    }
    size = n;
}

EMBER_LANES_ENTRY(list_particles,
                  (const ParticleGrid& grid, const NodePatch& patch, const ParticleRun* runs,
                   std::size_t count, Index* particles, std::size_t& size),
                  list<kWidth>(grid, patch, runs, count, particles, size))

// One node in each lane, one particle after the other: no lane ever waits for another, and the five
// sums of all nodes stay in registers.
template <std::size_t kWidth>
EMBER_LANES_INLINE void visit(const ParticleGrid& grid, const NodePatch& patch,
                              const Index* particles, std::size_t count, double inverse_r2,
                              double* __restrict absorbed, PatchSums& sums) {
    using L = Lanes<kWidth>;
    const double *__restrict px = grid.x.data(), *__restrict py = grid.y.data(),
                             *__restrict pz = grid.z.data(), *__restrict pvx = grid.vx.data(),
                             *__restrict pvy = grid.vy.data(), *__restrict pvz = grid.vz.data(),
                             *__restrict heat = grid.heating.data();
    L x, y, z, share, heating, weight, mx, my, mz;
    x.load(patch.x.data()), y.load(patch.y.data()), z.load(patch.z.data());
    share.load(patch.share.data());
    heating.clear(), weight.clear(), mx.clear(), my.clear(), mz.clear();
    for (std::size_t n = 0; n < count; ++n) {
        const auto i = static_cast<std::size_t>(particles[n]);
        L given;
#pragma GCC unroll 4
        for (std::size_t k = 0; k < L::kParts; ++k) {
            const auto dx = px[i] - x.part[k], dy = py[i] - y.part[k], dz = pz[i] - z.part[k];
            const auto q = 1.0 - (dx * dx + dy * dy + dz * dz) * inverse_r2;
            // max(q, 0) = (q + |q|) / 2, without a branch or a mask
            const auto size =
                (typename L::Part)((typename L::Bits)q & std::int64_t{0x7FFFFFFFFFFFFFFF});
            const auto inside = 0.5 * (q + size);
            const auto w = inside * inside;
            heating.part[k] += heat[i] * w;
            weight.part[k] += w;
            mx.part[k] += pvx[i] * w;
            my.part[k] += pvy[i] * w;
            mz.part[k] += pvz[i] * w;
            given.part[k] = share.part[k] * w;
        }
        absorbed[i] += sum_of(given);
    }
    heating.store(sums.heating.data()), weight.store(sums.weight.data());
    mx.store(sums.momentum_x.data()), my.store(sums.momentum_y.data());
    mz.store(sums.momentum_z.data());
}

EMBER_LANES_ENTRY(add_particles,
                  (const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
                   std::size_t count, double inverse_r2, double* absorbed, PatchSums& sums),
                  visit<kWidth>(grid, patch, particles, count, inverse_r2, absorbed, sums))

template <std::size_t kWidth>
EMBER_LANES_INLINE void visit_directions(const ParticleGrid& grid, const NodePatch& patch,
                                         const Index* particles, std::size_t count,
                                         double inverse_r2, PatchDirections& sums) {
    using L = Lanes<kWidth>;
    L x, y, z, sx, sy, sz;
    x.load(patch.x.data()), y.load(patch.y.data()), z.load(patch.z.data());
    sx.clear(), sy.clear(), sz.clear();
    for (std::size_t n = 0; n < count; ++n) {
        const auto i = static_cast<std::size_t>(particles[n]);
#pragma GCC unroll 4
        for (std::size_t k = 0; k < L::kParts; ++k) {
            const auto dx = grid.x[i] - x.part[k], dy = grid.y[i] - y.part[k],
                       dz = grid.z[i] - z.part[k];
            const auto q = 1.0 - (dx * dx + dy * dy + dz * dz) * inverse_r2;
            // max(q, 0), as above
            const auto size =
                (typename L::Part)((typename L::Bits)q & std::int64_t{0x7FFFFFFFFFFFFFFF});
            const auto inside = 0.5 * (q + size);
            const auto heat = grid.heating[i] * inside * inside;
            sx.part[k] += heat * dx;
            sy.part[k] += heat * dy;
            sz.part[k] += heat * dz;
        }
    }
    sx.store(sums.x.data()), sy.store(sums.y.data()), sz.store(sums.z.data());
}

EMBER_LANES_ENTRY(direct_particles,
                  (const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
                   std::size_t count, double inverse_r2, PatchDirections& sums),
                  visit_directions<kWidth>(grid, patch, particles, count, inverse_r2, sums))

}  // namespace

std::size_t list_near(const ParticleGrid& grid, const NodePatch& patch, const ParticleRun* runs,
                      std::size_t count, Index* list) {
    std::size_t size = 0;
    list_particles(grid, patch, runs, count, list, size);
    return size;
}

void add_directions(const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
                    std::size_t count, double inverse_r2, PatchDirections& sums) {
    direct_particles(grid, patch, particles, count, inverse_r2, sums);
}

void add_patch(const ParticleGrid& grid, const NodePatch& patch, const Index* particles,
               std::size_t count, double inverse_r2, double* absorbed, PatchSums& sums) {
    add_particles(grid, patch, particles, count, inverse_r2, absorbed, sums);
}

}  // namespace ember
