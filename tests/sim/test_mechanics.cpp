// The right-hand side: every kernel, any number of threads, any span of rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rig.h"
#include "sim/random.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

double random_in(double low, double high, std::uint64_t index) {
    return low + (high - low) * random_uniform(7, RandomUse::Waviness, 1, index);
}

// A rumpled, moving sheet in the air.
Rig rumpled(int rows, int columns, SheetShape shape = SheetShape::Flat) {
    Params p = plain(rows, columns);
    p.sheet.shape = shape;
    p.world.gravity = 9.81;
    p.world.air_drag = 0.3;
    p.springs.variation = 0.1;
    Rig rig(p);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        const auto id = static_cast<std::uint64_t>(8 * n);
        rig.sheet.position.set(
            n, rig.sheet.position.at(n) + 0.004 * Vector3(random_in(-1, 1, id),
                                                          random_in(-1, 1, id + 1),
                                                          random_in(-1, 1, id + 2)));
        rig.sheet.velocity.set(n, Vector3(random_in(-1, 1, id + 3), random_in(-1, 1, id + 4),
                                          random_in(-1, 1, id + 5)));
    }
    gather_loads(rig.params, rig.sheet, {}, rig.loads);
    return rig;
}

void cut_here_and_there(Rig& rig) {
    for (Index site = 7; site < rig.lattice.site_count(); site += 11) {
        cut_site(rig.lattice, rig.sheet, site,
                 site % 2 == 0 ? CutLine::AlongMain : CutLine::AlongCross);
    }
    rig.refresh();
}

struct Rates {
    std::vector<double> a;
    LostPower lost;
};

Rates rates(Rig& rig, const SpringKernel& kernel, bool leaps = false) {
    Motion motion;
    motion.read(rig.sheet);
    Rates out;
    out.a.assign(3 * rig.sheet.mass.size(), 0.0);
    Mechanics m = rig.mechanics();
    m.kernel = kernel;
    const double *x = motion.x.data(), *v = motion.v.data();
    if (leaps) {  // of a second, in which w + mean a is v, and whose kicks show in w - u
        std::vector<double> ahead = motion.v;
        const std::vector<double> before = motion.v;
        prepare_leaps(m, x, ahead.data());
        out.lost = leap(m, {motion.x.data(), motion.v.data(), ahead.data(), 1.0, 1.0, -1.0, 0.0});
        for (std::size_t i = 0; i < out.a.size(); ++i)
            out.a[i] = motion.v[i] - before[i];
    } else {
        out.lost = accelerate(m, x, v, out.a.data());
    }
    return out;
}

void expect_same(const Rates& p, const Rates& q) {
    EXPECT_EQ(p.a, q.a);
    EXPECT_EQ(p.lost.damping, q.lost.damping);
    EXPECT_EQ(p.lost.drag, q.lost.drag);
}

TEST(SpringKernel, EveryWidthComputesTheSameBits) {
    const SpringKernel narrow = spring_kernel_of_width(2);
    int compared = 0;
    for (const int lanes : {4, 8}) {
        const SpringKernel wide = spring_kernel_of_width(lanes);
        if (wide.evaluate == nullptr) continue;  // not on this processor
        for (const int columns : {1, 2, 6, 7, 8, 13, 47}) {
            for (const bool leaps : {false, true}) {
                Rig rig = rumpled(5, columns);
                cut_here_and_there(rig);
                expect_same(rates(rig, narrow, leaps), rates(rig, wide, leaps));
                ++compared;
            }
        }
    }
#ifdef __x86_64__
    EXPECT_GT(compared + (spring_kernel_of_width(4).evaluate == nullptr ? 1 : 0), 0);
#endif
}

TEST(SpringKernel, TheFastOneDiffersByRoundingOnly) {
    const SpringKernel fast = spring_kernel_of_width(0);
    if (fast.evaluate == nullptr) GTEST_SKIP() << "this processor has none";
    Rig rig = rumpled(20, 31);
    const Rates exact = rates(rig, spring_kernel_of_width(2)), quick = rates(rig, fast);
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < exact.a.size(); ++i) {
        largest = std::max(largest, std::abs(exact.a[i]));
        difference = std::max(difference, std::abs(exact.a[i] - quick.a[i]));
    }
    EXPECT_LT(difference, 1e-13 * largest);
    EXPECT_GT(difference, 0);  // it is another path
    EXPECT_NEAR(quick.lost.damping / exact.lost.damping, 1.0, 1e-13);
}

TEST(SpringKernel, NodesInOnePlacePullAtNothing) {
    Rig rig(plain(3, 5));
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
        rig.sheet.position.set(n, Vector3(0.1, 0.2, 0.3));
    for (const int lanes : {0, 2, 4, 8}) {
        const SpringKernel kernel = spring_kernel_of_width(lanes);
        if (kernel.evaluate == nullptr) continue;
        for (const double a : rates(rig, kernel).a)
            EXPECT_EQ(a, 0.0);
    }
}

TEST(Mechanics, ALeapKicksByTheAccelerationsAndLosesThePower) {
    for (const SheetShape shape : {SheetShape::Flat, SheetShape::Cylinder}) {
        Rig rig = rumpled(9, 17, shape);
        cut_here_and_there(rig);
        const SpringKernel kernel = spring_kernel(Arithmetic::Exact);
        const Rates leapt = rates(rig, kernel, true), right = rates(rig, kernel);
        double largest = 0.0, difference = 0.0;
        for (std::size_t i = 0; i < right.a.size(); ++i) {
            largest = std::max(largest, std::abs(right.a[i]));
            difference = std::max(difference, std::abs(leapt.a[i] - right.a[i]));
        }
        EXPECT_LT(difference, 1e-15 * largest);  // rounding of v + a - v
        // found at the nodes, and at the springs
        EXPECT_NEAR(leapt.lost.damping / right.lost.damping, 1.0, 1e-13);
        EXPECT_NEAR(leapt.lost.drag / right.lost.drag, 1.0, 1e-13);
    }
}

// Some leaps of the spans of a sheet, in place or with every array apart.
Motion leaps(Rig& rig, bool in_place) {
    Motion motion;
    motion.read(rig.sheet);
    std::vector<double> u = motion.v, a(3 * rig.sheet.mass.size(), 0.0);
    const Mechanics m = rig.mechanics();
    prepare_leaps(m, motion.x.data(), u.data());
    for (int step = 0; step < 4; ++step) {
        const Leap leap_of{motion.x.data(), motion.v.data(), u.data(), 2e-4, 3e-4, 1e-4, 1e-4};
        if (in_place) {
            (void)leap(m, leap_of);
            continue;
        }
        (void)accelerate(m, motion.x.data(), u.data(), a.data());
        for (std::size_t i = 0; i < a.size(); ++i) {
            motion.v[i] += leap_of.kick * a[i];
            motion.x[i] += leap_of.drift * motion.v[i];
            u[i] = motion.v[i] + leap_of.lead * a[i];
        }
    }
    return motion;
}

void expect_in_place(Rig& rig) {
    const Motion expected = leaps(rig, false);
    for (const int threads : {1, 2, 3, 5}) {
        rig.pool = std::make_unique<ThreadPool>(threads);
        const Motion moved = leaps(rig, true);
        EXPECT_EQ(moved.x, expected.x) << threads << " threads";
        EXPECT_EQ(moved.v, expected.v);
    }
}

TEST(Mechanics, RowsAreMovedInPlaceAsIfAllWereMovedAtOnce) {
    for (const SheetShape shape : {SheetShape::Flat, SheetShape::Cylinder}) {
        Rig rig = rumpled(70, 61, shape);
        cut_here_and_there(rig);
        expect_in_place(rig);
        // with rows at rest between those that move
        rig.whole = {{1, 30}, {31, 33}, {36, rig.lattice.row_count}};
        for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
            const Index row = rig.lattice.row_of(rig.sheet.site[n]);
            if (row == 0 || row == 30 || (row > 32 && row < 36))
                rig.sheet.velocity.set(n, Vector3::Zero());
        }
        expect_in_place(rig);
    }
}

TEST(Mechanics, EvenThreeRowsOfATubeAreMovedInPlace) {
    for (const int rows : {3, 4, 5, 6, 7}) {
        // long enough to be shared out between threads
        Rig rig = rumpled(rows, 1000, SheetShape::Cylinder);
        ASSERT_GT(rig.lattice.row_count * rig.lattice.column_count * kKinds, 16384);
        expect_in_place(rig);
    }
}

TEST(Mechanics, TheNumberOfThreadsChangesNoBit) {
    for (const SheetShape shape : {SheetShape::Flat, SheetShape::Cylinder}) {
        Rig rig = rumpled(70, 61, shape);
        cut_here_and_there(rig);
        const Rates one = rates(rig, spring_kernel(Arithmetic::Exact), true);
        for (const int threads : {2, 3, 5}) {
            rig.pool = std::make_unique<ThreadPool>(threads);
            expect_same(one, rates(rig, spring_kernel(Arithmetic::Exact), true));
        }
    }
}

TEST(Mechanics, ASpanOfRowsIsMovedAsIfAllWere) {
    Rig rig = rumpled(12, 9);
    const Rates all = rates(rig, spring_kernel(Arithmetic::Exact));
    rig.whole = {{2, 5}, {9, 13}};
    const Rates some = rates(rig, spring_kernel(Arithmetic::Exact));
    const std::size_t nodes = rig.sheet.mass.size();
    for (std::size_t i = 0; i < all.a.size(); ++i) {
        const Index row = rig.lattice.row_of(static_cast<Index>(i % nodes));
        const bool moved = (row >= 2 && row < 5) || row >= 9;
        EXPECT_EQ(some.a[i], moved ? all.a[i] : 0.0);
    }
}

}  // namespace
}  // namespace ember
