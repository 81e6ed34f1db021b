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

EMBER_VECTORISED void divide_by_mass(const NodeLoads& loads, const Run run,
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

// The three components of an array whose components are `pitch` apart, from a node on.
template <class Pointer>
std::array<Pointer, 3> components(Pointer array, std::ptrdiff_t pitch, std::ptrdiff_t first) {
    return {array + first, array + pitch + first, array + 2 * pitch + first};
}

// w <- w + kick a, x <- x + drift w, u <- w + lead a; `power` is what the springs' friction takes.
EMBER_VECTORISED void kick_and_drift(const Leap step, const Run run, std::ptrdiff_t n,
                                     const std::array<const double*, 3>& a,
                                     const std::array<const double*, 3>& friction,
                                     double* __restrict power) {
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

// What becomes of the forces on a run of nodes: accelerations, or a step.
class Finish {
  public:
    Finish(const Mechanics& mechanics, const double* v, double* a) : m_(mechanics), v_(v), a_(a) {}
    Finish(const Mechanics& mechanics, const Leap& step)
        : m_(mechanics), v_(step.u), step_(&step) {}

    // Springs in the stencil exert `f` on the run, as SpringRow::force. Returns the power of the
    // drag, and for a step that of the springs' friction too.
    // With forces that were kept, `f` is given nothing.
    LostPower operator()(const Run run, double* f, int thread) const {
        if (evaluates()) add_extra(run, f);
        if (step_ != nullptr) keep(run, f);
        const std::ptrdiff_t pitch = m_.forces.pitch;
        double* power = m_.forces.finishing[static_cast<std::size_t>(thread)].data();
        if (step_ == nullptr)
            return {0.0, divide(run, f, components(a_, node_count(), run.first), power)};
        const auto a = components(power + pitch, pitch, 0);
        LostPower lost;
        lost.drag = divide(run, f, a, power);
        kick_and_drift(*step_, run, node_count(),
                       components<const double*>(power + pitch, pitch, 0),
                       components<const double*>(f + 3 * pitch, pitch, 0), power);
        lost.damping = sum_in_lanes(power, run.count);
        return lost;
    }

    [[nodiscard]] bool evaluates() const {
        return step_ == nullptr || step_->source != ForceSource::Kept;
    }

  private:
    [[nodiscard]] std::ptrdiff_t node_count() const {
        return static_cast<std::ptrdiff_t>(m_.node_count());
    }

    void keep(const Run run, double* f) const {
        if (step_->source == ForceSource::Motion) return;
        for (std::ptrdiff_t c = 0; c < 6; ++c) {
            double *here = f + c * m_.forces.pitch,
                   *there = step_->kept + c * node_count() + run.first;
            if (evaluates()) {
                std::copy_n(here, run.count, there);
            } else {
                std::copy_n(there, run.count, here);
            }
        }
    }

    void add_extra(const Run run, double* f) const {
        if (m_.plate != nullptr) {
            for (std::ptrdiff_t c = 0; c < 3; ++c) {
                add_to(run.count, m_.plate_forces->total.data() + c * node_count() + run.first,
                       f + c * m_.forces.pitch);
            }
        }
        const ExtraSprings& extra = m_.forces.extra;
        const bool copies = run.first >= m_.lattice.site_count();
        const std::ptrdiff_t row = run.first / m_.lattice.column_count;
        if (!copies && extra.in_row[static_cast<std::size_t>(row)] == 0) return;
        for (std::ptrdiff_t c = 0; c < (step_ == nullptr ? 3 : 6); ++c) {
            add_to(run.count, extra.total.data() + c * node_count() + run.first,
                   f + c * m_.forces.pitch);
        }
    }

    double divide(const Run run, const double* f, const std::array<double*, 3>& a,
                  double* power) const {
        const std::ptrdiff_t n = node_count(), pitch = m_.forces.pitch;
        const NodeLoads& loads = m_.loads;
        if (loads.has_drag) {
            const bool leaps = step_ != nullptr;
            divide_in_air(loads, run, components(f, pitch, 0), components(v_, n, run.first),
                          components(leaps ? step_->w : v_, n, run.first),
                          leaps ? step_->mean : 0.0, a, power);
            return sum_in_lanes(power, run.count);
        }
        divide_by_mass(loads, run, components<const double*>(f, pitch, 0), a);
        return 0.0;
    }

    const Mechanics& m_;
    const double* v_;
    double* a_ = nullptr;
    const Leap* step_ = nullptr;
};

// Copies made by cuts come after the sites, and have extra springs only.
void finish_copies(const Mechanics& m, const Finish& finish, LostPower& lost) {
    const auto n = static_cast<std::ptrdiff_t>(m.node_count());
    const std::ptrdiff_t columns = m.lattice.column_count, pitch = m.forces.pitch;
    for (std::ptrdiff_t first = m.lattice.site_count(); first < n; first += columns) {
        double* f = m.forces.rings[0].data();
        std::fill_n(f, 6 * pitch, 0.0);
        const LostPower power = finish({first, std::min(columns, n - first)}, f, 0);
        lost.damping += power.damping;
        lost.drag += power.drag;
    }
}

LostPower evaluate(const Mechanics& m, const NodeMotion& motion, const Finish& finish, bool leaps) {
    const std::ptrdiff_t columns = m.lattice.column_count;
    const bool anew = finish.evaluates();
    LostPower lost;
    if (anew && m.plate != nullptr) {
        m.plate_forces->evaluate(m.lattice, *m.plate, m.sheet.rest_curvature, motion.x,
                                 m.node_count(), m.pool);
    }
    const double in_extra = anew ? m.forces.extra.evaluate(m.network, motion) : 0.0;
    if (!leaps) lost.damping = in_extra;
    for (const RowSpan& span : m.rows) {
        const auto run = [&](int part, std::ptrdiff_t begin, std::ptrdiff_t end) {
            RowForces rows(m.lattice, motion, leaps ? &m.old_rows : nullptr, m.kernel, m.forces,
                           part);
            if (anew) rows.start(span.begin + static_cast<Index>(begin));
            for (auto row = span.begin + begin; row < span.begin + end; ++row) {
                if (anew) rows.next(static_cast<Index>(row));
                const LostPower power = finish({row * columns, columns}, rows.force(), part);
                if (leaps) {
                    m.old_rows.keep(static_cast<Index>(row), motion);
                    m.forces.row_damping[static_cast<std::size_t>(row)] = power.damping;
                }
                m.forces.row_drag[static_cast<std::size_t>(row)] = power.drag;
            }
        };
        m.pool.for_parts(span.end - span.begin, kKinds * columns, run);
    }
    for (const double power : m.forces.row_damping)
        lost.damping += power;
    for (const double power : m.forces.row_drag)
        lost.drag += power;
    if (!m.rows.empty() && m.node_count() > static_cast<std::size_t>(m.lattice.site_count()))
        finish_copies(m, finish, lost);
    return lost;
}

}  // namespace

LostPower accelerate(const Mechanics& m, const double* x, const double* v, double* a) {
    return evaluate(m, {x, v, m.node_count()}, Finish(m, v, a), false);
}

void prepare_leaps(const Mechanics& m, const double* x, const double* u) {
    std::vector<Index>& splits = m.old_rows.splits;
    splits.clear();
    for (const RowSpan& span : m.rows) {
        const Index rows = span.end - span.begin;
        const int parts = m.pool.parts(rows, kKinds * m.lattice.column_count);
        for (int part = 0; part < parts; ++part) {
            const auto begin = static_cast<Index>(ThreadPool::begin_of(part, parts, rows));
            if (span.begin + begin > 0 || m.lattice.closed) splits.push_back(span.begin + begin);
        }
        // the last row's vectors end in the first row of the next component, another part's
        const bool whole = span.begin == 0 && span.end == m.lattice.row_count;
        if (whole && parts > 1 && !m.lattice.closed) splits.push_back(span.end);
    }
    m.old_rows.prepare(m.lattice, {x, u, m.node_count()});
}

LostPower leap(const Mechanics& m, const Leap& step) {
    const LostPower lost = evaluate(m, {step.x, step.u, m.node_count()}, Finish(m, step), true);
    m.old_rows.turn();
    return lost;
}

}  // namespace ember
