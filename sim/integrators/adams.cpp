// Adams-Bashforth-Moulton for second-order equations: the positions come from the accelerations of
// the past, integrated twice, so that no velocities need to be remembered.
#include <algorithm>
#include <array>

#include "sim/integrators/schemes.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr std::size_t kPast = kAdamsPast;
using PastWeights = std::array<double, kPast>;  // of the present and past values, latest first

// With ∇ the backward difference, integrating the polynomial through the past a once and twice
// over a step gives v' = v + h Σ once[j] ∇^j a and x' = x + h v + h² Σ twice[j] ∇^j a. For
// u = -log(1 - t) = Σ t^n / n the generating functions are t / ((1 - t) u) and (once - 1) / u;
// comparing coefficients yields both (Hairer, Norsett, Wanner 1993, III.1 and III.10).
struct DifferenceWeights {
    std::array<double, kPast + 2> once{};
    std::array<double, kPast + 1> twice{};
};

constexpr DifferenceWeights difference_weights() {
    DifferenceWeights w;
    for (std::size_t j = 0; j < w.once.size(); ++j) {
        w.once[j] = 1.0;
        for (std::size_t i = 0; i < j; ++i)
            w.once[j] -= w.once[i] / static_cast<double>(j + 1 - i);
    }
    for (std::size_t j = 0; j < w.twice.size(); ++j) {
        w.twice[j] = w.once[j + 1];
        for (std::size_t i = 0; i < j; ++i)
            w.twice[j] -= w.twice[i] / static_cast<double>(j + 1 - i);
    }
    return w;
}

constexpr double binomial(std::size_t n, std::size_t k) {
    double value = 1.0;
    for (std::size_t i = 0; i < k; ++i)
        value = value * static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

// Weights of the values instead of their differences.
template <std::size_t Count>
constexpr PastWeights of_values(const std::array<double, Count>& differences) {
    PastWeights w{};
    for (std::size_t j = 0; j < kPast; ++j) {
        for (std::size_t i = j; i < kPast; ++i)
            w[j] += (j % 2 == 0 ? 1.0 : -1.0) * binomial(i, j) * differences[i];
    }
    return w;
}

// The next value of the polynomial through the past ones.
constexpr PastWeights extrapolation() {
    PastWeights w{};
    for (std::size_t j = 0; j < kPast; ++j)
        w[j] = (j % 2 == 0 ? 1.0 : -1.0) * binomial(kPast, j + 1);
    return w;
}

constexpr DifferenceWeights kDifferences = difference_weights();
constexpr PastWeights kOnce = of_values(kDifferences.once), kTwice = of_values(kDifferences.twice);
constexpr PastWeights kAhead = extrapolation();
// of what the next value is more than its extrapolation, which is its last difference
constexpr double kMoreOnce = kDifferences.once[kPast], kMoreTwice = kDifferences.twice[kPast];

double sum(const PastWeights& weights, const std::array<double, kPast>& values) {
    double total = 0.0;
    for (std::size_t j = 0; j < kPast; ++j)
        total += weights[j] * values[j];
    return total;
}

using Past = std::array<const double*, kPast>;

// Predicted x, v and a, in one sweep over the past.
EMBER_VECTORISED void predict(const double* x, const double* v, const Past& past, double h,
                              double* __restrict next_x, double* __restrict next_v,
                              double* __restrict next_a, std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t i = begin; i < end; ++i) {
        double once = 0.0, twice = 0.0, ahead = 0.0;
#pragma GCC unroll 16
        for (std::size_t j = 0; j < kPast; ++j) {
            const double a = past[j][i];
            once += kOnce[j] * a;
            twice += kTwice[j] * a;
            ahead += kAhead[j] * a;
        }
        next_x[i] = x[i] + h * (v[i] + h * twice);
        next_v[i] = v[i] + h * once;
        next_a[i] = ahead;
    }
}

EMBER_VECTORISED void correct(const double* next_x, const double* next_v, const double* ahead,
                              const double* a, double h, double* __restrict x, double* __restrict v,
                              std::ptrdiff_t begin, std::ptrdiff_t end) {
    for (std::ptrdiff_t i = begin; i < end; ++i) {
        const double more = h * (a[i] - ahead[i]);
        x[i] = next_x[i] + h * kMoreTwice * more;
        v[i] = next_v[i] + kMoreOnce * more;
    }
}

class Adams {
  public:
    Adams(const Mechanics& m, IntegratorScratch& s, TickWork& work, StepCounters& counters)
        : m_(m), s_(s), work_(work), counters_(counters), count_(3 * m.node_count()) {
        for (std::size_t i = 0; i <= kPast; ++i)
            rates_[i] = {s.accelerations[kMostStages + i].data(), {}};
    }

    // Makes the rate at the present motion the latest.
    void remember() {
        Rate& next = rates_.back();
        next.power = evaluate(s_.present, next.a);
        advance_history();
    }

    void start(double h) {
        LostPower last;
        std::copy_n(rates_[0].a, count_, s_.accelerations[0].data());
        const TickWork lost =
            runge_kutta_step(kButcher6, m_, h, rates_[0].power, last, s_, counters_);
        work_.damping += lost.damping;
        work_.drag += lost.drag;
        std::swap(s_.present, s_.stage);
        remember();
    }

    void step(double h) {
        Rate& next = rates_.back();
        Past past{};
        for (std::size_t j = 0; j < kPast; ++j)
            past[j] = rates_[j].a;
        Motion &now = s_.present, &then = s_.stage;
        double* ahead = s_.error.data();
        for_lines(kPast, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            predict(now.x.data(), now.v.data(), past, h, then.x.data(), then.v.data(), ahead, begin,
                    end);
        });
        next.power = evaluate(then, next.a);
        for_lines(2, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            correct(then.x.data(), then.v.data(), ahead, next.a, h, now.x.data(), now.v.data(),
                    begin, end);
        });
        next.power = evaluate(now, next.a);
        lose(h);
        advance_history();
    }

  private:
    // The rate of change of the motion at one time.
    struct Rate {
        double* a;
        LostPower power;
    };

    LostPower evaluate(const Motion& at, double* a) {
        ++counters_.right_hand_sides;
        return accelerate(m_, at.x.data(), at.v.data(), a);
    }

    // Whole cache lines to each thread; `work` springs' worth each.
    template <class Body>
    void for_lines(std::ptrdiff_t work, Body&& body) {
        const auto count = static_cast<std::ptrdiff_t>(count_);
        m_.pool.for_rows((count + 7) / 8, work, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            body(8 * begin, std::min(8 * end, count));
        });
    }

    void lose(double h) {
        const auto lost = [&](double LostPower::*power) {
            std::array<double, kPast> past{};
            for (std::size_t j = 0; j < kPast; ++j)
                past[j] = rates_[j].power.*power;
            const double more = rates_.back().power.*power - sum(kAhead, past);
            return h * (sum(kOnce, past) + kMoreOnce * more);
        };
        work_.damping += lost(&LostPower::damping);
        work_.drag += lost(&LostPower::drag);
    }

    // The last one becomes the first, and the oldest gives its array to the next.
    void advance_history() { std::rotate(rates_.begin(), rates_.end() - 1, rates_.end()); }

    const Mechanics& m_;
    IntegratorScratch& s_;
    TickWork& work_;
    StepCounters& counters_;
    std::size_t count_;
    std::array<Rate, kPast + 1> rates_{};  // latest first; the last is scratch for the next
};

}  // namespace

void adams_bashforth_moulton(const Mechanics& m, const StepControl& control, IntegratorScratch& s,
                             TickWork& work, StepCounters& counters) {
    const double h = control.dt / static_cast<double>(control.substeps);
    Adams adams(m, s, work, counters);
    adams.remember();
    for (std::int64_t step = 0; step < control.substeps; ++step) {
        if (step + 1 < static_cast<std::int64_t>(kPast)) {
            adams.start(h);
        } else {
            adams.step(h);
        }
    }
    work.substeps = control.substeps;
}

}  // namespace ember
