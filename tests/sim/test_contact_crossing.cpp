// Contact: nothing passes through anything, neither in stacks nor in folds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "crossing.h"
#include "falling_sheets.h"
#include "sim/contact.h"

namespace ember {
namespace {

using test::falling;
using test::four_places;
using test::kGravity;
using test::run;
using test::world_of;

// Least height of a node of one sheet over the quad of another that lies below or above it.
double least_gap(const SheetState& upper, const SheetState& lower) {
    double least = 1;
    for (std::size_t n = 0; n < upper.mass.size(); ++n) {
        const Vector3 p = upper.position.at(n);
        for (const Quad& quad : lower.quads) {
            const auto corner = [&](std::size_t k) {
                return lower.position.at(static_cast<std::size_t>(quad[k]));
            };
            for (const std::size_t k : {std::size_t{1}, std::size_t{2}}) {
                const Vector3 a = corner(0), u = corner(k) - a, v = corner(k + 1) - a, w = p - a;
                const double area = u.x() * v.z() - u.z() * v.x();
                const double s = (w.x() * v.z() - w.z() * v.x()) / area;
                const double t = (u.x() * w.z() - u.z() * w.x()) / area;
                if (s < 0 || t < 0 || s + t > 1) continue;
                least = std::min(least, w.y() - s * u.y() - t * v.y());
            }
        }
    }
    return least;
}

TEST(Contact, AStackOfFallenSheetsLiesInOrderAndNothingHasPassedThrough) {
    Params p = falling();
    p.sheet.imperfection = 0.001;
    World world = world_of(p, four_places());
    while (world.state().time < 1.5) {
        run(world, 0.5 * world.tick_duration());
        ASSERT_EQ(test::count_crossings(world.state()), 0);
    }
    const double thickness = contact_thickness(p);
    for (std::size_t s = 1; s < 4; ++s)
        EXPECT_GT(least_gap(world.state().sheets[s], world.state().sheets[s - 1]), 0.9 * thickness);
    EXPECT_LT(world.state().energy.kinetic, 1e-9);
}

TEST(Contact, WithoutItTheSameSheetsPassThrough) {
    Params p = falling();
    p.sheet.imperfection = 0.001;
    p.contact.sheets = false;
    p.numerics.tick_rate = 240;  // a sheet of 0.1 mm passes another in a moment
    World world = world_of(p, four_places());
    int crossings = 0;
    while (world.state().time < 0.3) {
        run(world, 0.5 * world.tick_duration());
        crossings += test::count_crossings(world.state());
    }
    EXPECT_GT(crossings, 10);
    for (std::size_t s = 1; s < 4; ++s)
        EXPECT_LT(least_gap(world.state().sheets[s], world.state().sheets[s - 1]),
                  0.1 * contact_thickness(p));
}

// Bends a sheet into a U that lies on its side: columns run along two flat arms and half a circle.
void fold(World& world, double radius) {
    WorldState state = world.snapshot();
    SheetState& sheet = state.sheets[0];
    const int columns = world.scene().sheets[0].columns;
    const double spacing = world.scene().sheets[0].height / columns;
    const double arm = 0.5 * (columns * spacing - 3.14159265 * radius);
    const double bottom = 0.5 * contact_thickness(world.params());
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        const double s = spacing * (sheet.site[n] % (columns + 1));
        const double turn = std::clamp((s - arm) / radius, 0.0, 3.14159265);
        const double back = std::max(0.0, s - arm - 3.14159265 * radius);
        const double x = std::min(s, arm) + radius * std::sin(turn) - back;
        const double y = bottom + radius * (1 - std::cos(turn));
        sheet.position.set(n, Vector3(x, y, sheet.position.z[n]));
    }
    world.restore(std::move(state));
    static_cast<void>(world.apply(world.params()));
}

int most_crossings_of_a_fold(bool self) {
    Params p = test::plain(8, 30);
    p.world.gravity = kGravity;
    p.world.ground = true;
    p.springs.stiffness_scale = 40;
    p.contact.self = self;
    World world = world_of(p, {Vector3(0, 0.1, 0)});
    fold(world, 0.03);
    int most = 0;
    while (world.state().time < 1.0) {
        run(world, 0.5 * world.tick_duration());
        most = std::max(most, test::count_crossings(world.state()));
    }
    return most;
}

TEST(Contact, ASheetFoldedOntoItselfDoesNotPassThrough) {
    EXPECT_EQ(most_crossings_of_a_fold(true), 0);
}

TEST(Contact, WithoutSelfContactItDoes) {
    EXPECT_GT(most_crossings_of_a_fold(false), 0);
}

}  // namespace
}  // namespace ember
