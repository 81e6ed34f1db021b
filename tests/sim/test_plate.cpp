// Flexural rigidity: what the discrete energy is, and that the forces follow from it.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "random_sheet.h"
#include "sim/integrators/motion.h"

namespace ember {
namespace {

using test::Dice;
using test::plain;
using test::Rig;
constexpr double kPi = std::numbers::pi;

// A sheet without springs whose rigidity is 1e-3 N m, times a factor across.
Params bare(int rows, int columns, double across = 1.0, double poisson = 0.3) {
    Params p = plain(rows, columns);
    p.springs.structural = p.springs.diagonal = p.springs.bending = p.springs.damping = 0;
    p.plate.rigidity_main = 1e-3;
    p.plate.rigidity_cross = 1e-3 * across;
    p.plate.poisson = poisson;
    return p;
}

// Random curvatures at rest, up to the lattice's own limit 1/2h.
void bend_at_random(Rig& rig, Dice& dice) {
    const double most = 0.5 / std::max(rig.lattice.column_spacing, rig.lattice.row_spacing);
    RestCurvature& rest = rig.sheet.rest_curvature;
    for (std::vector<double>* array : {&rest.main, &rest.cross, &rest.twist}) {
        array->resize(static_cast<std::size_t>(rig.lattice.site_count()));
        for (double& value : *array)
            value = dice.in(-most, most);
    }
}

Params random_plate(Dice& dice) {
    Params p = test::random_params(dice);
    p.plate.rigidity_main = 1e-3 * dice.factor(5);
    p.plate.rigidity_cross = dice.chance(0.9) ? 1e-3 * dice.factor(5) : 0.0;
    p.plate.poisson = dice.in(0, 0.5);
    p.plate.char_rigidity = dice.in(0, 1);
    p.plate.clamped = dice.chance(0.7);
    return p;
}

std::vector<double> forces_of(Rig& rig) {
    Motion motion;
    motion.read(rig.sheet);
    rig.plate_forces.evaluate(rig.lattice, rig.plate, rig.sheet.rest_curvature, motion.x.data(),
                              rig.sheet.mass.size(), *rig.pool);
    return rig.plate_forces.total;
}

double energy_of(const Rig& rig) {
    return plate_energy(rig.lattice, rig.plate, rig.sheet);
}

// Moves every node of the flat sheet at (x, z) to place(x, z), from the middle of the sheet.
template <class Place>
void shape(Rig& rig, Place&& place) {
    const Lattice& l = rig.lattice;
    for (Index site = 0; site < l.site_count(); ++site) {
        const double x = (l.column_of(site) - 0.5 * (l.column_count - 1)) * l.column_spacing;
        const double z = (l.row_of(site) - 0.5 * (l.row_count - 1)) * l.row_spacing;
        rig.sheet.position.set(static_cast<std::size_t>(site), place(x, z));
    }
}

TEST(Plate, ForcesAreTheGradientOfTheEnergyForAnySheet) {
    for (std::uint64_t trial = 0; trial < 60; ++trial) {
        Dice dice(trial);
        Rig rig(random_plate(dice));
        test::burn_and_cut(rig, dice);
        if (dice.chance(0.7)) bend_at_random(rig, dice);
        test::crumple(rig, dice);
        rig.refresh();
        const std::vector<double> f = forces_of(rig);
        const double largest = std::abs(*std::max_element(
            f.begin(), f.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
        ASSERT_GT(largest, 0);
        const std::size_t n = rig.sheet.mass.size();
        for (std::size_t i = 0; i < n; ++i) {
            if (rig.sheet.held[i] != 0) continue;  // clamps do not report what they hold
            for (std::size_t axis = 0; axis < 3; ++axis) {
                std::vector<double>& q = axis == 0   ? rig.sheet.position.x
                                         : axis == 1 ? rig.sheet.position.y
                                                     : rig.sheet.position.z;
                const double at = q[i], step = 1e-7;
                q[i] = at + step;
                const double above = energy_of(rig);
                q[i] = at - step;
                const double below = energy_of(rig);
                q[i] = at;
                ASSERT_NEAR(f[axis * n + i], (below - above) / (2 * step), 2e-6 * largest)
                    << "trial " << trial << " node " << i << " axis " << axis;
            }
        }
    }
}

TEST(Plate, RigidMotionsChangeNoEnergyAndForcesHaveNeitherSumNorMoment) {
    for (std::uint64_t trial = 0; trial < 40; ++trial) {
        Dice dice(trial);
        Params p = random_plate(dice);
        p.sheet.held = HeldEdge::None;
        Rig rig(p);
        test::burn_and_cut(rig, dice);
        bend_at_random(rig, dice);
        test::crumple(rig, dice);
        rig.refresh();
        const double before = energy_of(rig);
        const std::vector<double> f = forces_of(rig);
        const std::size_t n = rig.sheet.mass.size();
        Vector3 sum = Vector3::Zero(), moment = Vector3::Zero();
        double size = 0, arm = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Vector3 force(f[i], f[n + i], f[2 * n + i]), x = rig.sheet.position.at(i);
            sum += force;
            moment += x.cross(force);
            size += force.norm();
            arm = std::max(arm, x.norm());
        }
        EXPECT_LT(sum.norm(), 1e-13 * size);
        EXPECT_LT(moment.norm(), 1e-12 * size * arm);
        const Eigen::AngleAxisd turn(dice.in(-3, 3), dice.vector(1).normalized());
        const Vector3 move = dice.vector(1);
        for (std::size_t i = 0; i < n; ++i)
            rig.sheet.position.set(i, turn * rig.sheet.position.at(i) + move);
        EXPECT_NEAR(energy_of(rig), before, 1e-11 * before);
    }
}

TEST(Plate, AFlatSheetHasNoEnergyAndATubeAsBuiltNone) {
    Rig flat(bare(5, 7));
    EXPECT_LT(energy_of(flat), 1e-25);
    Params p = bare(9, 7);
    p.sheet.shape = SheetShape::Cylinder;
    Rig tube(p);
    EXPECT_LT(energy_of(tube), 1e-22);
    const std::vector<double> f = forces_of(tube);
    for (const double force : f)
        EXPECT_LT(std::abs(force), 1e-13);
    // and it would cost it about ½ D κ² of its area to be flat
    Rig unrolled(p);
    unrolled.sheet.rest_curvature = {};
    const double area = p.sheet.width * p.sheet.height, curvature = built_curvature(tube.lattice);
    EXPECT_LT(curvature, 0);
    // rows at both ends have half an element each, those beside them a whole one: 6 of 7 columns
    // bend freely along the tube, and only the outermost carry less
    EXPECT_NEAR(energy_of(unrolled), 0.5e-3 * curvature * curvature * area,
                0.02 * energy_of(unrolled));
}

TEST(Plate, CylindersOfEitherDirectionHaveTheEnergyOfAPlate) {
    // rolled up without stretching along x or z; free borders keep 1 - ν² of the rigidity
    constexpr double kRadius = 0.05, kPoisson = 0.3;
    constexpr int kCells = 60;
    for (const bool along_main : {true, false}) {
        Rig rig(bare(kCells, kCells, 2.0, kPoisson));
        const double h = rig.lattice.column_spacing;
        // chords of length h
        const double angle = 2 * std::asin(0.5 * h / kRadius);
        shape(rig, [&](double x, double z) {
            const double along = (along_main ? x : z) / h * angle;
            const double u = kRadius * std::sin(along), y = kRadius * (1 - std::cos(along));
            return along_main ? Vector3(u, y, z) : Vector3(x, y, u);
        });
        const double d = along_main ? 1e-3 : 2e-3, curvature = 2 * std::sin(0.5 * angle) / h;
        // of kCells + 1 lines along which it bends the two at the border have half the width, and
        // no line bends at its ends
        const double lines = kCells - 1 + (1 - kPoisson * kPoisson), places = kCells - 1;
        EXPECT_NEAR(energy_of(rig), 0.5 * d * curvature * curvature * h * h * lines * places,
                    1e-9 * energy_of(rig));
    }
}

TEST(Plate, ATwistedSheetHasTheEnergyOfAPlate) {
    // y = t x z: κ_xz = t, and 2 D_xz t² per area with D_xz = (1 - ν)/2 √(D_x D_z)
    constexpr double kTwist = 0.01, kPoisson = 0.3;
    Rig rig(bare(12, 20, 4.0, kPoisson));
    shape(rig, [](double x, double z) { return Vector3(x, kTwist * x * z, z); });
    const double area = rig.params.sheet.width * rig.params.sheet.height;
    const double d = 0.5 * (1 - kPoisson) * 2e-3;
    EXPECT_NEAR(energy_of(rig), 2 * d * kTwist * kTwist * area, 1e-10 * energy_of(rig));
}

TEST(Plate, ASaddleAndABowlDifferByPoissonsRatio) {
    // y = c (x² ± z²)/2: D c² (1 ± ν) per area, where both lines go on
    constexpr double kCurvature = 1e-3;
    const auto energy = [](double sign, double poisson) {
        Rig rig(bare(40, 40, 1.0, poisson));
        shape(rig, [sign](double x, double z) {
            return Vector3(x, 0.5 * kCurvature * (x * x + sign * z * z), z);
        });
        double inside = 0;  // only elements that are whole
        rig.plate.elements.clear();
        inside = energy_of(rig);
        return inside / (1e-3 * kCurvature * kCurvature * 39 * 39 * 1e-4);
    };
    EXPECT_NEAR(energy(1, 0.3), 1.3, 1e-6);
    EXPECT_NEAR(energy(-1, 0.3), 0.7, 1e-6);
    EXPECT_NEAR(energy(-1, 0.0), 1.0, 1e-6);
}

TEST(Plate, IsotropicWhenIsotropic) {
    // a square sheet, bent at random, and the same with rows and columns exchanged
    Rig rig(bare(9, 9)), other(bare(9, 9));
    for (Index site = 0; site < rig.lattice.site_count(); ++site) {
        Dice dice(static_cast<std::uint64_t>(site));
        const Index mirrored =
            rig.lattice.site(rig.lattice.column_of(site), rig.lattice.row_of(site));
        const Vector3 x = rig.sheet.position.at(static_cast<std::size_t>(site)) + dice.vector(3e-3);
        rig.sheet.position.set(static_cast<std::size_t>(site), x);
        other.sheet.position.set(static_cast<std::size_t>(mirrored), x);
    }
    EXPECT_NEAR(energy_of(rig), energy_of(other), 1e-12 * energy_of(rig));
    // bent along the diagonal as along an edge: wide rolls of radius R about either, far from
    // borders, have ½ D/R² per area
    const auto per_area = [](double angle) {
        Rig sheet(bare(40, 40));
        constexpr double kRadius = 2.0;
        shape(sheet, [angle](double x, double z) {
            const double along = std::cos(angle) * x + std::sin(angle) * z;
            const double side = std::cos(angle) * z - std::sin(angle) * x;
            const double u = kRadius * std::sin(along / kRadius);
            const double y = kRadius * (1 - std::cos(along / kRadius));
            return Vector3(std::cos(angle) * u - std::sin(angle) * side, y,
                           std::sin(angle) * u + std::cos(angle) * side);
        });
        sheet.plate.elements.clear();
        const double whole = energy_of(sheet);
        // without the twist of the 40·40 cells, of which 39·39 belong to whole elements
        sheet.plate.cell_left.assign(sheet.plate.cell_left.size(), 0.0);
        const double bend = energy_of(sheet);
        return (bend / (39 * 39) + (whole - bend) / (40 * 40)) / 1e-4;
    };
    const double along_edge = per_area(0), along_diagonal = per_area(kPi / 4);
    EXPECT_NEAR(along_edge, 0.5 * 1e-3 / 4, 1e-4 * along_edge);
    EXPECT_NEAR(along_diagonal, along_edge, 1e-4 * along_edge);
    EXPECT_NEAR(per_area(0.4), along_edge, 1e-4 * along_edge);
}

TEST(Plate, ACrackCarriesNoMoment) {
    // cut along a whole row of sites inside the sheet: the two halves fold about it for free
    Rig rig(bare(6, 8));
    for (Index column = 0; column < rig.lattice.column_count; ++column) {
        (void)cut_site(rig.lattice, rig.sheet, rig.lattice.site(3, column), CutLine::AlongMain);
    }
    rig.refresh();
    const double z0 = rig.sheet.position.z[rig.site(3, 0)];
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n) {
        const double z = rig.sheet.position.z[n] - z0;
        if (z > 0) rig.sheet.position.y[n] += 0.7 * z;
    }
    EXPECT_LT(energy_of(rig), 1e-22);
    // bent along the crack both lips resist: together as much as the row before
    Rig whole(bare(6, 8));
    for (Rig* r : {&rig, &whole}) {
        for (std::size_t n = 0; n < r->sheet.mass.size(); ++n) {
            const double x = r->sheet.position.x[n];
            r->sheet.position.y[n] = 0.5 * x * x;
        }
    }
    EXPECT_LT(energy_of(rig), energy_of(whole));
    EXPECT_GT(energy_of(rig), (1 - 0.3 * 0.3) * energy_of(whole));
}

TEST(Plate, CharKeepsItsShare) {
    Params p = bare(4, 6);
    p.plate.char_rigidity = 0.1;
    Rig rig(p);
    shape(rig, [](double x, double z) { return Vector3(x, x * x, z); });
    const double whole = energy_of(rig);
    const auto burn_to = [&](double left) {
        for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
            rig.sheet.mass[n] = left * rig.sheet.initial_mass[n];
        rig.refresh();
        return energy_of(rig) / whole;
    };
    EXPECT_NEAR(burn_to(0.2), 0.1, 1e-12);
    EXPECT_NEAR(burn_to(0.6), 0.55, 1e-12);
    rig.params.springs.follows_mass = false;
    EXPECT_NEAR(burn_to(0.2), 1.0, 1e-12);
}

TEST(Plate, RigidityFollowsFromTheLabel) {
    Params p;
    p.paper.grammage = 0.08;
    p.paper.density = 800;  // 0.1 mm
    p.plate.youngs_main = 6e9;
    p.plate.youngs_cross = 3e9;
    p.plate.poisson = 0.2;
    const Rigidity d = flexural_rigidity(p.paper, p.plate);
    EXPECT_NEAR(d.main, 6e9 * 1e-12 / 12 / 0.96, 1e-12);
    EXPECT_NEAR(d.cross, 0.5 * d.main, 1e-12);
    EXPECT_NEAR(d.coupling, 0.2 * std::sqrt(d.main * d.cross), 1e-12);
    EXPECT_NEAR(d.twist, 0.4 * std::sqrt(d.main * d.cross), 1e-12);
}

TEST(Plate, ThreadsDoNotChangeABit) {
    Params p = bare(70, 90);
    Rig one(p), three(p);
    three.pool = std::make_unique<ThreadPool>(3);
    for (Rig* rig : {&one, &three}) {
        Dice dice(7);
        test::crumple(*rig, dice);
        bend_at_random(*rig, dice);
    }
    EXPECT_EQ(forces_of(one), forces_of(three));
}

}  // namespace
}  // namespace ember
