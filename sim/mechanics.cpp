#include "sim/mechanics.h"

#include <algorithm>
#include <array>

#include "sim/node_step.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

EMBER_VECTORISED void add_to(std::ptrdiff_t count, const double* __restrict added,
                             double* __restrict sum) {
    for (std::ptrdiff_t i = 0; i < count; ++i)
        sum[i] += added[i];
}

// What becomes of the forces on a run of nodes: accelerations, or a step.
class Finish {
  public:
    Finish(const Mechanics& mechanics, const double* v, double* a) : m_(mechanics), v_(v), a_(a) {}
    Finish(const Mechanics& mechanics, const Leap& step)
        : m_(mechanics), v_(step.u), step_(&step) {}

    // Springs in the stencil exert `f` on the run, as SpringRow::force; not when forces were kept.
    // Returns the power of the drag, and for a step that of the springs' friction too.
    LostPower operator()(const NodeRun& run, double* f, int thread) const {
        if (evaluates()) add_extra(run, f);
        double* scratch = m_.forces.finishing[static_cast<std::size_t>(thread)].data();
        if (step_ == nullptr) return accelerate(run, f, scratch);
        keep(run, f);
        return move(run, f, scratch);
    }

    [[nodiscard]] bool evaluates() const {
        return step_ == nullptr || step_->source != ForceSource::Kept;
    }

  private:
    [[nodiscard]] std::ptrdiff_t node_count() const {
        return static_cast<std::ptrdiff_t>(m_.node_count());
    }

    void keep(const NodeRun& run, double* f) const {
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

    void add_extra(const NodeRun& run, double* f) const {
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

    LostPower accelerate(const NodeRun& run, const double* f, double* power) const {
        const std::ptrdiff_t n = node_count(), pitch = m_.forces.pitch;
        const auto a = components(a_, n, run.first);
        if (!m_.loads.has_drag) {
            divide_by_mass(m_.loads, run, components(f, pitch, 0), a);
            return {};
        }
        divide_in_air(m_.loads, run, components(f, pitch, 0), components(v_, n, run.first), a,
                      power);
        return {0.0, sum_in_lanes(power, run.count)};
    }

    LostPower move(const NodeRun& run, const double* f, double* scratch) const {
        const std::ptrdiff_t n = node_count(), pitch = m_.forces.pitch;
        const auto forces = components(f, pitch, 0), friction = components(f + 3 * pitch, pitch, 0);
        if (m_.loads.has_drag) {
            double *dragged = scratch, *rubbed = scratch + pitch;
            leap_in_air(m_.loads, *step_, run, n, forces, friction, dragged, rubbed);
            return {sum_in_lanes(rubbed, run.count), sum_in_lanes(dragged, run.count)};
        }
        double* a = scratch + pitch;
        divide_by_mass(m_.loads, run, forces, components(a, pitch, 0));
        kick_and_drift(*step_, run, n, components<const double*>(a, pitch, 0), friction, scratch);
        return {sum_in_lanes(scratch, run.count), 0.0};
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
