#include "sim/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/vectorise.h"

namespace ember {
namespace {

using Blocks = std::array<double*, 7>;
constexpr std::size_t kDiagonals[] = {0, 3, 5};  // xx, yy, zz

Blocks pointers(std::array<std::vector<double>, 7>& arrays, std::size_t offset = 0) {
    Blocks p{};
    for (std::size_t i = 0; i < p.size(); ++i)
        p[i] = arrays[i].data() + offset;
    return p;
}

struct Positions {
    const double *x, *y, *z, *root;
};

// (1/√m_a + 1/√m_b) K of `count` springs between nodes a+i and b+i.
EMBER_VECTORISED void spring_blocks(std::ptrdiff_t count, const Positions p, std::ptrdiff_t a,
                                    std::ptrdiff_t b, const double* __restrict stiffness,
                                    const double* __restrict damping, const double* __restrict rest,
                                    const Blocks& out) {
    double* __restrict xx = out[0], * __restrict xy = out[1], * __restrict xz = out[2], * __restrict yy = out[3], * __restrict yz = out[4], * __restrict zz = out[5], * __restrict dd = out[6];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = p.x[b + i] - p.x[a + i], dy = p.y[b + i] - p.y[a + i],
                     dz = p.z[b + i] - p.z[a + i];
        const double square = dx * dx + dy * dy + dz * dz + 1e-30;
        const double scale = p.root[a + i] + p.root[b + i], k = scale * stiffness[i];
        const double stretch = 1.0 - rest[i] / std::sqrt(square);
        const double across = k * (stretch > 0.0 ? stretch : 0.0);
        const double along = (k - across) / square;
        xx[i] = along * dx * dx + across;
        xy[i] = along * dx * dy;
        xz[i] = along * dx * dz;
        yy[i] = along * dy * dy + across;
        yz[i] = along * dy * dz;
        zz[i] = along * dz * dz + across;
        dd[i] = scale * damping[i];
    }
}

EMBER_VECTORISED void add_run(std::ptrdiff_t count, const double* __restrict from,
                              double* __restrict to) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        to[i] += from[i];
}

EMBER_VECTORISED void square_roots(const double* __restrict from, std::ptrdiff_t count,
                                   double* __restrict to) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        to[i] = std::sqrt(from[i]);
}

// Largest eigenvalue of each symmetric positive semi-definite block, from above: Newton's method
// on the characteristic polynomial, whose roots are real, descends from any point above the
// largest towards it and never passes it. All blocks are divided by their trace first.
EMBER_VECTORISED void largest_eigenvalues(std::ptrdiff_t count, const Blocks& in,
                                          const double* __restrict root,
                                          double* __restrict largest) {
    constexpr int kIterations = 5;
    const double* __restrict xx = in[0], * __restrict xy = in[1], * __restrict xz = in[2], * __restrict yy = in[3], * __restrict yz = in[4], * __restrict zz = in[5];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double trace = xx[i] + yy[i] + zz[i];
        const double s = 1.0 / (trace + 1e-300);
        const double a = xx[i] * s, b = yy[i] * s, c = zz[i] * s;
        const double d = xy[i] * s, e = xz[i] * s, f = yz[i] * s;
        // λ³ - λ² + minors λ - determinant, for trace 1
        const double minors = a * b - d * d + a * c - e * e + b * c - f * f;
        const double determinant = a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e);
        double x = 1.0;
        for (int n = 0; n < kIterations; ++n) {
            const double value = ((x - 1.0) * x + minors) * x - determinant;
            const double slope = (3.0 * x - 2.0) * x + minors;
            // at a double root both vanish together; rounding may then turn the sign
            const double step = value / (slope > 0.0 ? slope : 1.0);
            x -= value > 0.0 && slope > 0.0 ? step : 0.0;
        }
        largest[i] = x * trace * root[i];
    }
}

// The nodes of some rows, by one thread.
class RowBlocks {
  public:
    RowBlocks(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
              const NodeLoads& loads, StabilityScratch& scratch, std::size_t thread)
        : lattice_(lattice),
          sheet_(sheet),
          network_(network),
          loads_(loads),
          scratch_(scratch),
          row_(scratch.row[thread]),
          positions_{sheet.position.x.data(), sheet.position.y.data(), sheet.position.z.data(),
                     scratch.root.data()} {
        for (auto& array : row_)
            array.resize(static_cast<std::size_t>(lattice.column_count));
    }

    /// Sums up the stencil's springs at the nodes of rows [begin, end).
    void sum(Index begin, Index end) {
        const auto first = lattice_.site(begin, 0), sites = lattice_.site(end, 0) - first;
        for (auto& block : scratch_.blocks)
            std::fill_n(block.begin() + first, sites, 0.0);
        if (!scratch_.plate.empty()) {
            for (const std::size_t diagonal : kDiagonals) {
                std::copy_n(scratch_.plate.begin() + first, sites,
                            scratch_.blocks[diagonal].begin() + first);
            }
        }
        for (Index place = begin - 2; place < end; ++place) {
            const Index row = lattice_.row_at(place, 0);
            if (row == kNone) continue;
            for_springs_of_row(
                lattice_, row, [&](std::ptrdiff_t count, Index a, Index b, std::size_t slot) {
                    // on a closed sheet the rows above the first are the last
                    const Index down = lattice_.row_of(b) - row;
                    const Index end_place = place + (down < 0 ? down + lattice_.row_count : down);
                    const bool at_a = place >= begin, at_b = end_place >= begin && end_place < end;
                    if (at_a || at_b) {
                        add(count, a, b, at_a, at_b, &network_.stiffness[slot],
                            &network_.damping[slot], &sheet_.rest_length[slot]);
                    }
                });
        }
    }

    /// Springs at cuts.
    void sum_extra() {
        for (std::size_t i = 0; i < network_.extra.size(); ++i) {
            const ExtraSpring& spring = network_.extra[i];
            add(1, spring.a, spring.b, true, true, &network_.extra_stiffness[i],
                &network_.extra_damping[i],
                &sheet_.rest_length[static_cast<std::size_t>(spring.slot)]);
        }
    }

    /// The fastest motion of nodes [first, last).
    FastestMotion fastest(std::ptrdiff_t first, std::ptrdiff_t last) {
        FastestMotion fastest;
        double omega_squared = 0.0;
        std::vector<double>& largest = row_[0];
        const auto columns = static_cast<std::ptrdiff_t>(largest.size());
        for (std::ptrdiff_t begin = first; begin < last; begin += columns) {
            const std::ptrdiff_t count = std::min(columns, last - begin);
            largest_eigenvalues(count, pointers(scratch_.blocks, static_cast<std::size_t>(begin)),
                                scratch_.root.data() + begin, largest.data());
            for (std::ptrdiff_t i = 0; i < count; ++i) {
                const auto n = static_cast<std::size_t>(begin + i);
                omega_squared = std::max(omega_squared, largest[static_cast<std::size_t>(i)]);
                const double drag = loads_.has_drag ? loads_.drag[n] * loads_.inverse_mass[n] : 0.0;
                fastest.gamma =
                    std::max(fastest.gamma, scratch_.blocks[6][n] * scratch_.root[n] + drag);
            }
        }
        fastest.omega = std::sqrt(omega_squared);
        return fastest;
    }

  private:
    void add(std::ptrdiff_t count, Index a, Index b, bool at_a, bool at_b, const double* stiffness,
             const double* damping, const double* rest) {
        spring_blocks(count, positions_, a, b, stiffness, damping, rest, pointers(row_));
        for (std::size_t i = 0; i < row_.size(); ++i) {
            if (at_a) add_run(count, row_[i].data(), scratch_.blocks[i].data() + a);
            if (at_b) add_run(count, row_[i].data(), scratch_.blocks[i].data() + b);
        }
    }

    const Lattice& lattice_;
    const SheetState& sheet_;
    const SpringNetwork& network_;
    const NodeLoads& loads_;
    StabilityScratch& scratch_;
    std::array<std::vector<double>, 7>& row_;
    const Positions positions_;
};

}  // namespace

FastestMotion find_fastest_motion(const Lattice& lattice, const SheetState& sheet,
                                  const SpringNetwork& network, const Plate* plate,
                                  const NodeLoads& loads, ThreadPool& pool,
                                  StabilityScratch& scratch) {
    const std::size_t nodes = sheet.mass.size();
    scratch.root.resize(nodes);
    square_roots(loads.inverse_mass.data(), static_cast<std::ptrdiff_t>(nodes),
                 scratch.root.data());
    for (auto& array : scratch.blocks) {
        array.resize(nodes);
        std::fill(array.begin() + lattice.site_count(), array.end(), 0.0);
    }
    scratch.plate.clear();
    if (plate != nullptr) {
        scratch.plate.resize(nodes, 0.0);
        add_plate_bound(lattice, *plate, sheet, scratch.root, scratch.plate);
        for (const std::size_t diagonal : kDiagonals) {
            std::copy(scratch.plate.begin() + lattice.site_count(), scratch.plate.end(),
                      scratch.blocks[diagonal].begin() + lattice.site_count());
        }
    }
    const auto threads = static_cast<std::size_t>(pool.size());
    scratch.row.resize(threads);
    scratch.fastest.assign(threads, {});
    const std::ptrdiff_t work = kSlotCount * lattice.column_count;
    const auto on_rows = [&](int part, std::ptrdiff_t begin, std::ptrdiff_t end) {
        const auto thread = static_cast<std::size_t>(part);
        RowBlocks rows(lattice, sheet, network, loads, scratch, thread);
        rows.sum(static_cast<Index>(begin), static_cast<Index>(end));
        // with extra springs, the sums are not complete yet
        if (network.extra.empty()) {
            scratch.fastest[thread] =
                rows.fastest(begin * lattice.column_count, end * lattice.column_count);
        }
    };
    pool.for_parts(lattice.row_count, work, on_rows);
    if (!network.extra.empty()) {
        RowBlocks all(lattice, sheet, network, loads, scratch, 0);
        all.sum_extra();
        pool.for_parts(static_cast<std::ptrdiff_t>(nodes), 1,
                       [&](int part, std::ptrdiff_t begin, std::ptrdiff_t end) {
                           const auto thread = static_cast<std::size_t>(part);
                           RowBlocks some(lattice, sheet, network, loads, scratch, thread);
                           scratch.fastest[thread] = some.fastest(begin, end);
                       });
    }
    FastestMotion fastest;
    for (const FastestMotion& part : scratch.fastest) {
        fastest.omega = std::max(fastest.omega, part.omega);
        fastest.gamma = std::max(fastest.gamma, part.gamma);
    }
    return fastest;
}

IntegratorKind choose_integrator(const NumericsParams& numerics, const FastestMotion& fastest,
                                 double dt) {
    constexpr double kMostSubsteps = 2000;
    if (numerics.integrator != IntegratorKind::Auto) return numerics.integrator;
    const double step = numerics.safety * stable_step(IntegratorKind::VelocityVerlet, fastest);
    return dt > kMostSubsteps * step ? IntegratorKind::Rosenbrock : IntegratorKind::VelocityVerlet;
}

double stable_step(IntegratorKind integrator, const FastestMotion& fastest) {
    constexpr double kForever = std::numeric_limits<double>::infinity();
    const double w = fastest.omega, g = fastest.gamma;
    const double rate = fastest.rate();
    if (!(rate > 0)) return rate == 0 ? kForever : 0.0;
    switch (integrator) {
        case IntegratorKind::Rosenbrock:
            return kForever;
        // damping taken at the velocity of the step before: ω²h² + 2γh < 4
        case IntegratorKind::SemiImplicitEuler:
            return 4.0 / (g + std::sqrt(g * g + 4.0 * w * w));
        // and at a velocity extrapolated half a step: ω²h² + 4γh < 4
        case IntegratorKind::VelocityVerlet:
            return 2.0 / (g + std::sqrt(g * g + w * w));
        // an ellipse in ωh and γh within its region of stability, at least three quarters of it
        // everywhere
        case IntegratorKind::AdamsBashforthMoulton:
            return 1.0 / std::sqrt(w * w / (1.2 * 1.2) + g * g / (0.75 * 0.75));
        // the others: the largest half disc in the left half-plane that is stable
        case IntegratorKind::Dopri5:
            return 1.0 / rate;
        case IntegratorKind::Rkf78:
            return 2.38 / rate;
        case IntegratorKind::Auto:
        case IntegratorKind::Rk4:
            return 2.6 / rate;  // 2.83 holds only undamped
    }
    return 0.0;
}

}  // namespace ember
