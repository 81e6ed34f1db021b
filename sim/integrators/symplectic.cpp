// Semi-implicit Euler and velocity Verlet: one right-hand side per step, and without damping no
// drift of the energy.
#include <algorithm>
#include <array>

#include "sim/integrators/schemes.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// With w_n the drift from x_n to x_n+1, both methods conserve ½ Σ m w_n-1·w_n + U of linear forces
// but for what the friction takes, which is exactly Σ_n h/2 w_n·(f_n + f_n+1).
void lose(const LostPower& power, double duration, TickWork& work) {
    work.damping += duration * power.damping;
    work.drag += duration * power.drag;
}

// Σ m p·(q - p) and Σ m (q - p)·(q - p) [J].
struct Change {
    double along = 0, square = 0;
};

EMBER_VECTORISED void change_terms(std::ptrdiff_t count, const double* __restrict mass,
                                   const double* __restrict p, const double* __restrict q,
                                   double* __restrict along, double* __restrict square) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double d = q[i] - p[i];
        along[i] = mass[i] * p[i] * d;
        square[i] = mass[i] * d * d;
    }
}

Change change_of(const SheetState& sheet, const std::vector<double>& p,
                 const std::vector<double>& q) {
    constexpr std::ptrdiff_t kBlock = 64;
    std::array<double, kBlock> along{}, square{};
    const auto n = static_cast<std::ptrdiff_t>(sheet.mass.size());
    Change sum;
    for (std::ptrdiff_t axis = 0; axis < 3; ++axis) {
        for (std::ptrdiff_t first = 0; first < n; first += kBlock) {
            const std::ptrdiff_t count = std::min(kBlock, n - first), at = axis * n + first;
            change_terms(count, sheet.mass.data() + first, p.data() + at, q.data() + at,
                         along.data(), square.data());
            sum.along += sum_in_lanes(along.data(), count);
            sum.square += sum_in_lanes(square.data(), count);
        }
    }
    return sum;
}

// Leaps of the present motion, with a guess `ahead` at the velocity that friction is taken at.
class Leapfrog {
  public:
    Leapfrog(const Mechanics& mechanics, const StepControl& control, IntegratorScratch& scratch)
        : m_(mechanics), control_(control), s_(scratch) {
        s_.ahead = s_.present.v;
        if (control.pauses) s_.kept.resize(6 * m_.node_count());
        prepare_leaps(m_, s_.present.x.data(), s_.ahead.data());
    }

    LostPower operator()(double kick, double drift, double lead, double mean,
                         ForceSource source = ForceSource::Motion) {
        return leap(m_, {s_.present.x.data(), s_.present.v.data(), s_.ahead.data(), kick, drift,
                         lead, mean, source, s_.kept.data()});
    }

    /// The first one, and what it changes in the velocities.
    LostPower first(double kick, double drift, double lead, double mean, Change& change) {
        return watched(kick, drift, lead, mean,
                       control_.resumes ? ForceSource::Kept : ForceSource::Motion, change);
    }

    /// The last one: a kick only.
    LostPower last(double kick, Change& change) {
        return watched(kick, 0.0, 0.0, 0.0,
                       control_.pauses ? ForceSource::MotionAndKeep : ForceSource::Motion, change);
    }

    /// How many times the forces are evaluated in all.
    [[nodiscard]] std::int64_t evaluations() const {
        return control_.substeps + (control_.resumes ? 0 : 1);
    }

  private:
    LostPower watched(double kick, double drift, double lead, double mean, ForceSource source,
                      Change& change) {
        s_.start.v = s_.present.v;
        const LostPower lost = (*this)(kick, drift, lead, mean, source);
        change = change_of(m_.sheet, s_.start.v, s_.present.v);
        return lost;
    }

    const Mechanics& m_;
    const StepControl& control_;
    IntegratorScratch& s_;
};

}  // namespace

void semi_implicit_euler(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                         TickWork& work, StepCounters& counters) {
    const double h = control.dt / static_cast<double>(control.substeps);
    Leapfrog leap(m, control, s);
    Change change;
    // there is no drift behind the first, and a whole one ahead
    lose(leap.first(h, h, 0.0, h, change), 0.5 * h, work);
    work.scheme += 0.5 * change.along;
    for (std::int64_t step = 1; step < control.substeps; ++step)
        lose(leap(h, h, 0.0, 0.5 * h), h, work);
    // what the last drift lost, and what the scheme holds, show in one kick more, which is undone
    lose(leap.last(h, change), 0.5 * h, work);
    work.scheme -= 0.5 * change.along;
    s.present.v = s.start.v;
    counters.right_hand_sides += leap.evaluations();
    work.substeps = control.substeps;
}

// v½ = v + h/2 a, x' = x + h v½, a' = a(x', v½ + h/2 a), v' = v½ + h/2 a'. The damping is taken at
// an extrapolated velocity, an error of order h² like the others.
void velocity_verlet(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                     TickWork& work, StepCounters& counters) {
    const double h = control.dt / static_cast<double>(control.substeps);
    Leapfrog leap(m, control, s);
    Change change;
    lose(leap.first(0.5 * h, h, 0.5 * h, 0.5 * h, change), 0.5 * h, work);
    work.scheme -= 0.5 * change.square;
    for (std::int64_t step = 1; step < control.substeps; ++step)
        lose(leap(h, h, 0.5 * h, 0.5 * h), h, work);  // the end of one step and the next
    lose(leap.last(0.5 * h, change), 0.5 * h, work);
    work.scheme += 0.5 * change.square;
    counters.right_hand_sides += leap.evaluations();
    work.substeps = control.substeps;
}

}  // namespace ember
