// Semi-implicit Euler and velocity Verlet: one right-hand side per step, and without damping no
// drift of the energy.
#include "sim/integrators/schemes.h"

namespace ember {
namespace {

void lose(const LostPower& power, double h, TickWork& work) {
    work.damping += h * power.damping;
    work.drag += h * power.drag;
}

}  // namespace

// v' = v + h a(x, v), x' = x + h v'
void semi_implicit_euler(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                         TickWork& work, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    const double h = control.dt / static_cast<double>(control.substeps);
    std::vector<double>& a = s.accelerations[0];
    Motion& y = s.present;
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        lose(accelerate(m, y.x.data(), y.v.data(), a.data()), h, work);
        combine(y.v.data(), y.v.data(), {{h, a.data()}}, count, m.pool);
        combine(y.x.data(), y.x.data(), {{h, y.v.data()}}, count, m.pool);
    }
    counters.right_hand_sides += control.substeps;
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
    lose(accelerate(m, y.x.data(), y.v.data(), a.data()), 0.5 * h, work);
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        const double kick = step == 0 ? 0.5 * h : h;  // the end of the last step and this one's
        combine(y.v.data(), y.v.data(), {{kick, a.data()}}, count, m.pool);
        combine(y.x.data(), y.x.data(), {{h, y.v.data()}}, count, m.pool);
        combine(ahead.data(), y.v.data(), {{0.5 * h, a.data()}}, count, m.pool);
        const LostPower power = accelerate(m, y.x.data(), ahead.data(), a.data());
        lose(power, step + 1 == control.substeps ? 0.5 * h : h, work);
    }
    combine(y.v.data(), y.v.data(), {{0.5 * h, a.data()}}, count, m.pool);
    counters.right_hand_sides += control.substeps + 1;
    work.substeps = control.substeps;
}

}  // namespace ember
