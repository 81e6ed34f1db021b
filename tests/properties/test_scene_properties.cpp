// Paper has no left and right, no first and second, and no thread of its own.
#include <algorithm>
#include <set>

#include "../sim/random_sheet.h"
#include "property.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember {
namespace {

using test::Dice;
using test::expect_property;
using test::number_in;
using test::Rig;

// `sheet` seen in a mirror that its main direction lies in: row r is row R-1-r, and z is -z.
void mirror(const Lattice& lattice, const SheetState& sheet, SheetState& image) {
    for (Index row = 0; row < lattice.row_count; ++row) {
        for (Index column = 0; column < lattice.column_count; ++column) {
            const auto from = static_cast<std::size_t>(lattice.site(row, column));
            const auto to =
                static_cast<std::size_t>(lattice.site(lattice.row_count - 1 - row, column));
            const Vector3 flip(1, 1, -1);
            image.position.set(to, sheet.position.at(from).cwiseProduct(flip));
            image.velocity.set(to, sheet.velocity.at(from).cwiseProduct(flip));
            image.mass[to] = sheet.mass[from];
            image.held[to] = sheet.held[from];
        }
    }
}

TEST(SceneProperties, AMirroredSheetMovesAsTheMirrorImage) {
    expect_property([](std::uint64_t trial) {
        Dice dice(trial);
        Params p = test::random_params(dice);
        p.sheet.shape = SheetShape::Flat;
        p.springs.variation = 0;
        p.world.gravity = dice.in(0, 10);
        Rig rig(p), image(p), wanted(p);
        test::crumple(rig, dice);
        for (double& mass : rig.sheet.mass)
            mass *= dice.in(0.2, 1.0);
        mirror(rig.lattice, rig.sheet, image.sheet);
        rig.refresh(), image.refresh();
        const double dt = 0.5 / rig.fastest().rate();
        rig.run(dt, 20), image.run(dt, 20);
        mirror(rig.lattice, rig.sheet, wanted.sheet);
        for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
            const Vector3 error = image.sheet.position.at(n) - wanted.sheet.position.at(n);
            RC_ASSERT(error.norm() < 1e-10);
        }
    });
}

using Opening = std::pair<Index, unsigned>;  // a site, and which of its edges are opened

std::vector<Opening> any_openings(const Lattice& lattice) {
    constexpr unsigned kPairs[] = {0b0101, 0b1010, 0b0011, 0b0110, 0b1100, 0b1001};
    std::vector<Opening> openings(*rc::gen::inRange<std::size_t>(1, 60));
    for (Opening& opening : openings) {
        opening.first = *rc::gen::inRange<Index>(0, lattice.site_count());
        opening.second = kPairs[*rc::gen::inRange<std::size_t>(0, 6)];
    }
    return openings;
}

double mass_of(const SheetState& sheet) {
    double sum = 0;
    for (const double mass : sheet.mass)
        sum += mass;
    return sum;
}

TEST(SceneProperties, CutsKeepMassAndQuadsAndLeaveNoNodeAlone) {
    expect_property([](std::uint64_t trial) {
        Dice dice(trial);
        Rig rig(test::random_params(dice));
        const double mass = mass_of(rig.sheet);
        const std::size_t quads = rig.sheet.quads.size();
        for (const auto& [site, mask] : any_openings(rig.lattice)) {
            const std::size_t before = rig.sheet.mass.size();
            const Index added = open_site(rig.lattice, rig.sheet, site, mask);
            RC_ASSERT(rig.sheet.mass.size() == before + static_cast<std::size_t>(added));
        }
        rig.refresh();
        RC_ASSERT(rig.sheet.quads.size() == quads);
        RC_ASSERT(std::abs(mass_of(rig.sheet) / mass - 1) < 1e-12);
        std::set<Index> corners;
        for (std::size_t cell = 0; cell < quads; ++cell) {
            const Quad& quad = rig.sheet.quads[cell];
            corners.insert(quad.begin(), quad.end());
            RC_ASSERT(std::set<Index>(quad.begin(), quad.end()).size() == 4);
        }
        RC_ASSERT(corners.size() == rig.sheet.mass.size());
        RC_ASSERT(*corners.begin() == 0);
        for_each_spring(rig.lattice, rig.network, [&](Index a, Index b, Index, double k, double) {
            RC_ASSERT(corners.contains(a) && corners.contains(b) && a != b && k > 0);
        });
    });
}

// Which sectors of each site hold together, in the order of the sectors.
std::vector<std::array<int, 4>> fans(const Rig& rig) {
    std::vector<std::array<int, 4>> parts;
    for (Index site = 0; site < rig.lattice.site_count(); ++site) {
        std::array<int, 4> part{};
        for (int a = 0; a < 4; ++a) {
            const auto node = [&](int sector) {
                const Index cell = rig.lattice.sector_cell(site, sector);
                return cell == kNone ? kNone
                                     : rig.sheet.quads[static_cast<std::size_t>(cell)]
                                                      [static_cast<std::size_t>(sector)];
            };
            int same = 0;
            while (node(same) != node(a))
                ++same;
            part[static_cast<std::size_t>(a)] = same;
        }
        parts.push_back(part);
    }
    return parts;
}

TEST(SceneProperties, TheOrderOfCutsDoesNotMatter) {
    expect_property([](std::uint64_t trial) {
        Dice dice(trial), same(trial);
        Rig rig(test::random_params(dice)), other(test::random_params(same));
        std::vector<Opening> openings = any_openings(rig.lattice);
        for (const auto& [site, mask] : openings)
            open_site(rig.lattice, rig.sheet, site, mask);
        std::ranges::reverse(openings);
        for (const auto& [site, mask] : openings)
            open_site(other.lattice, other.sheet, site, mask);
        RC_ASSERT(fans(rig) == fans(other));
        RC_ASSERT(rig.sheet.mass.size() == other.sheet.mass.size());
    });
}

// A small sheet that is alight after a few ticks.
Params burning(std::uint64_t seed) {
    Params p = test::plain(6, 9);
    p.sheet.held = HeldEdge::MainStart;
    p.sheet.pose = SheetPose::Hanging;
    p.sheet.elevation = 0.5;
    p.springs.variation = 0.1;
    p.springs.stiffness_scale = 10;
    p.world.gravity = 9.81;
    p.burning.burn_speed = 4;
    p.lighter.on = true;
    p.lighter.x = 0;
    p.lighter.y = 0.40;
    p.lighter.strength = 2;
    p.numerics.seed = static_cast<int>(seed % 1000);
    return p;
}

void advance(World& world, int ticks) {
    for (int i = 0; i < ticks; ++i)
        RC_ASSERT(world.step().ok());
}

TEST(SceneProperties, TheNumberOfThreadsDoesNotMatter) {
    expect_property([](std::uint64_t seed) {
        World one = make_world(burning(seed), 1);
        World many = make_world(burning(seed), *rc::gen::inRange(2, 9));
        advance(one, 25), advance(many, 25);
        RC_ASSERT(one.state().fire.size() > 0u);
        RC_ASSERT(one.hash() == many.hash());
    });
}

// Sums over particles are taken in another order, so it is the same but for rounding.
TEST(SceneProperties, TheOrderOfParticlesDoesNotMatter) {
    expect_property([](std::uint64_t seed) {
        World world = make_world(burning(seed), 1), other = make_world(burning(seed), 1);
        advance(world, 25);
        WorldState state = world.snapshot();
        const std::size_t count = state.fire.size();
        RC_ASSERT(count > 10u);
        const std::size_t turn = *rc::gen::inRange<std::size_t>(1, count);
        for_each_array(state.fire, [&](auto& array) {
            std::rotate(array.begin(), array.begin() + static_cast<std::ptrdiff_t>(turn),
                        array.end());
        });
        other.restore(state);
        advance(world, 1), advance(other, 1);
        const auto &a = world.state().sheets[0].temperature,
                   &b = other.state().sheets[0].temperature;
        double hottest = 0;
        for (std::size_t n = 0; n < a.size(); ++n) {
            RC_ASSERT(std::abs(a[n] - b[n]) < 1e-9 * a[n]);
            hottest = std::max(hottest, a[n]);
        }
        RC_ASSERT(hottest > 310);
        RC_ASSERT(world.state().fire.size() == other.state().fire.size());
    });
}

// Sheets that are far from each other, listed in another order.
TEST(SceneProperties, TheOrderOfSheetsDoesNotMatter) {
    expect_property([](std::uint64_t trial) {
        Dice dice(trial);
        Params p = test::plain(4, 5);
        p.sheet.held = HeldEdge::MainStart;
        p.springs.stiffness_scale = 10;
        p.world.gravity = 9.81;
        const ParamInfo& place = *find_param(sim_param_rows(), "sheet.x");
        const ParamInfo& turn = *find_param(sim_param_rows(), "sheet.turn_x");
        for (int i = 0; i < 3; ++i)
            p.sheets.push_back({{&place, 1.0 * i}, {&turn, dice.in(-1, 1)}});
        Params backwards = p;
        std::ranges::reverse(backwards.sheets);
        World world = make_world(p), other = make_world(backwards);
        advance(world, 10), advance(other, 10);
        for (std::size_t s = 0; s < 3; ++s) {
            const Vector3Array &a = world.state().sheets[s].position,
                               &b = other.state().sheets[2 - s].position;
            RC_ASSERT(a.x == b.x);
            RC_ASSERT(a.y == b.y);
            RC_ASSERT(a.z == b.z);
        }
    });
}

}  // namespace
}  // namespace ember
