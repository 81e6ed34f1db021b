// The session without a window: time, edits, trouble.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

#include "ui/session.h"

namespace ember {
namespace {

Params small() {
    Params p;
    p.sheet.rows = 8;
    p.sheet.columns = 12;
    return p;
}

TEST(Session, StartsPausedAndPlaysWholeTicksWhateverTheFrameTime) {
    Session session(small(), 1);
    session.advance(1.0);
    EXPECT_EQ(session.stats().tick, 0u);
    session.play();
    for (int i = 0; i < 100; ++i)
        session.advance(0.01);  // 100 pictures per second
    EXPECT_NEAR(static_cast<double>(session.stats().tick), 60.0, 1.0);
    Session slow(small(), 1);
    slow.play();
    for (int i = 0; i < 20; ++i)
        slow.advance(0.05);  // 20 pictures per second
    EXPECT_NEAR(static_cast<double>(slow.stats().tick), 60.0, 1.0);
    while (slow.stats().tick < session.stats().tick)
        slow.step_once();
    while (session.stats().tick < slow.stats().tick)
        session.step_once();
    EXPECT_EQ(session.hash(), slow.hash());
}

TEST(Session, DropsTimeThatItCannotKeepUpWith) {
    Session session(small(), 1);
    session.play();
    session.advance(10.0);
    EXPECT_EQ(session.stats().tick, static_cast<std::uint64_t>(Session::kMostTicks));
    EXPECT_NEAR(session.stats().dropped, 10.0 - Session::kMostTicks / 60.0, 1.01 / 60.0)
        << "all but the fraction of a tick";
    session.advance(0.0);
    EXPECT_EQ(session.stats().tick, static_cast<std::uint64_t>(Session::kMostTicks));
}

TEST(Session, StopsAfterATickWhenThereIsNoTimeForMore) {
    Session session(small(), 1);
    session.play();
    EXPECT_EQ(session.advance(0.1, [] { return false; }), 1);
    EXPECT_EQ(session.stats().tick, 1u);
    EXPECT_EQ(session.advance(0.0), 0) << "what was due has been dropped";
}

TEST(Session, SaysWhenTheNextTickIsDue) {
    Session session(small(), 1);
    session.play();
    EXPECT_EQ(session.advance(0.010), 0);
    EXPECT_NEAR(session.until_next_tick(), 1.0 / 60.0 - 0.010, 1e-12);
}

TEST(Session, AStepIsOneTickAndPauses) {
    Session session(small(), 1);
    session.play();
    session.step_once();
    EXPECT_EQ(session.stats().tick, 1u);
    EXPECT_FALSE(session.playing());
}

TEST(Session, RestartBurnsTheSameAgain) {
    Session session(small(), 1);
    for (int i = 0; i < 20; ++i)
        session.step_once();
    const std::uint64_t hash = session.hash();
    session.restart();
    EXPECT_EQ(session.stats().tick, 0u);
    for (int i = 0; i < 20; ++i)
        session.step_once();
    EXPECT_EQ(session.hash(), hash);
}

TEST(Session, LiveEditsActAtOnceAndOthersRestartWithTheSameSeed) {
    Session session(small(), 1);
    for (int i = 0; i < 5; ++i)
        session.step_once();
    Params live = session.params();
    live.shrinkage.factor = 9e-12;
    live.paper.grammage = 0.120;
    EXPECT_EQ(session.apply(live), EditOutcome::Live);
    EXPECT_EQ(session.stats().tick, 5u);
    EXPECT_EQ(session.params().paper.grammage, 0.120);
    Params rebuild = live;
    rebuild.sheet.rows = 9;
    EXPECT_EQ(session.apply(rebuild), EditOutcome::Restarted);
    EXPECT_EQ(session.stats().tick, 0u);
    World fresh = make_world(rebuild);
    for (int i = 0; i < 10; ++i) {
        session.step_once();
        ASSERT_TRUE(fresh.step().ok());
    }
    EXPECT_EQ(session.hash(), fresh.hash());
}

TEST(Session, WhatCannotBeBuiltLeavesEverythingAsItWas) {
    Session session(small(), 1);
    session.step_once();
    Params bad = session.params();
    bad.sheet.width = 0;
    session.apply(bad);
    EXPECT_NE(session.message().find("sheet.width"), std::string::npos);
    EXPECT_EQ(session.stats().tick, 1u);
    EXPECT_GT(session.params().sheet.width, 0);
    session.apply(session.params());
    EXPECT_TRUE(session.message().empty());
}

TEST(Session, WhatIsOutOfRangeIsRefused) {
    Session session(small(), 1);
    Params bad = session.params();
    bad.world.gravity = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(session.apply(bad), EditOutcome::Refused);
    EXPECT_NE(session.message().find("world.gravity"), std::string::npos);
    EXPECT_EQ(session.params().world.gravity, small().world.gravity);
}

TEST(Session, ARunThatGoesWrongPausesAndSaysWhere) {
    World world = make_world(small());
    WorldState poisoned = world.snapshot();
    poisoned.sheets[0].velocity.y[50] = std::numeric_limits<double>::quiet_NaN();
    world.restore(poisoned);
    Session session(std::move(world), 1);
    session.play();
    session.advance(0.1);
    EXPECT_FALSE(session.playing());
    EXPECT_NE(session.message().find("stage springs, sheet 0, node"), std::string::npos)
        << session.message();
    session.play();
    EXPECT_FALSE(session.playing()) << "only an edit or a restart helps";
    session.restart();
    session.play();
    session.advance(0.1);
    EXPECT_TRUE(session.playing());
    EXPECT_TRUE(session.message().empty());
}

TEST(Session, TheRevisionChangesWheneverTheWorldMayLookDifferent) {
    Session session(small(), 1);
    std::uint64_t before = session.revision();
    const auto changed = [&] { return std::exchange(before, session.revision()) != before; };
    session.step_once();
    EXPECT_TRUE(changed());
    EXPECT_EQ(session.apply(session.params()), EditOutcome::Unchanged);
    EXPECT_FALSE(changed());
    Params moved = session.params();
    moved.lighter.x += 0.01;
    session.apply(moved);
    EXPECT_TRUE(changed());
    session.restart();
    EXPECT_TRUE(changed());
}

}  // namespace
}  // namespace ember
