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

// Drag F = -c [(v·n) n + τ (v - (v·n) n)] on nodes, added to f; `power` is what it takes from
// those that move.
EMBER_VECTORISED void add_drag(const NodeLoads& loads, const Run run,
                               const std::array<const double*, 3>& v,
                               const std::array<double*, 3>& f, double* __restrict power) {
    const double tau = loads.drag_tangential;
    const double *vx = v[0], *vy = v[1], *vz = v[2];
    const double *nx = loads.normal.x.data() + run.first, *ny = loads.normal.y.data() + run.first,
                 *nz = loads.normal.z.data() + run.first;
    const double *drag = loads.drag.data() + run.first,
                 *inverse_mass = loads.inverse_mass.data() + run.first;
    double* __restrict fx = f[0], * __restrict fy = f[1], * __restrict fz = f[2];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < run.count; ++i) {
        const double across = vx[i] * nx[i] + vy[i] * ny[i] + vz[i] * nz[i];
        const double along = (1.0 - tau) * across, c = drag[i];
        fx[i] -= c * (along * nx[i] + tau * vx[i]);
        fy[i] -= c * (along * ny[i] + tau * vy[i]);
        fz[i] -= c * (along * nz[i] + tau * vz[i]);
        const double lost =
            c * (along * across + tau * (vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i]));
        power[i] = inverse_mass[i] > 0.0 ? lost : 0.0;
    }
}

// Power of the same drag on another velocity, u = w + h/2 a.
EMBER_VECTORISED void drag_on_drift(const NodeLoads& loads, const Run run,
                                    const std::array<const double*, 3>& v,
                                    const std::array<const double*, 3>& w,
                                    const std::array<const double*, 3>& a, double h,
                                    double* __restrict power) {
    const double tau = loads.drag_tangential, half = 0.5 * h;
    const double *vx = v[0], *vy = v[1], *vz = v[2], *wx = w[0], *wy = w[1], *wz = w[2];
    const double *ax = a[0], *ay = a[1], *az = a[2];
    const double *nx = loads.normal.x.data() + run.first, *ny = loads.normal.y.data() + run.first,
                 *nz = loads.normal.z.data() + run.first;
    const double *drag = loads.drag.data() + run.first,
                 *inverse_mass = loads.inverse_mass.data() + run.first;
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < run.count; ++i) {
        const double ux = wx[i] + half * ax[i], uy = wy[i] + half * ay[i],
                     uz = wz[i] + half * az[i];
        const double across = (vx[i] * nx[i] + vy[i] * ny[i] + vz[i] * nz[i]) *
                              (ux * nx[i] + uy * ny[i] + uz * nz[i]);
        const double all = vx[i] * ux + vy[i] * uy + vz[i] * uz;
        const double lost = drag[i] * ((1.0 - tau) * across + tau * all);
        power[i] = inverse_mass[i] > 0.0 ? lost : 0.0;
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
    double* power = f + 3 * pitch;
    if (loads.has_drag) {
        add_drag(loads, run, components(v, n, run.first), components(f, pitch, 0), power);
    }
    const double* inverse_mass = loads.inverse_mass.data() + run.first;
    const double* load[] = {loads.force.x.data(), loads.force.y.data(), loads.force.z.data()};
    for (int axis = 0; axis < 3; ++axis) {
        divide_by_mass(run.count, f + axis * pitch, load[axis] + run.first, inverse_mass,
                       a + axis * n + run.first);
    }
    if (!loads.has_drag) return 0.0;
    if (drift != nullptr) {
        drag_on_drift(loads, run, components(v, n, run.first), components(drift->w, n, run.first),
                      components<const double*>(a, n, run.first), drift->h, power);
    }
    return sum_in_lanes(power, run.count);
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
