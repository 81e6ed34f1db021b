// What the paper says about its figures, measured on the shipped presets with five seeds each. A
// claim must hold for at least four; the table shows medians and the range.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "app/bench/bench_run.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr std::size_t kSeeds = 5;
constexpr int kMustHold = 4;
constexpr double kNever = std::numeric_limits<double>::infinity();

// How much of all sheets, by sites.
struct Share {
    double ignited = 0, burnt = 0;
};

Share share_of(const World& world) {
    double ignited = 0, burnt = 0, sites = 0;
    for (const SheetState& sheet : world.state().sheets) {
        for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
            ignited += sheet.phase[n] == Phase::Unburnt ? 0 : 1;
            burnt += sheet.phase[n] == Phase::BurntOut ? 1 : 0;
        }
        sites += static_cast<double>(sheet.glue.size());
    }
    return {ignited / sites, burnt / sites};
}

// RMS distance of a sheet from its mean plane z = const [m].
double out_of_plane(const SheetState& sheet) {
    double sum = 0, square = 0;
    const auto sites = static_cast<double>(sheet.glue.size());
    for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
        sum += sheet.position.z[n];
        square += sheet.position.z[n] * sheet.position.z[n];
    }
    return std::sqrt(std::max(0.0, square / sites - sum * sum / (sites * sites)));
}

// Share of a sheet's initial mass in pieces that nothing holds any more.
double loose_share(const SheetState& sheet) {
    double loose = 0, all = 0;
    for (std::size_t n = 0; n < sheet.initial_mass.size(); ++n) {
        all += sheet.initial_mass[n];
        loose += sheet.piece_held[n] == 0 ? sheet.initial_mass[n] : 0.0;
    }
    return loose / all;
}

// One burn in numbers.
struct Outcome {
    bool ok = true;
    std::array<double, 3> reached{kNever, kNever, kNever};  // [s] 10, 50 and 90 % burnt out
    double burnt = 0;                                       // share of sites at the end
    double early_burnt = 0, early_cuts = 0;                 // ... and at the early time
    double early_crumple = 0;                               // [m] out of plane at the early time
    double speed = 0;                                       // [m/s] of the front
    double band = 0;                                        // [m] mean width of what burns
    double cuts = 0;
    double broken = kNever;     // [s] when the first piece came off
    double fallen = 0;          // share of the paper's mass that is not held at the end
    std::vector<double> first;  // [s] first ignition of each sheet
};

// The front is taken as a quarter of a circle around the corner, from 10 to 50 % ignited.
class Front {
  public:
    explicit Front(const Params& p) : area_(p.sheet.width * p.sheet.height) {}

    void look(double time, const Share& share) {
        if (share.ignited < 0.1 || share.ignited > 0.5) return;
        const double radius = radius_of(share.ignited);
        if (widths_.empty()) first_time_ = time, first_radius_ = radius;
        last_time_ = time, last_radius_ = radius;
        widths_.push_back(radius - radius_of(share.burnt));
    }
    [[nodiscard]] double speed() const {
        return last_time_ > first_time_
                   ? (last_radius_ - first_radius_) / (last_time_ - first_time_)
                   : 0.0;
    }
    [[nodiscard]] double band() const { return widths_.empty() ? 0.0 : mean(widths_); }

  private:
    [[nodiscard]] double radius_of(double share) const {
        return std::sqrt(4.0 * share * area_ / std::numbers::pi);
    }

    double area_, first_time_ = 0, last_time_ = 0, first_radius_ = 0, last_radius_ = 0;
    std::vector<double> widths_;
};

Outcome burn(Params params, std::int64_t seed, double duration, double early) {
    params.numerics.seed = seed;
    World world = make_world(params, 1);
    Outcome outcome;
    Front front(params);
    const auto ticks = static_cast<int>(std::lround(duration * params.numerics.tick_rate));
    for (int tick = 0; tick < ticks && outcome.ok; ++tick) {
        outcome.ok = world.step().ok();
        const double time = world.state().time;
        const Share share = share_of(world);
        front.look(time, share);
        for (std::size_t i = 0; i < outcome.reached.size(); ++i) {
            if (share.burnt >= std::array{0.1, 0.5, 0.9}[i])
                outcome.reached[i] = std::min(outcome.reached[i], time);
        }
        outcome.fallen = loose_share(world.state().sheets[0]);
        if (outcome.fallen > 0) outcome.broken = std::min(outcome.broken, time);
        if (time <= early) {
            outcome.early_burnt = share.burnt;
            outcome.early_cuts = static_cast<double>(world.state().totals.cuts);
            outcome.early_crumple = out_of_plane(world.state().sheets[0]);
        }
        outcome.burnt = share.burnt;
    }
    outcome.speed = front.speed();
    outcome.band = front.band();
    outcome.cuts = static_cast<double>(world.state().totals.cuts);
    for (const SheetState& sheet : world.state().sheets)
        outcome.first.push_back(
            *std::min_element(sheet.ignition_time.begin(), sheet.ignition_time.end()));
    return outcome;
}

using Outcomes = std::vector<Outcome>;

Outcomes burn_all(const Params& params, double duration, double early = 0) {
    Outcomes outcomes(kSeeds);
    run_jobs(kSeeds, 2, [&](std::size_t i) {
        outcomes[i] = burn(params, static_cast<std::int64_t>(i) + 1, duration, early);
    });
    for (const Outcome& outcome : outcomes)
        EXPECT_TRUE(outcome.ok);
    return outcomes;
}

template <class Value>
void print_row(const char* what, const Outcomes& outcomes, double scale, Value&& value) {
    std::vector<double> values;
    for (const Outcome& outcome : outcomes)
        values.push_back(scale * value(outcome));
    const auto [least, most] = std::minmax_element(values.begin(), values.end());
    std::printf("  %-28s %9.4g  (%.4g to %.4g)\n", what, median(values), *least, *most);
}

void print_table(const char* name, const Outcomes& outcomes) {
    std::printf("%s: median (range) of %zu seeds\n", name, outcomes.size());
    print_row("10 % burnt out [s]", outcomes, 1, [](const Outcome& o) { return o.reached[0]; });
    print_row("50 % burnt out [s]", outcomes, 1, [](const Outcome& o) { return o.reached[1]; });
    print_row("90 % burnt out [s]", outcomes, 1, [](const Outcome& o) { return o.reached[2]; });
    print_row("burnt at the end [%]", outcomes, 100, [](const Outcome& o) { return o.burnt; });
    print_row("cuts", outcomes, 1, [](const Outcome& o) { return o.cuts; });
    print_row("first piece off [s]", outcomes, 1, [](const Outcome& o) { return o.broken; });
    print_row("fallen at the end [%]", outcomes, 100, [](const Outcome& o) { return o.fallen; });
}

void print_front(const Outcomes& outcomes) {
    print_row("front speed [mm/s]", outcomes, 1000, [](const Outcome& o) { return o.speed; });
    print_row("burning band [mm]", outcomes, 1000, [](const Outcome& o) { return o.band; });
    print_row("burnt at the early time [%]", outcomes, 100,
              [](const Outcome& o) { return o.early_burnt; });
    print_row("out of plane then, RMS [mm]", outcomes, 1000,
              [](const Outcome& o) { return o.early_crumple; });
    print_row("cuts then", outcomes, 1, [](const Outcome& o) { return o.early_cuts; });
}

// How many pairs of runs with the same seed are as claimed.
template <class Claim>
int holds(const Outcomes& a, const Outcomes& b, Claim&& claim) {
    int count = 0;
    for (std::size_t i = 0; i < kSeeds; ++i)
        count += claim(a[i], b[i]) ? 1 : 0;
    return count;
}

// Keys of the parameters in which two presets differ.
std::vector<std::string> differences(const std::string& a, const std::string& b) {
    const Params p = bench_params(a), q = bench_params(b);
    std::vector<std::string> keys;
    for (const ParamInfo& row : sim_param_rows()) {
        if (row.value(&p) != row.value(&q)) keys.emplace_back(row.key);
    }
    return keys;
}

TEST(Pairs, DifferInTheNamedParametersOnly) {
    using Keys = std::vector<std::string>;
    EXPECT_EQ(differences("paper/cigarette_white", "paper/cigarette_rolling"), Keys{"paper.c_s"});
    // cardboard does not catch fire from what lights paper
    EXPECT_EQ(differences("paper/corner", "paper/cardboard"),
              (Keys{"paper.grammage", "paper.c_s", "lighter.strength", "lighter.duration"}));
    EXPECT_EQ(differences("paper/corner", "paper/corner_no_fracture"), Keys{"fracture.threshold"});
}

TEST(Figure7, WithoutFractureNothingIsCutAndAllBurns) {
    const Outcomes sheets = burn_all(bench_params("paper/corner_no_fracture"), 10);
    print_table("corner_no_fracture", sheets);
    EXPECT_GE(holds(sheets, sheets, [](auto& o, auto&) { return o.cuts == 0 && o.burnt > 0.9; }),
              kMustHold);
}

TEST(Figure8, CardboardBurnsSlowerCrumplesAndCracksLessThanPaper) {
    constexpr double kDuration = 40, kEarly = 5;  // [s]
    const Params cardboard = bench_params("paper/cardboard");
    Params paper = cardboard;  // nothing else differs
    paper.paper = bench_params("paper/corner").paper;
    ASSERT_EQ(paper.paper.grammage, 0.080);
    ASSERT_EQ(paper.paper.c_s, 2e-4);
    const Outcomes heavy = burn_all(cardboard, kDuration, kEarly);
    const Outcomes light = burn_all(paper, 10, kEarly);
    print_table("cardboard, 40 s", heavy);
    print_front(heavy);
    print_table("the same of 80 g/m^2, 10 s", light);
    print_front(light);
    const auto less = [&](auto&& value) {
        return holds(heavy, light,
                     [&](const Outcome& a, const Outcome& b) { return value(a) < value(b); });
    };
    EXPECT_GE(less([](const Outcome& o) { return o.early_burnt; }), kMustHold);
    EXPECT_GE(less([](const Outcome& o) { return o.early_crumple; }), kMustHold);
    EXPECT_GE(less([](const Outcome& o) { return o.speed; }), kMustHold);
    EXPECT_GE(less([](const Outcome& o) { return o.band; }), kMustHold);
    EXPECT_GE(less([](const Outcome& o) { return o.early_cuts; }), kMustHold);
    EXPECT_GE(less([](const Outcome& o) { return o.cuts; }), kMustHold);  // in all, too
}

TEST(Figure1, TheSheetsOfAStackIgniteInOrderAndOnlyByParticles) {
    const Params params = bench_params("paper/stack");
    const Outcomes stacks = burn_all(params, 5.5);
    print_table("stack", stacks);
    EXPECT_GE(holds(stacks, stacks,
                    [](const Outcome& o, const Outcome&) {
                        return std::is_sorted(o.first.begin(), o.first.end(),
                                              std::less_equal<>()) &&
                               std::isfinite(o.first.back());
                    }),
              kMustHold);
    Params apart = params;  // further than particles reach, all else as before
    apart.sheet.gap = 0.3;
    const Outcomes spread = burn_all(apart, 5.5);
    EXPECT_GE(holds(spread, spread,
                    [](const Outcome& o, const Outcome&) {
                        return std::isfinite(o.first[0]) && !std::isfinite(o.first[1]);
                    }),
              kMustHold);
}

TEST(Figures9And10, TheWhiteCigaretteGoesOutAndBreaksAndTheRollingPaperTurnsToAsh) {
    const Outcomes whites = burn_all(bench_params("paper/cigarette_white"), 9);
    const Outcomes rollings = burn_all(bench_params("paper/cigarette_rolling"), 9);
    print_table("cigarette_white", whites);
    print_table("cigarette_rolling", rollings);
    // consumed in part, and what has burnt comes off
    EXPECT_GE(holds(whites, rollings,
                    [](const Outcome& w, const Outcome&) {
                        return w.burnt > 0.05 && w.burnt < 0.6 && std::isfinite(w.broken) &&
                               w.fallen < 0.6;
                    }),
              kMustHold);
    // all but the rings at its end, which is held and kept cold
    EXPECT_GE(
        holds(whites, rollings, [](const Outcome&, const Outcome& r) { return r.burnt > 0.9; }),
        kMustHold);
}

}  // namespace
}  // namespace ember
