#include "sim/node_step.h"

#include "sim/vectorise.h"

namespace ember {

EMBER_VECTORISED void divide_by_mass(const NodeLoads& loads, const NodeRun run,
                                     const std::array<const double*, 3>& f,
                                     const std::array<double*, 3>& a) {
    const double *fx = f[0], *fy = f[1], *fz = f[2];
    const double *lx = loads.force.x.data() + run.first, *ly = loads.force.y.data() + run.first,
                 *lz = loads.force.z.data() + run.first,
                 *inverse_mass = loads.inverse_mass.data() + run.first;
    double* __restrict ax = a[0], * __restrict ay = a[1], * __restrict az = a[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < run.count; ++i) {
        const double inverse = inverse_mass[i];
        ax[i] = (fx[i] + lx[i]) * inverse;
        ay[i] = (fy[i] + ly[i]) * inverse;
        az[i] = (fz[i] + lz[i]) * inverse;
    }
}

EMBER_VECTORISED void divide_in_air(const NodeLoads& loads, const NodeRun run,
                                    const std::array<const double*, 3>& f,
                                    const std::array<const double*, 3>& v,
                                    const std::array<double*, 3>& a, double* __restrict power) {
    const double tau = loads.drag_tangential;
    const double *fx = f[0], *fy = f[1], *fz = f[2], *vx = v[0], *vy = v[1], *vz = v[2];
    const double *nx = loads.normal.x.data() + run.first, *ny = loads.normal.y.data() + run.first,
                 *nz = loads.normal.z.data() + run.first;
    const double *lx = loads.force.x.data() + run.first, *ly = loads.force.y.data() + run.first,
                 *lz = loads.force.z.data() + run.first;
    const double *drag = loads.drag.data() + run.first,
                 *inverse_mass = loads.inverse_mass.data() + run.first;
    double* __restrict ax = a[0], * __restrict ay = a[1], * __restrict az = a[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < run.count; ++i) {
        const double inverse = inverse_mass[i], c = drag[i];
        const double across = (1.0 - tau) * (vx[i] * nx[i] + vy[i] * ny[i] + vz[i] * nz[i]);
        const double gx = c * (across * nx[i] + tau * vx[i]);
        const double gy = c * (across * ny[i] + tau * vy[i]);
        const double gz = c * (across * nz[i] + tau * vz[i]);
        ax[i] = (fx[i] - gx + lx[i]) * inverse;
        ay[i] = (fy[i] - gy + ly[i]) * inverse;
        az[i] = (fz[i] - gz + lz[i]) * inverse;
        const double lost = gx * vx[i] + gy * vy[i] + gz * vz[i];
        power[i] = inverse > 0.0 ? lost : 0.0;
    }
}

EMBER_VECTORISED void kick_and_drift(const Leap& given, const NodeRun run, std::ptrdiff_t n,
                                     const std::array<const double*, 3>& a,
                                     const std::array<const double*, 3>& friction,
                                     double* __restrict power) {
    const Leap step = given;  // a copy that the stores cannot be thought to change
    const auto w = components(step.w, n, run.first), x = components(step.x, n, run.first),
               u = components(step.u, n, run.first);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double* __restrict wi = w[axis], * __restrict xi = x[axis], * __restrict ui = u[axis];
        const double *ai = a[axis], *fi = friction[axis];
        // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
        for (std::ptrdiff_t i = 0; i < run.count; ++i) {
            const double before = wi[i], after = before + step.kick * ai[i];
            wi[i] = after;
            xi[i] += step.drift * after;
            ui[i] = after + step.lead * ai[i];
            const double lost = fi[i] * (before + step.mean * ai[i]);
            power[i] = axis == 0 ? -lost : power[i] - lost;
        }
    }
}

EMBER_VECTORISED void leap_in_air(const NodeLoads& loads, const Leap& step, const NodeRun run,
                                  std::ptrdiff_t n, const std::array<const double*, 3>& f,
                                  const std::array<const double*, 3>& friction,
                                  double* __restrict dragged, double* __restrict rubbed) {
    const double tau = loads.drag_tangential, kick = step.kick, drift = step.drift,
                 lead = step.lead, mean = step.mean;
    const double *fx = f[0], *fy = f[1], *fz = f[2], *rx = friction[0], *ry = friction[1],
                 *rz = friction[2];
    const double *nx = loads.normal.x.data() + run.first, *ny = loads.normal.y.data() + run.first,
                 *nz = loads.normal.z.data() + run.first;
    const double *lx = loads.force.x.data() + run.first, *ly = loads.force.y.data() + run.first,
                 *lz = loads.force.z.data() + run.first;
    const double *drag = loads.drag.data() + run.first,
                 *inverse_mass = loads.inverse_mass.data() + run.first;
    double* __restrict w = step.w + run.first;
    double* __restrict x = step.x + run.first;
    double* __restrict u = step.u + run.first;
    const std::ptrdiff_t n2 = 2 * n;
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < run.count; ++i) {
        const double inverse = inverse_mass[i], c = drag[i];
        const double vx = u[i], vy = u[n + i], vz = u[n2 + i];
        const double across = (1.0 - tau) * (vx * nx[i] + vy * ny[i] + vz * nz[i]);
        const double gx = c * (across * nx[i] + tau * vx);
        const double gy = c * (across * ny[i] + tau * vy);
        const double gz = c * (across * nz[i] + tau * vz);
        const double bx = (fx[i] - gx + lx[i]) * inverse;
        const double by = (fy[i] - gy + ly[i]) * inverse;
        const double bz = (fz[i] - gz + lz[i]) * inverse;
        const double wx = w[i], wy = w[n + i], wz = w[n2 + i];
        const double mx = wx + mean * bx, my = wy + mean * by, mz = wz + mean * bz;
        const double lost = gx * mx + gy * my + gz * mz;
        dragged[i] = inverse > 0.0 ? lost : 0.0;
        rubbed[i] = -(rx[i] * mx) - ry[i] * my - rz[i] * mz;
        const double ax = wx + kick * bx, ay = wy + kick * by, az = wz + kick * bz;
        w[i] = ax, w[n + i] = ay, w[n2 + i] = az;
        x[i] += drift * ax, x[n + i] += drift * ay, x[n2 + i] += drift * az;
        u[i] = ax + lead * bx, u[n + i] = ay + lead * by, u[n2 + i] = az + lead * bz;
    }
}

}  // namespace ember
