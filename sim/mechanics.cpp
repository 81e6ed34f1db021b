#include "sim/mechanics.h"

#include <algorithm>
#include <array>

#include "sim/vectorise.h"

namespace ember {
namespace {

// Pointers to the same component of a run of nodes.
struct Run {
    std::ptrdiff_t first, count;
};

EMBER_VECTORISED void add_to(std::ptrdiff_t count, const double* __restrict added,
                             double* __restrict sum) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        sum[i] += added[i];
}

EMBER_VECTORISED void divide_by_mass(std::ptrdiff_t count, const double* __restrict force,
                                     const double* __restrict load,
                                     const double* __restrict inverse_mass, double* __restrict a) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        a[i] = (force[i] + load[i]) * inverse_mass[i];
}

// Accelerations of nodes in the air, on which springs exert f, with drag
// F = -c [(v·n) n + τ (v - (v·n) n)]; `power` is what the drag takes at the velocity w + half·a.
// One pass, since the arrays of a large sheet have to come from far.
EMBER_VECTORISED void divide_in_air(const NodeLoads& loads, const Run run,
                                    const std::array<const double*, 3>& f,
                                    const std::array<const double*, 3>& v,
                                    const std::array<const double*, 3>& w, double half,
                                    const std::array<double*, 3>& a, double* __restrict power) {
    const double tau = loads.drag_tangential;
    const double *fx = f[0], *fy = f[1], *fz = f[2], *vx = v[0], *vy = v[1], *vz = v[2];
    const double *wx = w[0], *wy = w[1], *wz = w[2];
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
        const double bx = (fx[i] - gx + lx[i]) * inverse;
        const double by = (fy[i] - gy + ly[i]) * inverse;
        const double bz = (fz[i] - gz + lz[i]) * inverse;
        ax[i] = bx, ay[i] = by, az[i] = bz;
        const double lost =
            gx * (wx[i] + half * bx) + gy * (wy[i] + half * by) + gz * (wz[i] + half * bz);
        power[i] = inverse > 0.0 ? lost : 0.0;
    }
}

// The three components of an array of 3n, from a node on.
template <class Pointer>
std::array<Pointer, 3> components(Pointer array, std::ptrdiff_t n, std::ptrdiff_t first) {
    return {array + first, array + n + first, array + 2 * n + first};
}

// Accelerations of a run of nodes on which the springs in the stencil exert `f`, three rows of
// `pitch`, which is used up. Returns the power of the drag.
double finish(const Mechanics& m, const Run run, const double* v, double* f, std::ptrdiff_t pitch,
              double* a, const Drift* drift) {
    const auto n = static_cast<std::ptrdiff_t>(m.node_count());
    const NodeLoads& loads = m.loads;
    if (!m.forces.extra.total.empty()) {
        for (int axis = 0; axis < 3; ++axis) {
            add_to(run.count, m.forces.extra.total.data() + axis * n + run.first, f + axis * pitch);
        }
    }
    if (loads.has_drag) {
        double* power = f + 3 * pitch;
        const double* w = drift != nullptr ? drift->w : v;
        divide_in_air(loads, run, components<const double*>(f, pitch, 0),
                      components(v, n, run.first), components(w, n, run.first),
                      drift != nullptr ? 0.5 * drift->h : 0.0, components(a, n, run.first), power);
        return sum_in_lanes(power, run.count);
    }
    const double* inverse_mass = loads.inverse_mass.data() + run.first;
    const double* load[] = {loads.force.x.data(), loads.force.y.data(), loads.force.z.data()};
    for (int axis = 0; axis < 3; ++axis) {
        divide_by_mass(run.count, f + axis * pitch, load[axis] + run.first, inverse_mass,
                       a + axis * n + run.first);
    }
    return 0.0;
}

// Copies made by cuts come after the sites, and have extra springs only.
double accelerate_copies(const Mechanics& m, const double* v, double* a, const Drift* drift) {
    const auto n = static_cast<std::ptrdiff_t>(m.node_count());
    const std::ptrdiff_t columns = m.lattice.column_count, pitch = m.forces.pitch;
    double drag = 0.0;
    for (std::ptrdiff_t first = m.lattice.site_count(); first < n; first += columns) {
        double* f = m.forces.rings[0].data();
        std::fill_n(f, 3 * pitch, 0.0);
        drag += finish(m, {first, std::min(columns, n - first)}, v, f, pitch, a, drift);
    }
    // the ring's rows begin with zeros, which must be so again
    std::fill_n(m.forces.rings[0].data(), 4 * pitch, 0.0);
    return drag;
}

LostPower evaluate(const Mechanics& m, const NodeMotion& motion, double* a, const Drift* drift) {
    const double* v = motion.v;
    const std::ptrdiff_t columns = m.lattice.column_count;
    LostPower lost;
    lost.damping = m.forces.extra.evaluate(m.network, motion);
    for (const RowSpan& span : m.rows) {
        const auto run = [&](int part, std::ptrdiff_t begin, std::ptrdiff_t end) {
            RowForces rows(m.lattice, motion, m.kernel, m.forces, part);
            rows.start(span.begin + static_cast<Index>(begin));
            for (auto row = span.begin + begin; row < span.begin + end; ++row) {
                rows.next(static_cast<Index>(row));
                m.forces.row_drag[static_cast<std::size_t>(row)] =
                    finish(m, {row * columns, columns}, v, rows.force(0), m.forces.pitch, a, drift);
            }
        };
        m.pool.for_parts(span.end - span.begin, kKinds * columns, run);
    }
    for (const double power : m.forces.row_damping)
        lost.damping += power;
    for (const double power : m.forces.row_drag)
        lost.drag += power;
    if (!m.rows.empty() && m.node_count() > static_cast<std::size_t>(m.lattice.site_count())) {
        lost.drag += accelerate_copies(m, v, a, drift);
    }
    return lost;
}

}  // namespace

LostPower accelerate(const Mechanics& m, const double* x, const double* v, double* a) {
    return evaluate(m, {x, v, m.node_count()}, a, nullptr);
}

LostPower accelerate(const Mechanics& m, const double* x, const double* v, double* a,
                     const Drift& drift) {
    return evaluate(m, {x, v, m.node_count(), drift.w}, a, &drift);
}

}  // namespace ember
