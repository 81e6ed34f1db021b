// Paper that becomes another while it burns: masses, springs and both ledgers.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "rig.h"
#include "sim/world.h"

namespace ember {
namespace {

Params burning() {
    Params p;
    p.sheet.rows = 12;
    p.sheet.columns = 16;
    p.lighter.duration = 10;
    return p;
}

void advance(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i) {
        const StepReport report = world.step();
        ASSERT_TRUE(report.ok()) << report.reason;
    }
}

double mass_of(const World& world) {
    const std::vector<double>& mass = world.state().sheets[0].mass;
    return std::accumulate(mass.begin(), mass.end(), 0.0);
}

TEST(LiveMaterial, GrammageScalesMassesAndSpringsInPlace) {
    World world = make_world(burning());
    advance(world, 120);
    const double mass = mass_of(world), x = world.state().sheets[0].position.x[40];
    Params p = world.params();
    p.paper.grammage *= 2;
    ASSERT_TRUE(world.apply(p));
    EXPECT_EQ(world.state().tick, 120u);
    EXPECT_EQ(world.state().sheets[0].position.x[40], x);
    EXPECT_NEAR(mass_of(world), 2 * mass, 1e-12 * mass);
}

TEST(LiveMaterial, ColdPaperOfTheNewGrammageMovesAsIfItHadAlwaysBeenSo) {
    Params p = burning();
    p.lighter.on = false;
    World edited = make_world(p);
    p.paper.grammage *= 1.7;
    p.paper.density *= 0.5;
    p.springs.stiffness_scale *= 1.3;
    World fresh = make_world(p);
    ASSERT_TRUE(edited.apply(p));
    advance(edited, 40);
    advance(fresh, 40);
    const SheetState &a = edited.state().sheets[0], &b = fresh.state().sheets[0];
    double fallen = 0;
    for (std::size_t n = 0; n < a.mass.size(); ++n) {
        EXPECT_NEAR((a.position.at(n) - b.position.at(n)).norm(), 0.0, 1e-10);
        fallen = std::max(fallen, b.velocity.at(n).norm());
    }
    EXPECT_GT(fallen, 1e-4) << "it has moved at all";
}

TEST(LiveMaterial, BothLedgersStayClosedWhileItBurns) {
    World world = make_world(burning());
    advance(world, 150);
    ASSERT_GT(world.state().heat.stored, 0.0);
    Params p = world.params();
    p.paper.grammage *= 1.5;
    p.paper.c_s *= 3;
    p.paper.specific_heat *= 0.8;
    const double stored = world.state().heat.stored;
    ASSERT_TRUE(world.apply(p));
    EXPECT_NEAR(world.state().heat.change_edit, world.state().heat.stored - stored, 1e-15);
    EXPECT_NE(world.state().heat.change_edit, 0.0);
    advance(world, 100);  // every tick is checked against both
    EXPECT_GT(world.state().totals.burnouts, 0);
}

TEST(LiveMaterial, SheetsThatWouldOverlapAreRefusedAndNothingHasChanged) {
    Params p = test::plain(4, 4);
    p.sheet.count = 2;
    p.sheet.gap = 0.002;
    World world = make_world(p);
    advance(world, 2);
    const std::uint64_t hash = world.hash();
    Params thick = p;
    thick.paper.grammage = 5;
    thick.paper.density = 50;  // 100 mm
    EXPECT_THROW(static_cast<void>(world.apply(thick)), SceneError);
    EXPECT_EQ(world.hash(), hash);
    EXPECT_EQ(world.params().paper.grammage, p.paper.grammage);
    advance(world, 2);
}

// Edits at ticks 40 and 90 of a burn.
std::vector<TimedParams> edits(const Params& base) {
    std::vector<TimedParams> script{{40, base}, {90, base}};
    script[0].params.paper.grammage *= 1.4;
    script[0].params.wind.x = 0.5;
    script[1].params = script[0].params;
    script[1].params.lighter.x += 0.03;
    script[1].params.paper.c_s *= 2;
    return script;
}

TEST(Script, ASteeredBurnIsTheSameByHandAndByScript) {
    const Params base = burning();
    World by_hand = make_world(base), scripted = make_world(base);
    scripted.set_script(base, edits(base));
    for (const TimedParams& entry : edits(base)) {
        advance(by_hand, static_cast<int>(entry.tick - by_hand.state().tick));
        ASSERT_TRUE(by_hand.apply(entry.params));
    }
    advance(by_hand, 60);
    advance(scripted, 150);
    EXPECT_EQ(by_hand.hash(), scripted.hash());
    World unsteered = make_world(base);
    advance(unsteered, 150);
    EXPECT_NE(unsteered.hash(), scripted.hash());
}

TEST(Script, GoingBackPutsBackTheParametersThatWereInForce) {
    const Params base = burning();
    World world = make_world(base);
    world.set_script(base, edits(base));
    advance(world, 40);
    const WorldState before_edit = world.snapshot();
    advance(world, 20);
    const WorldState between = world.snapshot();
    advance(world, 60);
    const std::uint64_t hash = world.hash();
    world.restore(between);
    EXPECT_EQ(world.params().wind.x, 0.5);
    EXPECT_EQ(world.params().lighter.x, base.lighter.x);
    advance(world, 60);
    EXPECT_EQ(world.hash(), hash);
    world.restore(before_edit);
    EXPECT_EQ(world.params().paper.grammage, base.paper.grammage);
    world.take_scripted();
    EXPECT_EQ(world.params().paper.grammage, 1.4 * base.paper.grammage);
    advance(world, 80);
    EXPECT_EQ(world.hash(), hash);
}

TEST(Script, WhatNeedsARebuildIsNoScript) {
    const Params base = burning();
    World world = make_world(base);
    Params wider = base;
    wider.sheet.width *= 2;
    EXPECT_THROW(world.set_script(base, {{3, wider}}), std::invalid_argument);
}

}  // namespace
}  // namespace ember
