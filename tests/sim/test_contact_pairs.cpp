// The parts of contact one by one: who is near whom, where two things meet, what impulses they
// need.
#include <gtest/gtest.h>

#include <random>
#include <set>
#include <tuple>

#include "random_sheet.h"
#include "sim/contact_geometry.h"
#include "sim/contact_pairs.h"
#include "sim/contact_solver.h"

namespace ember {
namespace {

using Key = std::tuple<Index, Index, Index, Index>;

// Moves a sheet somewhere near the origin, with velocities of a few cells per tick.
void throw_about(test::Rig& rig, test::Dice& dice) {
    const Vector3 place = dice.vector(0.05);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        rig.sheet.position.set(n, rig.sheet.position.at(n) - Vector3(0, 0.45, 0) + place);
        rig.sheet.velocity.set(n, dice.vector(2.0));
    }
}

TEST(ContactPairs, AreAllWhoseBoxesMeetAndNoOthers) {
    constexpr double kTick = 1.0 / 60, kThickness = 0.002, kFall = 0.001;
    std::size_t pairs = 0;
    for (std::uint64_t trial = 0; trial < 30; ++trial) {
        test::Dice dice(trial);
        std::vector<test::Rig> rigs;
        for (int s = 0; s < 3; ++s) {
            rigs.emplace_back(test::random_params(dice));
            test::burn_and_cut(rigs.back(), dice);
            test::crumple(rigs.back(), dice);
            throw_about(rigs.back(), dice);
        }
        std::vector<SheetInSpace> sheets;
        for (const test::Rig& rig : rigs)
            sheets.push_back({&rig.lattice, &rig.sheet});
        Params p;
        NearThings near;
        StepCounters counters;
        find_near(p, kTick, kThickness, kFall, sheets, near, counters);
        std::set<Key> found;
        for (const NearPair& pair : near.pairs)
            EXPECT_TRUE(found.insert({pair.sheet, pair.node, pair.other, pair.quad}).second);
        std::set<Key> expected;
        for (std::size_t s = 0; s < 3; ++s) {
            for (std::size_t o = 0; o < 3; ++o) {
                for (std::size_t n = 0; s != o && n < rigs[s].sheet.mass.size(); ++n) {
                    for (std::size_t q = 0; q < rigs[o].sheet.quads.size(); ++q) {
                        if (overlap(swept_by_node(rigs[s].sheet, n, kTick),
                                    swept_by_quad(rigs[o].sheet, q, kTick), kThickness + kFall)) {
                            expected.insert({static_cast<Index>(s), static_cast<Index>(n),
                                             static_cast<Index>(o), static_cast<Index>(q)});
                        }
                    }
                }
            }
        }
        EXPECT_EQ(found, expected) << "trial " << trial;
        pairs += expected.size();
    }
    EXPECT_GT(pairs, 1000u);
}

const std::array<Path, 3> kFloor = {Path{{0, 0, 0}, {0, 0, 0}}, Path{{0, 0, 1}, {0, 0, 1}},
                                    Path{{1, 0, 0}, {1, 0, 0}}};

TEST(ContactGeometry, ANodeMeetsTheTriangleItFallsOntoFromItsOwnSide) {
    Touch touch;
    const Path down = {{0.25, 0.3, 0.5}, {0.25, -0.5, 0.5}};
    ASSERT_TRUE(meet(down, kFloor, 0.1, 0.01, false, touch));
    EXPECT_NEAR(touch.gap, 0.2, 1e-15);
    EXPECT_LT((touch.normal - Vector3::UnitY()).norm(), 1e-15);
    EXPECT_NEAR(touch.weight[1], -0.25, 1e-15);
    EXPECT_NEAR(touch.weight[2], -0.5, 1e-15);
    EXPECT_NEAR(touch.weight[3], -0.25, 1e-15);
    const Path up = {{0.25, -0.3, 0.5}, {0.25, 0.5, 0.5}};
    ASSERT_TRUE(meet(up, kFloor, 0.1, 0.01, false, touch));
    EXPECT_LT((touch.normal + Vector3::UnitY()).norm(), 1e-15);
    const Path beside = {{0.9, 0.3, 0.9}, {0.9, -0.5, 0.9}};
    EXPECT_FALSE(meet(beside, kFloor, 0.1, 0.01, false, touch));
    const Path slow = {{0.25, 0.3, 0.5}, {0.25, 0.21, 0.5}};
    EXPECT_FALSE(meet(slow, kFloor, 0.1, 0.01, false, touch)) << "less than half of the gap";
}

TEST(ContactGeometry, EdgesMeetWhereTheyCrossOnly) {
    Touch touch;
    const std::array<Path, 2> low = {Path{{0, 0, -1}, {0, 0, -1}}, Path{{0, 0, 1}, {0, 0, 1}}};
    const auto falling_at = [](double x, double z) {
        return std::array<Path, 2>{Path{{x, 0.2, z}, {x, -0.1, z}},
                                   Path{{x + 1, 0.2, z}, {x + 1, -0.1, z}}};
    };
    ASSERT_TRUE(meet(falling_at(-0.25, 0.5), low, 0.1, 0.01, false, touch));
    EXPECT_NEAR(touch.gap, 0.1, 1e-15);
    EXPECT_LT((touch.normal - Vector3::UnitY()).norm(), 1e-15);
    const std::array<double, 4> weights = {0.75, 0.25, -0.25, -0.75};
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(touch.weight[k], weights[k], 1e-15);
    EXPECT_FALSE(meet(falling_at(0.1, 0.5), low, 0.1, 0.01, false, touch));
    EXPECT_FALSE(meet(falling_at(-0.25, 1.1), low, 0.1, 0.01, false, touch));
    EXPECT_FALSE(meet(low, low, 0.1, 0.01, false, touch)) << "parallel";
}

// Two bodies, one contact between them: the relative velocity along the normal ends at `least`, and
// friction is Coulomb's.
TEST(ContactSolver, AnImpulseIsTheReducedMassTimesTheChangeAndFrictionIsBounded) {
    for (const double friction : {0.0, 0.2, 5.0}) {
        ContactBodies bodies;
        bodies.inverse_mass = {1 / 2.0, 1 / 3.0};
        bodies.velocity = {{1, -2, 0}, {0, 1, 0}};
        Contact c{.body = {0, 1, 0, 0},
                  .weight = {1, -1, 0, 0},
                  .normal = Vector3::UnitY(),
                  .least = -0.5,
                  .friction = friction};
        std::vector<Contact> contacts = {c};
        solve_contacts(contacts, bodies);
        const double reduced = 1 / (1 / 2.0 + 1 / 3.0);
        EXPECT_NEAR(bodies.impulse[0].y(), reduced * 2.5, 1e-12);
        const double rubbed = std::min(friction * reduced * 2.5, reduced * 1.0);
        EXPECT_NEAR(bodies.impulse[0].x(), -rubbed, 1e-12);
        EXPECT_EQ(bodies.impulse[0], -bodies.impulse[1]);
    }
}

// A triangle of which only the far corner can be moved, and a node that cannot.
TEST(ContactSolver, NothingIsFlungOutByALongLever) {
    ContactBodies bodies;
    bodies.inverse_mass = {0, 0, 0, 1e6};
    bodies.velocity.assign(4, Vector3::Zero());
    std::vector<Contact> contacts = {{.body = {0, 1, 2, 3},
                                      .weight = {1, -0.5, -0.49, -0.01},
                                      .normal = Vector3::UnitY(),
                                      .least = 1.0}};
    solve_contacts(contacts, bodies);
    EXPECT_NEAR(bodies.velocity[3].y(), -1.0, 1e-12);
}

// Bodies caught between others that cannot give way, so that not all contacts can have their way.
TEST(ContactSolver, WhatIsCaughtGetsNoMoreEnergyThanItTakesToComeOut) {
    std::mt19937 random(1);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    double most = 0;
    for (int trial = 0; trial < 200; ++trial) {
        ContactBodies bodies;
        for (int b = 0; b < 10; ++b)
            bodies.inverse_mass.push_back(b < 4 ? 0.0 : 1 + 9 * uniform());
        bodies.velocity.assign(10, Vector3::Zero());
        std::vector<Contact> contacts;
        for (int c = 0; c < 40; ++c) {
            Contact contact{.body = {}, .weight = {1, -uniform(), 0, 0}, .normal = {}};
            contact.weight[2] = -1 - contact.weight[1];
            for (Index& body : contact.body)
                body = static_cast<Index>(random() % 10);
            contact.normal =
                Vector3(uniform() - 0.5, uniform() - 0.5, uniform() - 0.5).normalized();
            contact.least = uniform();
            contact.friction = uniform();
            contact.guess = 100 * uniform() * contact.normal;  // from an interval that went wrong
            contacts.push_back(contact);
        }
        solve_contacts(contacts, bodies);
        double allowed = 0, kinetic = 0;
        for (const Contact& c : contacts)
            allowed += 4 * c.mass * c.least * c.least;
        for (std::size_t b = 4; b < 10; ++b)
            kinetic += 0.5 / bodies.inverse_mass[b] * bodies.velocity[b].squaredNorm();
        EXPECT_LE(kinetic, allowed * (1 + 1e-12));
        most = std::max(most, kinetic / allowed);
    }
    EXPECT_GT(most, 1 - 1e-9);  // some of them would have had more
}

TEST(ContactSolver, AnApproachDiesOutWithoutABounceAndNeverUsesUpTheGap) {
    constexpr double kInterval = 1e-3;
    for (const double first_gap : {0.0019, 0.0012, 0.0007}) {
        double gap = first_gap, speed = -1.0;
        for (int i = 0; i < 40; ++i) {
            const double next = std::max(speed, least_speed(gap, speed, kInterval, 1e-3));
            EXPECT_LE(next, 0.0);
            gap += 0.5 * (speed + next) * kInterval;
            speed = next;
            EXPECT_GT(gap, 0.0);
        }
        EXPECT_LT(gap, 1e-6);
    }
}

}  // namespace
}  // namespace ember
