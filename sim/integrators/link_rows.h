// Loops of the linear system over springs or nodes that lie next to each other. Included by
// linear_system.cpp alone.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "sim/vectorise.h"

namespace ember {
namespace {

using Pointers = std::array<double*, 3>;
using ConstPointers = std::array<const double*, 3>;

// Unit vectors along springs from a to b, k along and across them: tension stiffens across.
EMBER_VECTORISED void linearise(std::ptrdiff_t count, const ConstPointers a, const ConstPointers b,
                                const double* stiffness, const double* rest, const Pointers axis,
                                double* __restrict along, double* __restrict across) {
    double* __restrict ux = axis[0], * __restrict uy = axis[1], * __restrict uz = axis[2];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = b[0][i] - a[0][i], dy = b[1][i] - a[1][i], dz = b[2][i] - a[2][i];
        const double inverse = 1.0 / std::sqrt(dx * dx + dy * dy + dz * dz + 1e-300);
        const double tension = stiffness[i] * (1.0 - rest[i] * inverse);
        ux[i] = dx * inverse, uy[i] = dy * inverse, uz[i] = dz * inverse;
        along[i] = stiffness[i];
        across[i] = tension > 0.0 ? tension : 0.0;
    }
}

EMBER_VECTORISED void begin_blocks(std::ptrdiff_t count, double s, const double* mass,
                                   const double* drag, const double* plate,
                                   const std::array<double*, 6> block) {
    double* __restrict xx = block[0], * __restrict xy = block[1], * __restrict xz = block[2], * __restrict yy = block[3], * __restrict yz = block[4], * __restrict zz = block[5];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double own = mass[i] + s * drag[i] + s * s * plate[i];
        xx[i] = own, yy[i] = own, zz[i] = own;
        xy[i] = 0.0, xz[i] = 0.0, yz[i] = 0.0;
    }
}

EMBER_VECTORISED void add_blocks(std::ptrdiff_t count, double s, const ConstPointers axis,
                                 const double* along, const double* across, const double* damping,
                                 const std::array<double*, 6> block) {
    double* __restrict xx = block[0], * __restrict xy = block[1], * __restrict xz = block[2], * __restrict yy = block[3], * __restrict yz = block[4], * __restrict zz = block[5];
    const double *x = axis[0], *y = axis[1], *z = axis[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double side = s * s * across[i];
        const double more = s * damping[i] + s * s * (along[i] - across[i]);
        xx[i] += more * x[i] * x[i] + side;
        xy[i] += more * x[i] * y[i];
        xz[i] += more * x[i] * z[i];
        yy[i] += more * y[i] * y[i] + side;
        yz[i] += more * y[i] * z[i];
        zz[i] += more * z[i] * z[i] + side;
    }
}

// Adjugate over determinant; 0 for held nodes.
EMBER_VECTORISED void invert_blocks(std::ptrdiff_t count, const double* mass,
                                    const std::array<double*, 6> block) {
    double* __restrict xx = block[0], * __restrict xy = block[1], * __restrict xz = block[2], * __restrict yy = block[3], * __restrict yz = block[4], * __restrict zz = block[5];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double a = xx[i], b = xy[i], c = xz[i], d = yy[i], e = yz[i], f = zz[i];
        const double aa = d * f - e * e, bb = c * e - b * f, cc = b * e - c * d;
        const double determinant = a * aa + b * bb + c * cc;
        const double inverse = mass[i] > 0.0 ? 1.0 / determinant : 0.0;
        xx[i] = inverse * aa, xy[i] = inverse * bb, xz[i] = inverse * cc;
        yy[i] = inverse * (a * f - c * c);
        yz[i] = inverse * (b * c - a * e);
        zz[i] = inverse * (a * d - b * b);
    }
}

// z = block r, the terms of r·z, and those of r·M⁻¹r.
EMBER_VECTORISED void multiply_blocks(std::ptrdiff_t count,
                                      const std::array<const double*, 6> block,
                                      const double* inverse_mass, const ConstPointers r,
                                      const Pointers z, double* __restrict own,
                                      double* __restrict by_mass) {
    double* __restrict zx = z[0], * __restrict zy = z[1], * __restrict zz = z[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double x = r[0][i], y = r[1][i], w = r[2][i];
        const double px = block[0][i] * x + block[1][i] * y + block[2][i] * w;
        const double py = block[1][i] * x + block[3][i] * y + block[4][i] * w;
        const double pz = block[2][i] * x + block[4][i] * y + block[5][i] * w;
        zx[i] = px, zy[i] = py, zz[i] = pz;
        own[i] = x * px + y * py + w * pz;
        by_mass[i] = inverse_mass[i] * (x * x + y * y + w * w);
    }
}

EMBER_VECTORISED void begin_product(std::ptrdiff_t count, double s_mass, double s_damping,
                                    const double* mass, const double* drag, const ConstPointers p,
                                    const Pointers out) {
    double* __restrict x = out[0], * __restrict y = out[1], * __restrict z = out[2];
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double own = s_mass * mass[i] + s_damping * drag[i];
        x[i] = own * p[0][i], y[i] = own * p[1][i], z[i] = own * p[2][i];
    }
}

// What springs between nodes i, at which `out` is, and j contribute.
EMBER_VECTORISED void add_links(std::ptrdiff_t count, double s_damping, double s_stiffness,
                                const ConstPointers axis, const double* along, const double* across,
                                const double* damping, const ConstPointers own,
                                const ConstPointers other, const Pointers out) {
    double* __restrict x = out[0], * __restrict y = out[1], * __restrict z = out[2];
    const double *ux = axis[0], *uy = axis[1], *uz = axis[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = own[0][i] - other[0][i], dy = own[1][i] - other[1][i],
                     dz = own[2][i] - other[2][i];
        const double side = s_stiffness * across[i];
        const double more = (s_damping * damping[i] + s_stiffness * (along[i] - across[i])) *
                            (dx * ux[i] + dy * uy[i] + dz * uz[i]);
        x[i] += side * dx + more * ux[i];
        y[i] += side * dy + more * uy[i];
        z[i] += side * dz + more * uz[i];
    }
}

// out += factor · values
EMBER_VECTORISED void add_scaled(std::ptrdiff_t count, double factor, const ConstPointers values,
                                 const Pointers out) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* from = values[axis];
        double* __restrict to = out[axis];
        for (std::ptrdiff_t i = 0; i < count; ++i)
            to[i] += factor * from[i];
    }
}

// direction = z + beta direction
EMBER_VECTORISED void turn(std::ptrdiff_t count, double beta, const ConstPointers z,
                           const Pointers direction) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double* from = z[axis];
        double* __restrict to = direction[axis];
        for (std::ptrdiff_t i = 0; i < count; ++i)
            to[i] = from[i] + beta * to[i];
    }
}

EMBER_VECTORISED void hold(std::ptrdiff_t count, const double* mass, const Pointers out) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double* __restrict to = out[axis];
        for (std::ptrdiff_t i = 0; i < count; ++i)
            to[i] = mass[i] > 0.0 ? to[i] : 0.0;
    }
}

// out = mass · r - product
EMBER_VECTORISED void subtract_scaled(std::ptrdiff_t count, const double* mass, const double* r,
                                      const double* product, double* __restrict out) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        out[i] = mass[i] * r[i] - product[i];
}

EMBER_VECTORISED void dot_terms(std::ptrdiff_t count, const ConstPointers p, const ConstPointers q,
                                double* __restrict terms) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        terms[i] = p[0][i] * q[0][i] + p[1][i] * q[1][i] + p[2][i] * q[2][i];
}

}  // namespace
}  // namespace ember
