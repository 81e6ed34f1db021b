// A session on its own thread: what others see of it, and when.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "ui/session_thread.h"

namespace ember {
namespace {

Params small() {
    Params p;
    p.sheet.rows = 8;
    p.sheet.columns = 12;
    return p;
}

// Waits until `done` says so, for at most ten seconds.
template <class Done>
bool wait_for(Done&& done) {
    for (int i = 0; i < 2000; ++i) {
        if (done()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

TEST(SessionThread, PlaysByItselfAndStopsWhenTold) {
    std::atomic<int> woken = 0;
    SessionThread session(small(), 1, [&] { ++woken; });
    EXPECT_EQ(session.latest()->stats.tick, 0u);
    session.post([](Session& s) { s.play(); });
    ASSERT_TRUE(wait_for([&] { return session.latest()->stats.tick > 10; }));
    session.call([](Session& s) { s.pause(); });
    const auto paused = session.latest();
    EXPECT_FALSE(paused->playing);
    EXPECT_GT(woken, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
    EXPECT_EQ(session.latest(), paused) << "nothing is published while nothing happens";
}

TEST(SessionThread, ASnapshotStaysAsItIsWhileTheBurnGoesOn) {
    SessionThread session(small(), 1);
    session.call([](Session& s) { s.step_once(); });
    const auto first = session.latest();
    const double y = first->view.sheets[0].y[60];
    EXPECT_EQ(first->view.sheets[0].y.data(), first->state->sheets[0].position.y.data());
    session.call([](Session& s) {
        for (int i = 0; i < 50; ++i)
            s.step_once();
    });
    EXPECT_EQ(first->view.sheets[0].y[60], y);
    EXPECT_NE(session.latest()->view.sheets[0].y[60], y);
    EXPECT_EQ(session.latest()->commands, 2u);
}

TEST(SessionThread, EditsComeInOrderAndAreSeenTogetherWithTheirState) {
    SessionThread session(small(), 1);
    session.call([](Session& s) { s.step_once(); });
    Params p = small();
    for (int i = 1; i <= 20; ++i) {
        p.wind.x = i;
        session.post([p](Session& s) { s.apply(p); });
    }
    session.call([](Session&) {});
    EXPECT_EQ(session.latest()->params.wind.x, 20);
    EXPECT_EQ(session.latest()->script->size(), 1u);
}

TEST(SessionThread, TwoBurnInLockStep) {
    SessionThread session(small(), 1);
    session.call([](Session& s) {
        for (int i = 0; i < 30; ++i)
            s.step_once();
    });
    Params other = small();
    other.paper.grammage *= 2;
    session.put_beside(other);
    ASSERT_TRUE(wait_for([&] {
        const auto shot = session.latest();
        return shot->beside != nullptr && shot->beside->stats.tick == 30;
    }));
    World alone = make_world(other);
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(alone.step().ok());
    EXPECT_EQ(session.latest()->beside->hash, alone.hash());
    session.call([](Session& s) { s.go_to(12); });
    ASSERT_TRUE(wait_for([&] { return session.latest()->beside->stats.tick == 12; }));
    session.put_beside(std::nullopt);
    ASSERT_TRUE(wait_for([&] { return session.latest()->beside == nullptr; }));
}

}  // namespace
}  // namespace ember
