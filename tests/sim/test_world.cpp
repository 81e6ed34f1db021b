// The world as a whole: determinism, snapshots, ledgers, rollback, live edits, idle stages.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "rig.h"
#include "sim/check.h"
#include "sim/energy.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember {
namespace {

// A small sheet that is lit, burns and cracks within two seconds.
Params small_burn() {
    Params p;
    p.sheet.rows = 16;
    p.sheet.columns = 24;
    p.sheet.width = 0.105;
    p.sheet.height = 0.1485;
    p.springs.stiffness_scale = 10;
    p.world.held_gravity = 0.06;
    p.lighter.x = -0.05;
    p.lighter.y = p.sheet.elevation - p.sheet.height - 0.02;
    p.burning.burn_speed = 2;
    return p;
}

void advance(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        const StepReport report = world.step();
        ASSERT_TRUE(report.ok()) << report.reason << " at " << report.time << " s";
    }
}

TEST(World, TheSameSeedGivesTheSameBitsOnAnyNumberOfThreads) {
    Params p = small_burn();
    p.sheet.rows = 48;  // large enough for the threads to be used
    p.sheet.columns = 72;
    World one = make_world(p, 1), again = make_world(p, 1), two = make_world(p, 2),
          five = make_world(p, 5);
    for (int i = 0; i < 40; ++i) {
        for (World* world : {&one, &again, &two, &five})
            ASSERT_TRUE(world->step().ok());
        ASSERT_EQ(one.hash(), again.hash()) << "tick " << i;
        ASSERT_EQ(one.hash(), two.hash()) << "tick " << i;
        ASSERT_EQ(one.hash(), five.hash()) << "tick " << i;
    }
    EXPECT_GT(one.state().totals.ignitions, 0);
    p.numerics.seed = 2;
    World other = make_world(p, 1);
    advance(other, 40);
    EXPECT_NE(one.hash(), other.hash());
}

TEST(World, ASnapshotRestoresExactlyAndGoesOnExactly) {
    World world = make_world(small_burn());
    advance(world, 90);
    const WorldState saved = world.snapshot();
    const std::uint64_t then = world.hash();
    advance(world, 60);
    const std::uint64_t later = world.hash();
    EXPECT_NE(then, later);
    World other = make_world(small_burn());
    for (World* w : {&world, &other}) {
        w->restore(saved);
        EXPECT_EQ(w->hash(), then);
        advance(*w, 60);
        EXPECT_EQ(w->hash(), later);
    }
    EXPECT_GT(world.state().totals.cuts, 0) << "the restored run includes changes of topology";
}

// Flips one bit of the last entry of an array, or of a value.
struct BitFlipper {
    int target, seen = 0;
    const char* name = nullptr;

    template <class T>
    static void flip(T& value) {
        auto* bytes = reinterpret_cast<unsigned char*>(&value);
        bytes[0] = static_cast<unsigned char>(bytes[0] ^ 1u);
    }
    template <class T>
    void operator()(const char* field, std::vector<T>& array) {
        if (seen++ != target) return;
        name = field;
        ASSERT_FALSE(array.empty()) << field;
        flip(array.back());
    }
    template <class T>
    requires std::is_arithmetic_v<T>
    void operator()(const char* field, T& value) {
        if (seen++ != target) return;
        name = field;
        flip(value);
    }
};

TEST(World, AFlippedBitInAnyArrayChangesTheHash) {
    World world = make_world(small_burn());
    advance(world, 60);
    ASSERT_GT(world.state().fire.size(), 0u);
    const std::uint64_t hash = world.hash();
    int fields = 0;
    for (int target = 0;; ++target) {
        WorldState state = world.snapshot();
        BitFlipper flipper{target};
        for_each_field(state, flipper);
        if (flipper.name == nullptr) break;
        ++fields;
        EXPECT_NE(hash_of(state), hash) << flipper.name;
    }
    EXPECT_GT(fields, 50);
}

TEST(World, TwoWorldsInOneProcessDoNotKnowOfEachOther) {
    World a = make_world(small_burn());
    advance(a, 30);
    Params q = small_burn();
    q.sheet.rows = 5;
    World b = make_world(q), c = make_world(small_burn());
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(b.step().ok());
        ASSERT_TRUE(c.step().ok());
    }
    EXPECT_EQ(a.hash(), c.hash());
}

TEST(World, EveryTickBalancesMassEnergyAndHeat) {
    World world = make_world(small_burn());
    double mass = 0;
    for (const double m : world.state().sheets[0].mass)
        mass += m;
    for (int i = 0; i < 240; ++i) {
        ASSERT_TRUE(world.step().ok());
        double left = 0;
        for (const double m : world.state().sheets[0].mass)
            left += m;
        ASSERT_NEAR((left + world.state().totals.burnt_mass) / mass, 1.0, 1e-12);
        const HeatLedger& h = world.state().heat;
        const double given = h.given_fire + h.given_burning;
        ASSERT_NEAR(h.stored + h.lost_air + h.lost_held, given, 1e-10 * given + 1e-15);
        double scale = 0;
        ASSERT_LE(unaccounted_energy(world.state().energy, scale),
                  kEnergyMargin * world.state().energy.largest + 1e-12);
    }
    EXPECT_GT(world.state().totals.cuts, 0);
    EXPECT_GT(world.state().totals.burnouts, 100);
    EXPECT_EQ(world.state().sheets[0].quads.size(), 16u * 24u);
}

TEST(World, EnergyOfASmoothSwingIsAccountedForToFourDigits) {
    Params p = test::plain(8, 12);
    p.sheet.held = HeldEdge::MainStart;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.1;
    p.numerics.integrator = IntegratorKind::Rk4;
    p.numerics.substeps_min = 8;  // at the bound RK4 itself loses 0.3 % of the fastest motion
    World world = make_world(p);
    advance(world, 30);
    const EnergyLedger& e = world.state().energy;
    EXPECT_GT(e.loss_damping, 0);
    EXPECT_GT(e.loss_drag, 0);
    double scale = 0;
    const double excess = unaccounted_energy(e, scale);
    EXPECT_LE(std::abs(excess), 1e-4 * scale);
}

TEST(World, LeapfrogStepsAtTheBoundAccountForTheirEnergy) {
    // a burn that shakes the sheet; half a per cent of its friction would be ten times the margin
    for (const auto integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::VelocityVerlet}) {
        Params p = small_burn();
        p.numerics.integrator = integrator;
        World world = make_world(p);
        advance(world, 240);
        const EnergyLedger& e = world.state().energy;
        EXPECT_LE(world.state().totals.retries, 3);
        EXPECT_GT(e.loss_damping, 0);
        EXPECT_LE(std::abs(e.unaccounted), 0.01 * (e.loss_damping + e.loss_drag));
    }
}

TEST(World, AnUnstableStepIsRolledBackAndRetriedWithASmallerOne) {
    Params p = small_burn();
    p.world.air_drag = 0;
    p.numerics.safety = 3;  // sub-steps three times as long as the bound allows
    World reckless = make_world(p);
    int retries = 0;
    for (int i = 0; i < 120; ++i) {
        const StepReport report = reckless.step();
        ASSERT_TRUE(report.ok()) << report.reason;
        retries += report.retries;
    }
    EXPECT_GT(retries, 0);
    EXPECT_LT(retries, 60);  // what a tick needed is kept for those after it
    EXPECT_EQ(reckless.state().totals.retries, retries);
    for (const double y : reckless.state().sheets[0].position.y)
        EXPECT_LT(std::abs(y), 10.0);
}

TEST(World, ANumberThatIsNotFiniteStopsTheRunWithItsPlaceAndChangesNothing) {
    World world = make_world(small_burn());
    advance(world, 10);
    WorldState poisoned = world.snapshot();
    poisoned.sheets[0].velocity.y[77] = std::numeric_limits<double>::quiet_NaN();
    world.restore(poisoned);
    const std::uint64_t before = world.hash();
    const StepReport report = world.step();
    EXPECT_EQ(report.status, StepStatus::Diverged);
    EXPECT_EQ(report.stage, Stage::Springs);
    EXPECT_EQ(report.sheet, 0);
    EXPECT_GE(report.node, 0);
    EXPECT_EQ(report.retries, 6);
    EXPECT_FALSE(report.reason.empty());
    EXPECT_EQ(world.hash(), before);
    world.restore(make_world(small_burn()).snapshot());
    EXPECT_TRUE(world.step().ok()) << "the world is still usable";
}

TEST(World, AHotSpotThatIsNotFiniteNamesTheHeat) {
    World world = make_world(small_burn());
    WorldState poisoned = world.snapshot();
    poisoned.sheets[0].temperature[200] = std::numeric_limits<double>::infinity();
    world.restore(poisoned);
    const StepReport report = world.step();
    EXPECT_EQ(report.stage, Stage::Heat);
    EXPECT_NE(report.node, kNone);
}

TEST(World, LiveParametersActAtOnceAndOthersAreRefused) {
    World world = make_world(small_burn());
    advance(world, 20);
    Params p = world.params();
    p.world.gravity = 3.0;
    EXPECT_TRUE(world.apply(p));
    EXPECT_EQ(world.params().world.gravity, 3.0);
    advance(world, 20);  // the ledger knows of the edit
    EXPECT_NE(world.state().energy.change_edit, 0.0);
    p.sheet.rows = 17;
    EXPECT_FALSE(world.apply(p));
    EXPECT_EQ(world.params().sheet.rows, 16);
}

TEST(World, AnUnlitSceneDoesNoWorkForFireHeatBurningOrCracks) {
    Params p = small_burn();
    p.lighter.on = false;
    World world = make_world(p);
    for (int i = 0; i < 30; ++i) {
        const StepCounters c = world.step().counters;
        EXPECT_EQ(c.particles_born + c.particles_moved + c.coupling_pairs, 0);
        EXPECT_EQ(c.heat_nodes + c.heat_substeps, 0);
        EXPECT_EQ(c.nodes_ignited + c.nodes_burning + c.springs_shrunk + c.cuts, 0);
        EXPECT_GT(c.spring_evaluations, 0);
    }
    // and the sheet moves exactly as beside a lighter that is too far away to be felt
    p.lighter.on = true;
    p.lighter.x = 50;
    World far = make_world(p);
    advance(far, 30);
    EXPECT_GT(far.state().fire.size(), 0u);
    EXPECT_EQ(world.state().sheets[0].position.y, far.state().sheets[0].position.y);
    EXPECT_EQ(world.state().sheets[0].velocity.z, far.state().sheets[0].velocity.z);
}

TEST(World, EdgesAndCornersAreHeldTogether) {
    const auto held = [](HeldEdge places) {
        Params p;
        p.sheet.rows = 2;
        p.sheet.columns = 3;
        p.sheet.held = places;
        const World world = make_world(p);
        std::string nodes;
        for (const std::uint8_t h : world.state().sheets[0].held)
            nodes += h != 0 ? 'x' : '.';
        return nodes;
    };
    EXPECT_EQ(held(HeldEdge::None), "............");
    EXPECT_EQ(held(HeldEdge::MainStart), "x...x...x...");
    EXPECT_EQ(held(HeldEdge::MainEnd), "...x...x...x");
    EXPECT_EQ(held(HeldEdge::BothMainEnds), "x..xx..xx..x");
    EXPECT_EQ(held(HeldEdge::BothCrossEnds), "xxxx....xxxx");
    EXPECT_EQ(held(HeldEdge::CornerMainStartCrossStart), "x...........");
    EXPECT_EQ(held(HeldEdge::CornerMainStartCrossEnd), "........x...");
    EXPECT_EQ(held(HeldEdge::CornerMainEndCrossStart), "...x........");
    EXPECT_EQ(held(HeldEdge::CornerMainEndCrossEnd), "...........x");
    EXPECT_EQ(held(HeldEdge::CrossStart | HeldEdge::MainEnd | HeldEdge::CornerMainStartCrossEnd),
              "xxxx...xx..x");
}

TEST(World, ATubeAndAStackRunThroughTheSameStages) {
    Params p = small_burn();
    p.sheet.count = 3;
    World stack = make_world(p);
    advance(stack, 60);
    EXPECT_EQ(stack.view().sheets.size(), 3u);
    p.sheet.count = 1;
    p.sheet.shape = SheetShape::Cylinder;
    World tube = make_world(p);
    advance(tube, 60);
    EXPECT_TRUE(tube.view().sheets[0].closed);
}

TEST(ParamTable, DefaultsLieInTheirRangesAndKeysAreUnique) {
    Params defaults;
    const ParamBinding binding = bind(defaults);
    for (const ParamInfo& row : binding.rows) {
        EXPECT_FALSE(row.help.empty()) << row.key;
        EXPECT_FALSE(row.source.empty()) << row.key;
        EXPECT_EQ(find_param(binding.rows, row.key), &row) << row.key << " appears twice";
        if (!row.is_number()) continue;
        EXPECT_TRUE(row.hard.contains(row.shown(binding.object))) << row.key;
        EXPECT_GE(row.tested.min, row.hard.min) << row.key;
        EXPECT_LE(row.tested.max, row.hard.max) << row.key;
        const double value = row.get(binding.object);
        row.set_shown(binding.object, row.shown(binding.object));
        EXPECT_NEAR(row.get(binding.object), value, 1e-14 * std::abs(value)) << row.key;
    }
    EXPECT_TRUE(plausibility_warnings(defaults).empty());
    Params cold = defaults;
    cold.heat.flame_limit = 500;
    EXPECT_EQ(plausibility_warnings(cold).size(), 1u);
}

}  // namespace
}  // namespace ember
