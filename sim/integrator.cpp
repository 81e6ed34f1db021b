#include "sim/integrator.h"

#include "sim/integrators/schemes.h"

namespace ember {
namespace {

// Accelerations that are kept at once: stages, and past steps of the multistep method.
constexpr std::size_t kMostAccelerations = kMostStages + kAdamsPast + 1;

std::size_t accelerations_of(IntegratorKind integrator) {
    switch (integrator) {
        case IntegratorKind::SemiImplicitEuler:
        case IntegratorKind::VelocityVerlet:
            return 0;
        case IntegratorKind::Rosenbrock:
            return 1;
        case IntegratorKind::Auto:
        case IntegratorKind::Rk4:
            return 4;
        case IntegratorKind::Dopri5:
            return 7;
        case IntegratorKind::Rkf78:
            return kMostStages;
        case IntegratorKind::AdamsBashforthMoulton:
            return kMostAccelerations;
    }
    return 0;
}

void prepare(const Mechanics& m, const StepControl& control, IntegratorScratch& s) {
    const std::size_t n = m.node_count(), count = 3 * n;
    s.present.read(m.sheet);
    const std::size_t needed = accelerations_of(control.integrator);
    if (needed == 0) return;
    s.stage.resize(n);
    if (s.accelerations.size() < needed) s.accelerations.resize(needed);
    for (std::vector<double>& a : s.accelerations)
        a.assign(count, 0.0);  // rows that are not moved keep it
    s.error.resize(count);
    s.zeros.assign(count, 0.0);
}

void run(const Mechanics& m, const StepControl& control, IntegratorScratch& s, TickWork& work,
         StepCounters& counters) {
    switch (control.integrator) {
        case IntegratorKind::SemiImplicitEuler:
            return semi_implicit_euler(m, control, s, work, counters);
        case IntegratorKind::VelocityVerlet:
            return velocity_verlet(m, control, s, work, counters);
        case IntegratorKind::Auto:
        case IntegratorKind::Rk4:
            return runge_kutta(kRk4, m, control, s, work, counters);
        case IntegratorKind::Dopri5:
            return runge_kutta(kDopri5, m, control, s, work, counters);
        case IntegratorKind::Rkf78:
            return runge_kutta(kRkf78, m, control, s, work, counters);
        case IntegratorKind::AdamsBashforthMoulton:
            return adams_bashforth_moulton(m, control, s, work, counters);
        case IntegratorKind::Rosenbrock:
            return rosenbrock(m, control, s, work, counters);
    }
}

// Of a force [N] that does not change meanwhile; an empty one does no work.
double work_of(const Vector3Array& force, const SheetState& start, const Motion& end) {
    const std::size_t n = start.position.size();
    double work = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
        work += force.x[i] * (end.x[i] - start.position.x[i]) +
                force.y[i] * (end.x[n + i] - start.position.y[i]) +
                force.z[i] * (end.x[2 * n + i] - start.position.z[i]);
    }
    return work;
}

}  // namespace

TickWork integrate(const Mechanics& m, SheetState& sheet, const StepControl& control,
                   IntegratorScratch& scratch, StepCounters& counters) {
    TickWork work;
    const std::int64_t evaluated_before = counters.right_hand_sides;
    prepare(m, control, scratch);
    run(m, control, scratch, work, counters);
    work.fire = work_of(m.loads.fire, sheet, scratch.present);
    work.wind = work_of(m.loads.wind, sheet, scratch.present);
    work.contact = work_of(m.loads.contact, sheet, scratch.present);
    scratch.present.write(sheet);
    const auto springs =
        static_cast<std::int64_t>(m.network.weight.size() + m.network.extra.size());
    counters.spring_evaluations += springs * (counters.right_hand_sides - evaluated_before);
    counters.substeps += work.substeps;
    return work;
}

}  // namespace ember
