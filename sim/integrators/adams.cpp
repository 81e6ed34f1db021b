// Adams-Bashforth-Moulton of order 6: predicts from the past, corrects with the prediction.
#include <algorithm>
#include <array>

#include "sim/integrators/schemes.h"

namespace ember {
namespace {

constexpr std::size_t kOrder = 6;
using Weights = std::array<double, kOrder>;
// weights of the present and past rates, latest first ...
constexpr Weights kBashforth = {4277.0 / 1440,  -7923.0 / 1440, 9982.0 / 1440,
                                -7298.0 / 1440, 2877.0 / 1440,  -475.0 / 1440};
// ... and of the next rate before them
constexpr Weights kMoulton = {475.0 / 1440, 1427.0 / 1440, -798.0 / 1440,
                              482.0 / 1440, -173.0 / 1440, 27.0 / 1440};

// The rate of change of the motion at one time.
struct Rate {
    double *v, *a;
    LostPower power;
};

class Adams {
  public:
    Adams(const Mechanics& m, IntegratorScratch& s, TickWork& work, StepCounters& counters)
        : m_(m), s_(s), work_(work), counters_(counters), count_(3 * m.node_count()) {
        s.velocities.resize(rates_.size());
        for (std::size_t i = 0; i < rates_.size(); ++i) {
            s.velocities[i].resize(count_ + kMotionPadding);
            rates_[i] = {s.velocities[i].data(), s.accelerations[kMostStages + i].data(), {}};
        }
    }

    // Makes the rate at the present motion the latest.
    void remember() {
        Rate& next = rates_.back();
        std::copy_n(s_.present.v.data(), count_, next.v);
        next.power = evaluate(s_.present.x.data(), next.v, next.a);
        advance_history();
    }

    void start(double h) {
        LostPower last;
        std::copy_n(rates_[0].a, count_, s_.accelerations[0].data());
        const TickWork lost =
            runge_kutta_step(kDopri5, m_, h, rates_[0].power, last, s_, counters_);
        work_.damping += lost.damping;
        work_.drag += lost.drag;
        std::swap(s_.present, s_.stage);
        remember();
    }

    void step(double h) {
        Rate& next = rates_.back();
        sum(s_.stage.x.data(), s_.present.x.data(), kBashforth, 0, &Rate::v, h);
        sum(next.v, s_.present.v.data(), kBashforth, 0, &Rate::a, h);
        (void)evaluate(s_.stage.x.data(), next.v, next.a);
        // the velocity first: corrected, it is the better rate for the position
        sum(next.v, s_.present.v.data(), kMoulton, 1, &Rate::a, h, next.a);
        sum(s_.stage.x.data(), s_.present.x.data(), kMoulton, 1, &Rate::v, h, next.v);
        next.power = evaluate(s_.stage.x.data(), next.v, next.a);
        lose(h);
        std::swap(s_.present.x, s_.stage.x);
        std::copy_n(next.v, count_, s_.present.v.data());
        advance_history();
    }

  private:
    LostPower evaluate(const double* x, const double* v, double* a) {
        ++counters_.right_hand_sides;
        return accelerate(m_, x, v, a);
    }

    // out = base + h (weights[0] newest + Σ weights[first + j] rate_j)
    void sum(double* out, const double* base, const Weights& weights, std::size_t first,
             double* Rate::*field, double h, const double* newest = nullptr) {
        std::array<Term, kOrder> terms{};
        if (first == 1) terms[0] = {h * weights[0], newest};
        for (std::size_t j = first; j < kOrder; ++j)
            terms[j] = {h * weights[j], rates_[j - first].*field};
        combine(out, base, terms, count_, m_.pool);
    }

    void lose(double h) {
        const auto add = [&](double weight, const LostPower& power) {
            work_.damping += h * weight * power.damping;
            work_.drag += h * weight * power.drag;
        };
        add(kMoulton[0], rates_.back().power);
        for (std::size_t j = 1; j < kOrder; ++j)
            add(kMoulton[j], rates_[j - 1].power);
    }

    // The last one becomes the first, and the oldest gives its arrays to the next.
    void advance_history() {
        const Rate newest = rates_[kOrder];
        for (std::size_t i = kOrder; i > 0; --i)
            rates_[i] = rates_[i - 1];
        rates_[0] = newest;
    }

    const Mechanics& m_;
    IntegratorScratch& s_;
    TickWork& work_;
    StepCounters& counters_;
    std::size_t count_;
    std::array<Rate, kOrder + 1> rates_{};  // latest first; the last is scratch for the next
};

}  // namespace

void adams_bashforth_moulton(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                             TickWork& work, StepCounters& counters) {
    const double h = control.dt / static_cast<double>(control.substeps);
    Adams adams(m, s, work, counters);
    adams.remember();
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        if (step + 1 < static_cast<std::int64_t>(kOrder)) {
            adams.start(h);
        } else {
            adams.step(h);
        }
    }
    work.substeps = control.substeps;
}

}  // namespace ember
