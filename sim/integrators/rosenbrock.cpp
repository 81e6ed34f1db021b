// ROS2, a linearly implicit method of order 2 for any approximation of the Jacobian
// (Verwer, Spee, Blom and Hundsdorfer 1999), with γ = 1 - 1/√2, for which it is L-stable:
//
//     (I - γhJ) k1 = F(y),   (I - γhJ) k2 = F(y + h k1) - 2 k1,   y' = y + h (3 k1 + k2)/2
//
// With y = (x, v) the positions are eliminated, and what is left for the velocity parts is
// symmetric and positive definite: (M + γh D + γ²h² K) k_v = M r_v - γh K r_x, k_x = r_x + γh k_v.
//
// The velocities of the method of order 1 within it, y + h k1, differ by h (k1 + k2)/2 from those
// of the step. Times h, that is of order h³, nothing in free fall, and what error control goes by.
#include <algorithm>
#include <cmath>

#include "sim/integrators/schemes.h"
#include "sim/math.h"

namespace ember {
namespace {

constexpr double kGamma = 0.29289321881345254;  // 1 - 1/√2

// What a step has to do with.
struct Rosenbrock {
    const Mechanics& m;
    IntegratorScratch& s;
    StepCounters& counters;
    double solver_error = 0;  // [m] of a step, 0: as small as the solver goes

    [[nodiscard]] std::size_t count() const { return 3 * m.node_count(); }
    [[nodiscard]] std::vector<double>& stage(std::size_t i) const { return s.velocities[i]; }

    // Solves (I - γhJ) k = r; r is (x, v). kv holds the guess. Returns false when it cannot.
    bool solve(double h, const double* rx, const double* rv, std::vector<double>& kx,
               std::vector<double>& kv) {
        s.system.right_side(m, rx, rv);
        const int iterations = s.system.solve(m, solver_error / (h * h), kv.data());
        counters.solver_iterations += std::abs(iterations);
        if (iterations < 0) return false;
        combine(kx.data(), rx, {{kGamma * h, kv.data()}}, count(), m.pool);
        return true;
    }

    // One step from s.present into s.stage; false when the system has no solution.
    bool step(double h) {
        std::vector<double>&k1x = stage(0), &k1v = stage(1), &k2x = stage(2), &k2v = stage(3);
        std::vector<double>& a = s.accelerations[0];
        const Motion& y = s.present;
        const std::size_t n = count();
        (void)accelerate(m, y.x.data(), y.v.data(), a.data());
        s.system.assemble(m, y.x.data(), kGamma * h);
        if (!solve(h, y.v.data(), a.data(), k1x, k1v)) return false;
        combine(s.stage.x.data(), y.x.data(), {{h, k1x.data()}}, n, m.pool);
        combine(s.stage.v.data(), y.v.data(), {{h, k1v.data()}}, n, m.pool);
        (void)accelerate(m, s.stage.x.data(), s.stage.v.data(), a.data());
        combine(a.data(), a.data(), {{-2.0, k1v.data()}}, n, m.pool);
        combine(s.stage.v.data(), s.stage.v.data(), {{-2.0, k1x.data()}}, n, m.pool);
        if (!solve(h, s.stage.v.data(), a.data(), k2x, k2v)) return false;
        combine(s.stage.x.data(), y.x.data(), {{1.5 * h, k1x.data()}, {0.5 * h, k2x.data()}}, n,
                m.pool);
        combine(s.stage.v.data(), y.v.data(), {{1.5 * h, k1v.data()}, {0.5 * h, k2v.data()}}, n,
                m.pool);
        counters.right_hand_sides += 2;
        return true;
    }

    [[nodiscard]] double error(double h) const {
        const double factor = 0.5 * h * h;
        combine(s.error.data(), s.zeros.data(),
                {{factor, stage(1).data()}, {factor, stage(3).data()}}, count(), m.pool);
        return root_mean_square(s.error.data(), count());
    }

    // Makes the stage the present. What was lost follows from the motion half way: the stages of a
    // stiff step are not near it.
    void accept(double h, TickWork& work) {
        std::swap(s.present, s.stage);  // stage is now the start
        const std::size_t n = count();
        for (std::vector<double> Motion::*part : {&Motion::x, &Motion::v}) {
            std::vector<double>& middle = s.stage.*part;
            combine(middle.data(), s.zeros.data(),
                    {{0.5, middle.data()}, {0.5, (s.present.*part).data()}}, n, m.pool);
        }
        const LostPower power =
            accelerate(m, s.stage.x.data(), s.stage.v.data(), s.accelerations[0].data());
        work.damping += h * power.damping;
        work.drag += h * power.drag;
        ++work.substeps;
        ++counters.right_hand_sides;
    }
};

}  // namespace

void rosenbrock(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                TickWork& work, StepCounters& counters) {
    constexpr double kSolver = 0.1;  // of the tolerance is left to the solver
    const double longest = control.dt / static_cast<double>(control.substeps);
    const bool controlled = std::isfinite(control.tolerance);
    Rosenbrock method{m, s, counters, controlled ? kSolver * control.tolerance : 0.0};
    s.velocities.resize(std::max<std::size_t>(s.velocities.size(), 4));
    for (std::vector<double>& array : s.velocities)
        array.assign(method.count() + kMotionPadding, 0.0);
    s.system.begin(m);
    double h = longest, gone = 0.0;
    while (controlled ? gone < control.dt : work.substeps < control.substeps) {
        const bool to_the_end = controlled && gone + h * (1.0 + 1e-12) >= control.dt;
        if (to_the_end) h = control.dt - gone;
        double change = 1.0;
        const bool solved = method.step(h);
        if (controlled) {
            constexpr double kSafety = 0.9, kLeast = 0.2, kMost = 2.0;
            const double error = solved ? method.error(h) : control.tolerance * 1e3;
            const double ratio = control.tolerance / std::max(error, 1e-3 * control.tolerance);
            change = std::isfinite(ratio)
                         ? std::clamp(kSafety * ember::pow(ratio, 1.0 / 3.0), kLeast, kMost)
                         : kLeast;
            if (!(error <= control.tolerance)) {
                ++counters.substeps_rejected;
                h *= std::min(change, 0.9);
                if (h > 1e-9 * control.dt) continue;
                work.failure = "no sub-step meets numerics.tolerance";
                return;
            }
        } else if (!solved) {
            work.failure = "the linear system of the rosenbrock step has no solution";
            return;
        }
        method.accept(h, work);
        gone = to_the_end ? control.dt : gone + h;
        h = std::min(h * change, longest);
    }
}

}  // namespace ember
