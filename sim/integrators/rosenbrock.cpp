// ROS2, a linearly implicit method of order 2 for any approximation of the Jacobian
// (Verwer, Spee, Blom and Hundsdorfer 1999), with γ = 1 - 1/√2, for which it is L-stable:
//
//     (I - γhJ) k1 = F(y),   (I - γhJ) k2 = F(y + h k1) - 2 k1,   y' = y + h (3 k1 + k2)/2
//
// With y = (x, v) the positions are eliminated, and what is left for the velocity parts is
// symmetric and positive definite: (M + γh D + γ²h² K) k_v = M r_v - γh K r_x, k_x = r_x + γh k_v.
#include <cmath>

#include "sim/integrators/linear_system.h"
#include "sim/integrators/schemes.h"

namespace ember {
namespace {

constexpr double kGamma = 0.29289321881345254;  // 1 - 1/√2

struct Rate {
    std::vector<double>&x, &v;
};

// Solves (I - γhJ) k = r; r is (x, v). k.v holds the guess. Returns false when it cannot.
bool solve(const Mechanics& m, double h, const double* rx, const double* rv, Rate k,
           LinearSystem& system, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    system.right_side(rx, rv, kGamma * h);
    const int iterations = system.solve(k.v.data());
    counters.solver_iterations += std::abs(iterations);
    if (iterations < 0) return false;
    combine(k.x.data(), rx, {{kGamma * h, k.v.data()}}, count, m.pool);
    return true;
}

}  // namespace

void rosenbrock(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                TickWork& work, StepCounters& counters) {
    const std::size_t count = 3 * m.node_count();
    const double h = control.dt / static_cast<double>(control.substeps);
    s.velocities.resize(4);
    for (std::vector<double>& array : s.velocities)
        array.assign(count, 0.0);
    const Rate k1{s.velocities[0], s.velocities[1]}, k2{s.velocities[2], s.velocities[3]};
    std::vector<double>& a = s.accelerations[0];
    LinearSystem system(m);
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        Motion& y = s.present;
        (void)accelerate(m, y.x.data(), y.v.data(), a.data());
        system.assemble(y.x.data(), kGamma * h);
        bool good = solve(m, h, y.v.data(), a.data(), k1, system, counters);
        combine(s.stage.x.data(), y.x.data(), {{h, k1.x.data()}}, count, m.pool);
        combine(s.stage.v.data(), y.v.data(), {{h, k1.v.data()}}, count, m.pool);
        (void)accelerate(m, s.stage.x.data(), s.stage.v.data(), a.data());
        combine(a.data(), a.data(), {{-2.0, k1.v.data()}}, count, m.pool);
        combine(s.stage.v.data(), s.stage.v.data(), {{-2.0, k1.x.data()}}, count, m.pool);
        good = good && solve(m, h, s.stage.v.data(), a.data(), k2, system, counters);
        if (!good) {
            work.failure = "the linear system of the rosenbrock step has no solution";
            return;
        }
        const auto finish = [&](std::vector<double>& to, const std::vector<double>& from,
                                const std::vector<double>& first,
                                const std::vector<double>& second) {
            combine(to.data(), from.data(), {{1.5 * h, first.data()}, {0.5 * h, second.data()}},
                    count, m.pool);
        };
        finish(s.stage.x, y.x, k1.x, k2.x);
        finish(s.stage.v, y.v, k1.v, k2.v);
        // what was lost, from the motion half way: the stages of a stiff step are not near it
        std::swap(s.present, s.stage);  // stage is now the start
        combine(s.stage.x.data(), s.stage.x.data(), {{1.0, s.present.x.data()}}, count, m.pool);
        combine(s.stage.v.data(), s.stage.v.data(), {{1.0, s.present.v.data()}}, count, m.pool);
        combine(s.stage.x.data(), s.zeros.data(), {{0.5, s.stage.x.data()}}, count, m.pool);
        combine(s.stage.v.data(), s.zeros.data(), {{0.5, s.stage.v.data()}}, count, m.pool);
        const LostPower power = accelerate(m, s.stage.x.data(), s.stage.v.data(), a.data());
        work.damping += h * power.damping;
        work.drag += h * power.drag;
    }
    counters.right_hand_sides += 3 * control.substeps;
    work.substeps = control.substeps;
}

}  // namespace ember
