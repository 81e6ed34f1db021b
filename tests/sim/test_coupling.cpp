// What fire and sheets give each other, against every particle and every node taken in turn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_sheet.h"
#include "sim/fire_coupling.h"

namespace ember {
namespace {

using test::Dice;
using test::plain;
using test::Rig;

constexpr double kTime = 3.0;  // [s] at the end of the tick
constexpr double kTick = 1.0 / 60;

// Two crumpled sheets above each other that are cut, have lost mass, and move; one is held, and
// has burnt out in one half.
struct Blaze {
    Params params;
    std::vector<SheetState> sheets;
    std::vector<NodeTiles> tiles;
    FireState fire;
};

void add_sheet(Blaze& blaze, Dice& dice, HeldEdge held, double height) {
    blaze.params.sheet.held = held;
    Rig rig(blaze.params);
    test::crumple(rig, dice);
    test::burn_and_cut(rig, dice);
    SheetState& sheet = rig.sheet;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        sheet.position.y[n] += height;
        sheet.velocity.set(n, dice.vector(0.5));
        const bool ash = held != HeldEdge::None && sheet.position.x[n] > 0;
        sheet.phase[n] = ash ? Phase::BurntOut : dice.chance(0.5) ? Phase::Burning : Phase::Unburnt;
    }
    group_nodes(rig.lattice, sheet, blaze.tiles.emplace_back());
    blaze.sheets.push_back(sheet);
}

// Near a node, on it, at the kernel's very radius from it or just within, or far away.
Vector3 random_place(const Blaze& blaze, Dice& dice) {
    const SheetState& sheet = blaze.sheets[static_cast<std::size_t>(dice.below(2))];
    const auto node = static_cast<std::size_t>(dice.below(static_cast<int>(sheet.mass.size())));
    const double radius = blaze.params.fire.kernel_radius;
    switch (dice.below(8)) {
        case 0:
            return sheet.position.at(node);
        case 1:
            return sheet.position.at(node) + Vector3(dice.chance(0.5) ? radius : -radius, 0, 0);
        case 3: {
            const double side = dice.chance(0.5) ? 1 : -1;
            return sheet.position.at(node) + Vector3(side * dice.in(0.99, 1.0) * radius, 0, 0);
        }
        case 2:
            return dice.vector(3.0);
        default:
            return sheet.position.at(node) + dice.vector(1.5 * radius);
    }
}

Blaze make_blaze(std::uint64_t trial, int particles) {
    Dice dice(trial);
    Blaze blaze;
    Params& p = blaze.params = plain(9 + dice.below(8), 9 + dice.below(8));
    p.paper.grammage = 0.08 * dice.factor(3);
    p.paper.c_s = 2e-4 * dice.factor(5);
    p.fire.kernel_radius *= dice.factor(1.5);
    p.fire.heating_limit *= dice.factor(3);
    p.fire.force *= dice.factor(10);
    add_sheet(blaze, dice, HeldEdge::MainStart, 0);
    add_sheet(blaze, dice, HeldEdge::None, 0.01);
    FireState& fire = blaze.fire;
    for (int i = 0; i < particles; ++i) {
        fire.position.push_back(random_place(blaze, dice));
        fire.velocity.push_back(dice.vector(1.0));
        fire.temperature.push_back(dice.in(p.heat.ambient, p.fire.temperature));
        fire.strength.push_back(dice.in(0, 2));
        fire.birth.push_back(kTime - (dice.chance(0.1) ? 0.0 : dice.in(0, 0.1)));
        fire.death.push_back(kTime + 1);
        fire.id.push_back(static_cast<std::uint64_t>(i));
    }
    return blaze;
}

struct Outcome {
    std::vector<NodeFire> received;
    std::vector<double> temperature;  // [K] of the particles
    StepCounters counters;
    Index blocks = 0;  // that the work was divided into
};

Outcome couple(const Blaze& blaze, bool skip, int threads) {
    Params p = blaze.params;
    p.numerics.skip = skip;
    ThreadPool pool(threads);
    CouplingScratch scratch;
    Outcome outcome;
    FireState fire;
    for (int pass = 0; pass < 2; ++pass) {  // the second time on used scratch
        fire = blaze.fire;
        couple_fire(p, kTime, kTick, blaze.sheets, blaze.tiles, fire, pool, scratch,
                    outcome.received, outcome.counters);
    }
    outcome.temperature = fire.temperature;
    outcome.blocks = scratch.plan.blocks;
    return outcome;
}

double weight_of(const Vector3& particle, const Vector3& node, double radius) {
    const double q = 1 - (particle - node).squaredNorm() / (radius * radius);
    return q > 0 ? q * q : 0.0;
}

double freshness_of(const Blaze& blaze, std::size_t particle) {
    return std::exp((blaze.fire.birth[particle] - kTime) / blaze.params.fire.heating_time);
}

double area_of(const Blaze& blaze, const SheetState& sheet, std::size_t node) {
    return sheet.initial_mass[node] / blaze.params.paper.grammage;
}

// What one node gets by the laws of fire_coupling.h.
struct Gain {
    double heating = 0;               // [K/s]
    Vector3 force = Vector3::Zero();  // [N]
    double force_rounding = 0;        // [N] by which the order of additions may change the force
    bool limited = false;
};

Gain gain_of(const Blaze& blaze, const SheetState& sheet, std::size_t n) {
    const FireParams& f = blaze.params.fire;
    const double ambient = blaze.params.heat.ambient;
    const double a = f.heating *
                     std::pow(0.080 / blaze.params.paper.grammage, f.grammage_exponent) *
                     std::pow(2e-4 / blaze.params.paper.c_s, f.stability_exponent);
    Gain gain;
    if (sheet.held[n] != 0) return gain;
    const double per_speed = f.force * area_of(blaze, sheet, n);  // [kg/s]
    for (std::size_t p = 0; p < blaze.fire.size(); ++p) {
        const double w =
            weight_of(blaze.fire.position.at(p), sheet.position.at(n), f.kernel_radius);
        gain.heating += a * blaze.fire.strength[p] * freshness_of(blaze, p) *
                        (blaze.fire.temperature[p] - ambient) / (f.temperature - ambient) * w;
        const Vector3 moving = blaze.fire.velocity.at(p), still = sheet.velocity.at(n);
        gain.force += per_speed * w * (moving - still);
        // at the very radius the weight itself is rounding, of at most (8e-16)²
        const double uncertain = 1e-12 * w + 1e-30;
        gain.force_rounding += uncertain * per_speed * (moving.norm() + still.norm());
    }
    gain.heating = -f.heating_limit * std::expm1(-gain.heating / f.heating_limit);
    if (sheet.phase[n] == Phase::BurntOut) gain.heating = 0;
    const double size = gain.force.norm(), limit = f.force_limit * sheet.mass[n];
    gain.limited = size > limit;
    if (gain.limited) {
        gain.force *= limit / size;
        gain.force_rounding *= 2 * limit / size;  // its size is rounded as well
    }
    return gain;
}

// Temperature of a particle after it has given what it gives [K].
double cooled(const Blaze& blaze, std::size_t particle) {
    const FireParams& f = blaze.params.fire;
    double absorbed = 0;
    for (const SheetState& sheet : blaze.sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            if (sheet.held[n] != 0 || sheet.phase[n] == Phase::BurntOut) continue;
            absorbed +=
                area_of(blaze, sheet, n) / (f.kernel_radius * f.kernel_radius) *
                weight_of(blaze.fire.position.at(particle), sheet.position.at(n), f.kernel_radius);
        }
    }
    const double excess = blaze.fire.temperature[particle] - blaze.params.heat.ambient;
    return blaze.params.heat.ambient +
           excess * std::exp(-f.absorption * kTick * freshness_of(blaze, particle) * absorbed);
}

// How many nodes and particles have been through what.
struct Tally {
    int heated = 0, saturated = 0, pushed = 0, limited = 0, pushed_ash = 0, cooled = 0;
};

// Sums of some thousand terms are off by some thousand 1e-16 at the very most, and far less as
// roundings differ in sign: 1e-12 of the largest they can be.
void compare(const Blaze& blaze, const Outcome& got, Tally& tally) {
    const double limit = blaze.params.fire.heating_limit;
    for (std::size_t s = 0; s < blaze.sheets.size(); ++s) {
        const SheetState& sheet = blaze.sheets[s];
        ASSERT_EQ(got.received[s].heating.size(), sheet.mass.size());
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            const Gain gain = gain_of(blaze, sheet, n);
            ASSERT_NEAR(got.received[s].heating[n], gain.heating, 1e-12 * limit) << s << ' ' << n;
            const Vector3 difference = got.received[s].force.at(n) - gain.force;
            ASSERT_LE(difference.norm(), gain.force_rounding) << s << ' ' << n;
            const bool pushed = gain.force.norm() > 0;
            tally.heated += gain.heating > 0 ? 1 : 0;
            tally.saturated += gain.heating > 0.5 * limit ? 1 : 0;
            tally.pushed += pushed ? 1 : 0;
            tally.limited += gain.limited ? 1 : 0;
            tally.pushed_ash += pushed && sheet.phase[n] == Phase::BurntOut ? 1 : 0;
        }
    }
    for (std::size_t p = 0; p < blaze.fire.size(); ++p) {
        const double expected = cooled(blaze, p);
        ASSERT_NEAR(got.temperature[p], expected, 1e-12 * blaze.params.fire.temperature) << p;
        tally.cooled += expected < blaze.fire.temperature[p] - 0.1 ? 1 : 0;
    }
}

TEST(CouplingLaws, EveryNodeAndParticleGetsWhatEachPairGives) {
    Tally tally;
    for (std::uint64_t trial = 0; trial < 24; ++trial) {
        SCOPED_TRACE(trial);
        const Blaze blaze = make_blaze(trial, trial == 0 ? 4000 : trial % 2 == 0 ? 40 : 700);
        compare(blaze, couple(blaze, true, 1), tally);
        if (HasFatalFailure()) return;
    }
    for (const int count : {tally.heated, tally.saturated, tally.pushed, tally.limited,
                            tally.pushed_ash, tally.cooled}) {
        EXPECT_GT(count, 300);
    }
}

void expect_same_bits(const Outcome& a, const Outcome& b) {
    EXPECT_EQ(a.temperature, b.temperature);
    ASSERT_EQ(a.received.size(), b.received.size());
    for (std::size_t s = 0; s < a.received.size(); ++s) {
        EXPECT_EQ(a.received[s].heating, b.received[s].heating);
        EXPECT_EQ(a.received[s].force.x, b.received[s].force.x);
        EXPECT_EQ(a.received[s].force.y, b.received[s].force.y);
        EXPECT_EQ(a.received[s].force.z, b.received[s].force.z);
    }
}

TEST(CouplingLaws, NeitherSkippingNorThreadsChangeABit) {
    for (std::uint64_t trial = 100; trial < 112; ++trial) {
        SCOPED_TRACE(trial);
        // the last ones are enough work to be divided between threads
        const Blaze blaze = make_blaze(trial, trial < 108 ? 300 : 4000);
        const Outcome some = couple(blaze, true, 1), all = couple(blaze, false, 1);
        EXPECT_LT(some.counters.coupling_pairs, all.counters.coupling_pairs);
        EXPECT_EQ(some.blocks > 1, trial >= 108);
        expect_same_bits(some, all);
        expect_same_bits(some, couple(blaze, true, 3));
    }
}

}  // namespace
}  // namespace ember
