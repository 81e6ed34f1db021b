// A tick works in memory that is there already. An executable of its own, because it replaces the
// operators new and delete by ones that count; they work under sanitizers, which look at malloc.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include "sim/parallel.h"
#include "sim/world.h"
#include "tests/sim/small_sheet.h"

namespace {

std::atomic<std::int64_t> allocations = 0;

void* counted(void* memory) {
    ++allocations;
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

void* aligned(std::size_t size, std::align_val_t alignment) {
    const auto unit = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(unit, (size + unit - 1) / unit * unit));
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(std::malloc(size));
}
void* operator new[](std::size_t size) {
    return counted(std::malloc(size));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return aligned(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return aligned(size, alignment);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace ember {
namespace {

using test::small_sheet;

// Remembers the most of everything.
class Most {
  public:
    // Whether there are more particles, or is more work of any kind, than ever before.
    bool exceeded_by(const StepCounters& counters, std::size_t particles) {
        bool larger = false;
        std::size_t at = 0;
        const auto compare = [&](std::int64_t count) {
            larger |= count > most_[at];
            most_[at] = std::max(most_[at], count);
            ++at;
        };
        compare(static_cast<std::int64_t>(particles));
        for_each_counter(counters, [&](const char*, std::int64_t count) { compare(count); });
        return larger;
    }

  private:
    std::array<std::int64_t, 64> most_{};
};

// Allocations in the ticks after a warm-up without a cut or a retry in them or in the tick before,
// in which whatever depends on the number of nodes is made anew.
struct Outcome {
    std::int64_t grown = 0;   // where something is more than ever before
    std::int64_t steady = 0;  // in all others
    int steady_ticks = 0;
    double particles = 1;  // most there were, over those at the end of the warm-up
};

Outcome burn(const Params& params, int threads) {
    constexpr int kWarmUp = 30, kTicks = 360;
    World world = make_world(params, threads);
    Outcome outcome;
    Most most;
    bool was_calm = true;
    std::size_t warm = 1;
    for (int i = 0; i < kTicks; ++i) {
        const std::int64_t before = allocations;
        const StepReport report = world.step();
        const std::int64_t made = allocations - before;
        EXPECT_TRUE(report.ok()) << report.reason;
        const std::size_t particles = world.state().fire.size();
        const bool calm = report.counters.cuts == 0 && report.retries == 0;
        const bool larger = most.exceeded_by(report.counters, particles);
        if (i < kWarmUp) warm = particles;
        if (i >= kWarmUp && calm && was_calm) {
            (larger ? outcome.grown : outcome.steady) += made;
            outcome.steady_ticks += larger ? 0 : 1;
        }
        outcome.particles =
            std::max(outcome.particles, static_cast<double>(particles) / static_cast<double>(warm));
        was_calm = calm;
    }
    EXPECT_GT(world.state().totals.cuts, 0);
    return outcome;
}

void expect_little(const Params& params, int threads) {
    const Outcome outcome = burn(params, threads);
    EXPECT_EQ(outcome.steady, 0);
    EXPECT_GT(outcome.steady_ticks, 30);
    // each array that grows with the fire has doubled as often as the fire: 22 of the particles
    // now and before the tick, 12 of the grid, 6 of the coupling, 2 of burning and burnt nodes
    constexpr double kGrowing = 42;
    EXPECT_LE(static_cast<double>(outcome.grown),
              kGrowing * std::ceil(std::log2(outcome.particles)));
}

TEST(Allocation, AfterAWarmUpABurningCornerAllocatesOnlyWhatDoublesAsTheFireGrows) {
    for (const int threads : {1, 2})
        expect_little(small_sheet(), threads);
}

TEST(Allocation, NorDoesAnyHeatSolverOrIntegratorAllocate) {
    for (const HeatSolverKind solver : {HeatSolverKind::Rkl2, HeatSolverKind::Adi}) {
        SCOPED_TRACE(static_cast<int>(solver));
        Params p = small_sheet();
        p.numerics.heat_solver = solver;
        expect_little(p, 1);
    }
    for (const IntegratorKind integrator :
         {IntegratorKind::SemiImplicitEuler, IntegratorKind::Rk4, IntegratorKind::Dopri5,
          IntegratorKind::Rkf78, IntegratorKind::AdamsBashforthMoulton}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        Params p = small_sheet();
        p.numerics.integrator = integrator;
        expect_little(p, 1);
    }
}

TEST(Allocation, NorDoesAPlateNorTheImplicitIntegrator) {
    for (const IntegratorKind integrator :
         {IntegratorKind::VelocityVerlet, IntegratorKind::Rosenbrock}) {
        SCOPED_TRACE(static_cast<int>(integrator));
        Params p = small_sheet();
        p.plate.rigidity_main = p.plate.rigidity_cross = 1e-5;
        p.numerics.integrator = integrator;
        p.numerics.tolerance = 1e-3;
        expect_little(p, 1);
    }
}

TEST(Allocation, NorDoesPaperThatTouchesTheGroundAndPaperOnceItHasBeenInTouch) {
    Params p = small_sheet();
    p.lighter.on = false;
    p.sheet.rows = 6, p.sheet.columns = 8;
    p.sheet.width = 0.06, p.sheet.height = 0.08;
    p.sheet.held = HeldEdge::None;
    p.sheet.pose = SheetPose::Horizontal;
    p.sheet.elevation = 0.03;
    p.sheet.count = 3;
    p.sheet.gap = 0.01;
    p.contact.self = true;
    World world = make_world(p);
    Most most;
    std::int64_t grown = 0, steady = 0;
    int steady_ticks = 0;
    for (int i = 0; i < 90; ++i) {
        const std::int64_t before = allocations;
        const StepReport report = world.step();
        const std::int64_t made = allocations - before;
        EXPECT_TRUE(report.ok()) << report.reason;
        const bool larger = most.exceeded_by(report.counters, 0);
        (larger ? grown : steady) += made;
        steady_ticks += !larger && report.counters.contacts > 0 ? 1 : 0;
    }
    EXPECT_GT(grown, 0);
    EXPECT_EQ(steady, 0);
    EXPECT_GT(steady_ticks, 30);
}

TEST(Allocation, ALoopAllocatesNothingWhateverItsBodyRefersTo) {
    ThreadPool pool(3);
    std::array<std::int64_t, 32> added{};  // too much to be kept in a std::function
    std::array<std::int64_t, 300> sums{};
    const std::int64_t before = allocations;
    pool.for_rows(300, 1000, [&sums, added](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t i = begin; i < end; ++i)
            sums[static_cast<std::size_t>(i)] += 1 + added[static_cast<std::size_t>(i % 32)];
    });
    EXPECT_EQ(allocations, before);
    EXPECT_EQ(std::count(sums.begin(), sums.end(), 1), 300);
}

TEST(Allocation, IsCounted) {
    const std::int64_t before = allocations;
    std::vector<double> one(10);
    one.resize(1000);
    EXPECT_EQ(allocations, before + 2);
}

}  // namespace
}  // namespace ember
