// Explicit Runge-Kutta methods, with fixed steps or with error control.
#include <algorithm>
#include <cmath>

#include "sim/integrators/schemes.h"
#include "sim/math.h"

namespace ember {
namespace {

std::size_t fill_terms(const StageRow& factors, double scale, const IntegratorScratch& s,
                       std::size_t stages, std::array<Term, kMostStages + 1>& terms,
                       std::size_t first) {
    for (std::size_t j = 0; j < stages; ++j)
        terms[first + j] = {scale * factors[j], s.accelerations[j].data()};
    return first + stages;
}

// stage = present + h·share (v, 0) + h² Σ double_sum a + h Σ sum a, see tableau.h
void move_to(const StageRow& sum, const StageRow& double_sum, double share, std::size_t stages,
             double h, std::size_t count, IntegratorScratch& s, ThreadPool& pool) {
    std::array<Term, kMostStages + 1> terms{};
    terms[0] = {share * h, s.present.v.data()};
    std::size_t size = fill_terms(double_sum, h * h, s, stages, terms, 1);
    combine(s.stage.x.data(), s.present.x.data(), {terms.data(), size}, count, pool);
    size = fill_terms(sum, h, s, stages, terms, 0);
    combine(s.stage.v.data(), s.present.v.data(), {terms.data(), size}, count, pool);
}

// RMS error of the positions, and of the velocities over the step [m].
double estimate_error(const Tableau& t, double h, std::size_t count, IntegratorScratch& s,
                      ThreadPool& pool) {
    std::array<Term, kMostStages + 1> terms{};
    std::size_t size = fill_terms(t.error_a, h * h, s, t.stages, terms, 0);
    combine(s.error.data(), s.zeros.data(), {terms.data(), size}, count, pool);
    const double in_position = root_mean_square(s.error.data(), count);
    size = fill_terms(t.error, h * h, s, t.stages, terms, 0);
    combine(s.error.data(), s.zeros.data(), {terms.data(), size}, count, pool);
    return std::max(in_position, root_mean_square(s.error.data(), count));
}

// Factor for the next step after one with the given error.
double step_change(double error, double tolerance, int order) {
    constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 4.0;
    if (!(error > 0)) return error == 0 ? kMost : kLeast;
    return std::clamp(kSafety * ember::pow(tolerance / error, 1.0 / order), kLeast, kMost);
}

}  // namespace

TickWork runge_kutta_step(const Tableau& t, const Mechanics& m, double h, const LostPower& first,
                          LostPower& last, IntegratorScratch& s, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    TickWork work;
    last = first;
    for (std::size_t i = 0; i < t.stages; ++i) {
        if (i > 0) {
            move_to(t.a[i], t.aa[i], t.c[i], i, h, count, s, m.pool);
            last = accelerate(m, s.stage.x.data(), s.stage.v.data(), s.accelerations[i].data());
            ++counters.right_hand_sides;
        }
        work.damping += h * t.b[i] * last.damping;
        work.drag += h * t.b[i] * last.drag;
    }
    if (!t.first_same_as_last) move_to(t.b, t.ba, 1.0, t.stages, h, count, s, m.pool);
    return work;
}

void runge_kutta(const Tableau& t, const Mechanics& m, const StepControl& control,
                 IntegratorScratch& s, TickWork& work, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    const double longest = control.dt / static_cast<double>(control.substeps);
    const bool controlled = t.error_order > 0 && std::isfinite(control.tolerance);
    double h = controlled ? std::min(longest, control.first_step) : longest, gone = 0.0;
    LostPower first;
    bool known = false;
    for (std::int64_t step = 0; controlled ? gone < control.dt : step < control.substeps; ++step) {
        if (!known) {
            first =
                accelerate(m, s.present.x.data(), s.present.v.data(), s.accelerations[0].data());
            ++counters.right_hand_sides;
        }
        const bool to_the_end = controlled && gone + h * (1.0 + 1e-12) >= control.dt;
        if (to_the_end) h = control.dt - gone;
        LostPower last;
        const TickWork lost = runge_kutta_step(t, m, h, first, last, s, counters);
        double change = 1.0;
        if (controlled) {
            const double error = estimate_error(t, h, count, s, m.pool);
            change = step_change(error, control.tolerance, t.error_order);
            if (!(error <= control.tolerance)) {
                ++counters.substeps_rejected;
                known = true;  // the start has not moved
                h *= std::min(change, 0.9);
                if (h > 1e-9 * control.dt) continue;
                work.failure = "no sub-step meets numerics.tolerance";
                return;
            }
        }
        work.damping += lost.damping;
        work.drag += lost.drag;
        ++work.substeps;
        gone = to_the_end ? control.dt : gone + h;
        h = std::min(h * change, longest);
        std::swap(s.present, s.stage);
        known = t.first_same_as_last;
        if (!known) continue;
        std::swap(s.accelerations[0], s.accelerations[t.stages - 1]);
        first = last;
    }
}

}  // namespace ember
