#include "sim/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/vectorise.h"

namespace ember {
namespace {

using Blocks = std::array<double*, 7>;

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
        const double stretch = std::abs(1.0 - rest[i] / std::sqrt(square));
        const double across = k * (stretch < 1.0 ? stretch : 1.0);
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

void add_springs(std::ptrdiff_t count, const Positions& p, std::ptrdiff_t a, std::ptrdiff_t b,
                 const double* stiffness, const double* damping, const double* rest,
                 StabilityScratch& scratch) {
    spring_blocks(count, p, a, b, stiffness, damping, rest, pointers(scratch.row));
    for (std::size_t i = 0; i < scratch.row.size(); ++i) {
        add_run(count, scratch.row[i].data(), scratch.blocks[i].data() + a);
        add_run(count, scratch.row[i].data(), scratch.blocks[i].data() + b);
    }
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

void sum_blocks(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                const Positions& p, StabilityScratch& scratch) {
    for_each_spring_row(lattice, [&](std::ptrdiff_t count, Index a, Index b, std::size_t slot) {
        add_springs(count, p, a, b, &network.stiffness[slot], &network.damping[slot],
                    &sheet.rest_length[slot], scratch);
    });
    for (std::size_t i = 0; i < network.extra.size(); ++i) {
        const ExtraSpring& spring = network.extra[i];
        add_springs(1, p, spring.a, spring.b, &network.extra_stiffness[i],
                    &network.extra_damping[i],
                    &sheet.rest_length[static_cast<std::size_t>(spring.slot)], scratch);
    }
}

}  // namespace

FastestMotion find_fastest_motion(const Lattice& lattice, const SheetState& sheet,
                                  const SpringNetwork& network, const NodeLoads& loads,
                                  StabilityScratch& scratch) {
    const std::size_t nodes = sheet.mass.size();
    scratch.root.resize(nodes);
    for (std::size_t n = 0; n < nodes; ++n)
        scratch.root[n] = std::sqrt(loads.inverse_mass[n]);
    for (auto& array : scratch.blocks)
        array.assign(nodes, 0.0);
    for (auto& array : scratch.row)
        array.resize(std::max(nodes, static_cast<std::size_t>(lattice.column_count)));
    const Positions p{sheet.position.x.data(), sheet.position.y.data(), sheet.position.z.data(),
                      scratch.root.data()};
    sum_blocks(lattice, sheet, network, p, scratch);
    std::vector<double>& largest = scratch.row[0];
    largest_eigenvalues(static_cast<std::ptrdiff_t>(nodes), pointers(scratch.blocks), p.root,
                        largest.data());
    FastestMotion fastest;
    double omega_squared = 0.0;
    for (std::size_t n = 0; n < nodes; ++n) {
        omega_squared = std::max(omega_squared, largest[n]);
        const double drag = loads.has_drag ? loads.drag[n] * loads.inverse_mass[n] : 0.0;
        fastest.gamma = std::max(fastest.gamma, scratch.blocks[6][n] * scratch.root[n] + drag);
    }
    fastest.omega = std::sqrt(omega_squared);
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
        // the others: the largest half disc in the left half-plane that is stable
        case IntegratorKind::Dopri5:
            return 1.0 / rate;
        case IntegratorKind::Rkf78:
            return 2.38 / rate;
        case IntegratorKind::AdamsBashforthMoulton:
            return 0.5 / rate;
        case IntegratorKind::Auto:
        case IntegratorKind::Rk4:
            return 2.6 / rate;  // 2.83 holds only undamped
    }
    return 0.0;
}

}  // namespace ember
