// Semi-implicit Euler and velocity Verlet: one right-hand side per step, and without damping no
// drift of the energy.
#include <algorithm>

#include "sim/integrators/schemes.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// With w_n the drift from x_n to x_n+1, both methods conserve ½ Σ m w_n-1·w_n + U of linear forces
// but for what the friction takes, which is exactly Σ_n h/2 w_n·(f_n + f_n+1).
void lose(const LostPower& power, double damping, double drag, TickWork& work) {
    work.damping += damping * power.damping;
    work.drag += drag * power.drag;
}

// w += kick a, x += h w, ahead = w + h/2 a, in one pass over the arrays.
EMBER_VECTORISED void kick_and_drift(std::ptrdiff_t begin, std::ptrdiff_t end, double kick,
                                     double h, const double* __restrict a, double* __restrict w,
                                     double* __restrict x, double* __restrict ahead) {
    for (std::ptrdiff_t i = begin; i < end; ++i) {
        const double next = w[i] + kick * a[i];
        w[i] = next;
        x[i] += h * next;
        ahead[i] = next + 0.5 * h * a[i];
    }
}

// Σ m p·q over the nodes that move.
double sum_with_mass(const NodeLoads& loads, const std::vector<double>& p,
                     const std::vector<double>& q) {
    const std::size_t n = loads.inverse_mass.size();
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        const double inverse = loads.inverse_mass[i];
        const double dot = p[i] * q[i] + p[n + i] * q[n + i] + p[2 * n + i] * q[2 * n + i];
        sum += inverse > 0 ? dot / inverse : 0.0;
    }
    return sum;
}

}  // namespace

void semi_implicit_euler(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                         TickWork& work, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    const double h = control.dt / static_cast<double>(control.substeps);
    std::vector<double>& a = s.accelerations[0];
    Motion& y = s.present;
    const double* w = y.v.data();
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        const bool first = step == 0;  // there is no drift behind it, and a whole one ahead
        const Drift drift{w, first ? 2.0 * h : h};
        lose(accelerate(m, y.x.data(), w, a.data(), drift), first ? 0.0 : h, first ? 0.5 * h : h,
             work);
        if (first) work.scheme += 0.5 * h * sum_with_mass(m.loads, y.v, a);
        combine(y.v.data(), w, {{h, a.data()}}, count, m.pool);
        combine(y.x.data(), y.x.data(), {{h, w}}, count, m.pool);
    }
    lose(accelerate(m, y.x.data(), w, a.data(), {w, 0.0}), h, 0.5 * h, work);
    work.scheme -= 0.5 * h * sum_with_mass(m.loads, y.v, a);
    counters.right_hand_sides += control.substeps + 1;
    work.substeps = control.substeps;
}

// v½ = v + h/2 a, x' = x + h v½, a' = a(x', v½ + h/2 a), v' = v½ + h/2 a'. The damping is taken at
// an extrapolated velocity, an error of order h² like the others.
void velocity_verlet(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                     TickWork& work, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    const double h = control.dt / static_cast<double>(control.substeps);
    std::vector<double>& a = s.accelerations[0];
    Motion& y = s.present;                   // x, and v½
    std::vector<double>& ahead = s.stage.v;  // v½ + h/2 a
    const double* w = y.v.data();
    lose(accelerate(m, y.x.data(), w, a.data(), {w, h}), 0.0, 0.5 * h, work);
    work.scheme -= 0.125 * h * h * sum_with_mass(m.loads, a, a);
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        const double kick = step == 0 ? 0.5 * h : h;  // the end of the last step and this one's
        const bool last = step + 1 == control.substeps;
        const auto lines = static_cast<std::ptrdiff_t>((count + 7) / 8);
        m.pool.for_rows(lines, 2, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            kick_and_drift(8 * begin, std::min(8 * end, static_cast<std::ptrdiff_t>(count)), kick,
                           h, a.data(), y.v.data(), y.x.data(), ahead.data());
        });
        lose(accelerate(m, y.x.data(), ahead.data(), a.data(), {w, last ? 0.0 : h}), h,
             last ? 0.5 * h : h, work);
    }
    combine(y.v.data(), y.v.data(), {{0.5 * h, a.data()}}, count, m.pool);
    work.scheme += 0.125 * h * h * sum_with_mass(m.loads, a, a);
    counters.right_hand_sides += control.substeps + 1;
    work.substeps = control.substeps;
}

}  // namespace ember
