// Forces and steps of the simulation against the plain implementation in tests/reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rig.h"
#include "sim/random.h"
#include "sim/topology.h"
#include "swing.h"
#include "tests/reference/mass_spring.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

double random_in(double low, double high, std::uint64_t index) {
    return low + (high - low) * random_uniform(7, RandomUse::Waviness, 1, index);
}

struct Variant {
    const char* name;
    SheetShape shape = SheetShape::Flat;
    Border border = Border::Tributary;
    HeldEdge held = HeldEdge::None;
    double air_drag = 0;
    int cuts = 0;
    bool follows_mass = true;
    int rows = 7, columns = 11;
};

std::ostream& operator<<(std::ostream& out, const Variant& variant) {
    return out << variant.name;
}

// A sheet whose nodes are burnt, moved and set in motion at random, with cuts.
Rig disturbed(const Variant& v, std::uint64_t trial) {
    Params p = plain(v.rows, v.columns);
    p.sheet.shape = v.shape;
    p.sheet.border = v.border;
    p.sheet.held = v.held;
    p.springs.variation = 0.1;
    p.springs.follows_mass = v.follows_mass;
    p.springs.stiffness_scale = 3;
    p.world.gravity = 9.81;
    p.world.held_gravity = 0.2;
    p.world.air_drag = v.air_drag;
    Rig rig(p);
    SheetState& sheet = rig.sheet;
    const std::uint64_t base = 100000 * trial;
    for (int cut = 0; cut < v.cuts; ++cut) {
        const auto id = base + 50000 + 2 * static_cast<std::uint64_t>(cut);
        const auto site = static_cast<Index>(random_in(0, rig.lattice.site_count() - 0.01, id));
        const bool main = random_in(0, 1, id + 1) < 0.5;
        cut_site(rig.lattice, sheet, site, main ? CutLine::AlongMain : CutLine::AlongCross);
    }
    (void)find_pieces(sheet);
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        const std::uint64_t id = base + 10 * n;
        const auto random = [&](double size, std::uint64_t k) {
            return Vector3(random_in(-size, size, id + k), random_in(-size, size, id + k + 1),
                           random_in(-size, size, id + k + 2));
        };
        sheet.position.set(n, sheet.position.at(n) + random(0.004, 0));
        sheet.velocity.set(n, random(0.5, 3));
        sheet.mass[n] *= random_in(0.2, 1.0, id + 6);
    }
    for (double& l : sheet.rest_length)
        l *= random_in(0.7, 1.0,
                       base + 70000 + static_cast<std::uint64_t>(&l - sheet.rest_length.data()));
    rig.refresh();
    return rig;
}

class Reference : public testing::TestWithParam<Variant> {};

TEST_P(Reference, HasTheSameAccelerationsToRounding) {
    double worst = 0;
    std::size_t copies = 0;
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        Rig rig = disturbed(GetParam(), trial);
        const std::size_t n = rig.sheet.mass.size();
        copies += n - static_cast<std::size_t>(rig.lattice.site_count());
        Motion motion;
        motion.read(rig.sheet);
        std::vector<double> ours(3 * n);
        (void)accelerate(rig.mechanics(), motion.x.data(), motion.v.data(), ours.data());
        const auto plain_sheet = reference::make_mass_springs(rig.lattice, rig.sheet, rig.params);
        std::vector<Vector3> theirs;
        reference::accelerations(plain_sheet, theirs);
        double largest = 0, difference = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Vector3 a(ours[i], ours[n + i], ours[2 * n + i]);
            largest = std::max(largest, theirs[i].norm());
            difference = std::max(difference, (a - theirs[i]).norm());
        }
        ASSERT_GT(largest, 1.0);
        worst = std::max(worst, difference / largest);
    }
    EXPECT_LE(worst, 1e-12);
    EXPECT_EQ(copies > 0, GetParam().cuts > 0) << "cuts must have opened the sheet";
}

INSTANTIATE_TEST_SUITE_P(
    Sheets, Reference,
    testing::Values(
        Variant{.name = "flat"}, Variant{.name = "uniform", .border = Border::Uniform},
        Variant{.name = "held", .held = HeldEdge::MainStart},
        Variant{.name = "drag", .air_drag = 0.3}, Variant{.name = "cuts", .cuts = 25},
        Variant{.name = "uniform_cuts", .border = Border::Uniform, .cuts = 25},
        Variant{.name = "cylinder", .shape = SheetShape::Cylinder},
        Variant{.name = "smallest_cylinder", .shape = SheetShape::Cylinder, .rows = 3},
        Variant{.name = "cylinder_cuts_drag",
                .shape = SheetShape::Cylinder,
                .border = Border::Uniform,
                .held = HeldEdge::MainEnd,
                .air_drag = 0.3,
                .cuts = 25},
        Variant{.name = "literal", .follows_mass = false},
        Variant{.name = "one_quad", .rows = 1, .columns = 1},
        Variant{.name = "held_cuts_drag", .held = HeldEdge::CrossEnd, .air_drag = 0.3, .cuts = 40}),
    [](const auto& variant) { return std::string(variant.param.name); });

TEST(ReferenceSwing, IsFollowedByTheSimulationToRounding) {
    Rig rig(test::swing());
    auto theirs = reference::make_mass_springs(rig.lattice, rig.sheet, rig.params);
    constexpr int kSteps = 100;
    constexpr double kStep = 0.0025;
    double moved = 0, worst = 0;
    (void)rig.run(kSteps * kStep, kSteps);
    for (int step = 0; step < kSteps; ++step)
        reference::step_runge_kutta(theirs, kStep);
    for (std::size_t i = 0; i < theirs.nodes.size(); ++i) {
        moved = std::max(moved, -rig.sheet.position.y[i] + rig.sheet.position.y[0]);
        worst = std::max(worst, (rig.sheet.position.at(i) - theirs.nodes[i].position).norm());
    }
    EXPECT_GT(moved, 0.1) << "[m] that the free end has fallen";
    EXPECT_LE(worst, 1e-12);
}

}  // namespace
}  // namespace ember
