// Going back in time, forking, and what is written down of it.
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "ui/session.h"

namespace ember {
namespace {

Params burning() {
    Params p;
    p.sheet.rows = 8;
    p.sheet.columns = 12;
    return p;
}

std::map<std::uint64_t, std::uint64_t> hashes_up_to(Session& session, std::uint64_t tick) {
    std::map<std::uint64_t, std::uint64_t> hashes{{session.tick_number(), session.hash()}};
    while (session.tick_number() < tick) {
        session.step_once();
        hashes[session.tick_number()] = session.hash();
    }
    return hashes;
}

TEST(TimeTravel, EveryTickIsThereAgainWhetherItWasKeptOrNot) {
    Session roomy(burning(), 1), tight(burning(), 1, 200'000);
    const auto hashes = hashes_up_to(roomy, 100);
    hashes_up_to(tight, 100);
    EXPECT_EQ(roomy.timeline().interval, 1u);
    EXPECT_GT(tight.timeline().interval, 1u);
    EXPECT_LE(tight.timeline().bytes, 200'000u);
    for (Session* session : {&roomy, &tight}) {
        for (const std::uint64_t tick : {37ull, 90ull, 0ull, 99ull, 100ull, 13ull}) {
            session->go_to(tick);
            EXPECT_EQ(session->tick_number(), tick);
            EXPECT_EQ(session->hash(), hashes.at(tick)) << "tick " << tick;
        }
        EXPECT_EQ(session->timeline().end, 100u) << "looking back forgets nothing";
        session->play();
        while (session->tick_number() < 100)
            session->advance(1.0 / 60);
        EXPECT_EQ(session->hash(), hashes.at(100));
    }
}

TEST(TimeTravel, AnEditForksAndTheLaterPastIsGone) {
    Session session(burning(), 1);
    const auto hashes = hashes_up_to(session, 60);
    session.go_to(30);
    Params p = session.params();
    p.paper.grammage *= 2;
    EXPECT_EQ(session.apply(p), EditOutcome::Live);
    EXPECT_EQ(session.tick_number(), 30u);
    EXPECT_EQ(session.timeline().end, 30u);
    EXPECT_EQ(session.timeline().edits, std::vector<std::uint64_t>{30});
    const auto forked = hashes_up_to(session, 60);
    EXPECT_NE(forked.at(60), hashes.at(60));
    session.go_to(20);
    EXPECT_EQ(session.hash(), hashes.at(20));
    EXPECT_EQ(session.params().paper.grammage, burning().paper.grammage);
    session.go_to(60);
    EXPECT_EQ(session.hash(), forked.at(60));
    EXPECT_EQ(session.params().paper.grammage, p.paper.grammage);
}

TEST(TimeTravel, WhatIsWrittenDownReplaysToTheSameState) {
    Session session(burning(), 1);
    hashes_up_to(session, 25);
    Params p = session.params();
    for (const double x : {0.01, 0.02, 0.03}) {  // a drag in one tick
        p.lighter.x = x;
        p.paper.grammage *= 1.1;
        session.apply(p);
    }
    EXPECT_EQ(session.script().size(), 1u) << "one edit";
    hashes_up_to(session, 40);
    p.wind.x = 1;
    session.apply(p);
    p.wind.x = 0;
    session.apply(p);
    EXPECT_EQ(session.script().size(), 1u) << "taken back at once";
    p.hand.on = true;
    p.hand.row = p.hand.column = 4;
    session.apply(p);
    hashes_up_to(session, 80);
    World replay = make_world(session.base());
    replay.set_script(session.base(), session.script());
    while (replay.state().tick < 80)
        ASSERT_TRUE(replay.step().ok());
    EXPECT_EQ(replay.hash(), session.hash());
}

TEST(TimeTravel, EditsBeforeTheFirstTickAreWhereTheBurnBegins) {
    Session session(burning(), 1);
    Params p = session.params();
    p.paper.c_s *= 3;
    EXPECT_EQ(session.apply(p), EditOutcome::Live);
    EXPECT_TRUE(session.script().empty());
    EXPECT_EQ(session.base().paper.c_s, p.paper.c_s);
}

TEST(TimeTravel, LoopsTheBurnSoFar) {
    Session session(burning(), 1);
    hashes_up_to(session, 10);
    session.set_loop(true);
    session.play();
    for (int i = 0; i < 25; ++i)
        session.advance(1.0 / 60 + 1e-9);
    EXPECT_EQ(session.timeline().end, 10u);
    EXPECT_LE(session.tick_number(), 10u);
}

TEST(TimeTravel, SpeedIsSimulatedTimePerTime) {
    Session session(burning(), 1);
    session.set_speed(0.25);
    session.play();
    for (int i = 0; i < 100; ++i)
        session.advance(0.02);
    EXPECT_NEAR(static_cast<double>(session.tick_number()), 0.5 * 60, 1.0);
}

TEST(TimeTravel, AStopIsRetriedWithASmallerStep) {
    World world = make_world(burning());
    WorldState poisoned = world.snapshot();
    poisoned.sheets[0].velocity.y[50] = std::numeric_limits<double>::quiet_NaN();
    world.restore(poisoned);
    Session session(std::move(world), 1);
    EXPECT_FALSE(session.retry_with_smaller_step()) << "nothing has stopped";
    session.step_once();
    EXPECT_TRUE(session.snapshot(false)->stopped);
    const double safety = session.params().numerics.safety;
    session.retry_with_smaller_step();
    EXPECT_EQ(session.params().numerics.safety, 0.5 * safety);
    EXPECT_FALSE(session.snapshot(false)->stopped);
}

TEST(StateCache, CountsWhatItHolds) {
    World world = make_world(burning());
    const std::size_t one = bytes_of(world.state());
    const std::size_t nodes = 9 * 13;
    EXPECT_GT(one, nodes * 11 * sizeof(double));
    StateCache cache(10 * one);
    for (std::uint64_t tick = 0; tick < 40; ++tick) {
        WorldState state = world.snapshot();
        state.tick = tick;
        cache.put(std::make_shared<const WorldState>(std::move(state)));
        EXPECT_LE(cache.bytes(), 10 * one);
    }
    EXPECT_EQ(cache.interval(), 4u);
    EXPECT_EQ(cache.at(20)->tick, 20u);
    EXPECT_EQ(cache.at(21), nullptr);
    EXPECT_EQ(cache.at_or_before(23)->tick, 20u);
    cache.drop_after(20);
    EXPECT_EQ(cache.at_or_before(100)->tick, 20u);
    EXPECT_EQ(cache.bytes(), cache.size() * one);
}

}  // namespace
}  // namespace ember
