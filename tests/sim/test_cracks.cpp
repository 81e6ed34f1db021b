// Cracks of any direction: how ash is loaded, which way it breaks, how a path follows a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "rig.h"
#include "sim/crack_path.h"
#include "sim/fracture.h"
#include "sim/topology.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;

constexpr double kPi = std::numbers::pi;
constexpr std::array<int, 4> kWhole{0, 0, 0, 0};

// Square cells with the paper's stiffnesses per node mass.
Params square(int cells) {
    Params p = plain(cells, cells);
    p.springs.stiffness_law = StiffnessLaw::PerNodeMass;
    return p;
}

double degrees(PlaneVector v) {
    return std::atan2(v.z, v.x) * 180.0 / kPi;
}

// Angle between two lines in degrees, 0 to 90.
double between(double a, double b) {
    const double d = std::fmod(std::abs(a - b), 180.0);
    return std::min(d, 180.0 - d);
}

PlaneTensor pull(double angle, double size) {
    const double c = std::cos(angle * kPi / 180), s = std::sin(angle * kPi / 180);
    return {size * c * c, size * s * s, size * c * s};
}

// The strain of a lattice of square cells under a stress that part_stress() would measure. With
// k = 7, 7, 20: C_xxxx = k_s + 4 k_b + k_d, C_xxzz = C_xzxz = k_d.
PlaneTensor strain_under(const PlaneTensor& stress) {
    const double a = 7 + 4 * 20 + 7, b = 7, y = a - b * b / a;
    const double det = a * a - b * b;
    return {y * (a * stress.xx - b * stress.zz) / det, y * (a * stress.zz - b * stress.xx) / det,
            y * stress.xz / (2 * b)};
}

// Deforms a flat sheet by a homogeneous strain; x runs along y's plane as the rig places it.
void strain(Rig& rig, const PlaneTensor& e) {
    SheetState& sheet = rig.sheet;
    const Vector3 o = sheet.position.at(0);
    const Vector3 along = (sheet.position.at(rig.site(0, 1)) - o).normalized();
    const Vector3 across = (sheet.position.at(rig.site(1, 0)) - o).normalized();
    for (std::size_t n = 0; n < sheet.glue.size(); ++n) {
        const Vector3 d = sheet.position.at(n) - o;
        const double x = d.dot(along), z = d.dot(across);
        sheet.position.set(
            n, o + (x + e.xx * x + e.xz * z) * along + (z + e.zz * z + e.xz * x) * across);
    }
}

void burn_all(Rig& rig) {
    SheetState& sheet = rig.sheet;
    sheet.phase.assign(sheet.phase.size(), Phase::BurntOut);
    sheet.burnout_time.assign(sheet.phase.size(), 0.0);
}

TEST(AshStress, AHomogeneousStressIsMeasuredInEveryDirection) {
    for (const double angle : {0.0, 15.0, 30.0, 45.0, 70.0, 90.0, 120.0}) {
        Rig rig(square(6));
        const PlaneTensor stress = pull(angle, 1e-6);
        strain(rig, strain_under(stress));
        for (const Index site : {rig.lattice.site(3, 3), rig.lattice.site(2, 4)}) {
            const PlaneTensor found = part_stress(rig.lattice, rig.sheet, site, kWhole, 0);
            EXPECT_NEAR(found.xx, stress.xx, 1e-10);
            EXPECT_NEAR(found.zz, stress.zz, 1e-10);
            EXPECT_NEAR(found.xz, stress.xz, 1e-10);
        }
    }
}

TEST(AshStress, ACutCarriesNoStressAcrossIt) {
    Rig rig(square(6));
    burn_all(rig);
    const Index site = rig.lattice.site(3, 3);
    cut_site(rig.lattice, rig.sheet, site, CutLine::AlongCross);
    strain(rig, {0, 1e-6, 0});
    const auto fan = fan_parts(rig.lattice, site, rig.sheet.glue[rig.site(3, 3)]);
    const double whole = part_stress(rig.lattice, rig.sheet, rig.lattice.site(3, 4), kWhole, 0).zz;
    for (const int part : {0, 1})
        EXPECT_NEAR(part_stress(rig.lattice, rig.sheet, site, fan, part).zz / whole, 1, 1e-6);
    strain(rig, {1e-6, 0, 0});
    // across the cut edges and diagonals are left, which carry 14 of 94 parts; 7 come from along it
    const double across = part_stress(rig.lattice, rig.sheet, site, fan, 0).xx;
    EXPECT_NEAR(across * (94 - 49.0 / 94), 21e-6, 1e-10);
}

TEST(WeakestDirection, IsTheDirectionOfThePullOnIsotropicAsh) {
    for (double angle = -85; angle <= 90; angle += 5) {
        const WeakestDirection w = weakest_direction(pull(angle, 0.01), {1, 1, 0});
        EXPECT_LT(between(degrees(w.normal), angle), 1e-6);
        EXPECT_NEAR(w.ratio, 0.01, 1e-15);
    }
}

// σ = p p^T: (n·p)²/(n^T S n) is largest for n along S^-1 p, where it is p^T S^-1 p.
TEST(WeakestDirection, GrainTurnsItAsItsStrengthSays) {
    for (const double grain : {0.3, 0.5, 0.8, 1.5}) {
        for (double angle = -80; angle <= 80; angle += 20) {
            const double c = std::cos(angle * kPi / 180), s = std::sin(angle * kPi / 180);
            const WeakestDirection w = weakest_direction(pull(angle, 1), {1, grain, 0});
            EXPECT_LT(between(degrees(w.normal), degrees({c, s / grain})), 1e-6);
            EXPECT_NEAR(w.ratio, c * c + s * s / grain, 1e-12);
        }
    }
}

TEST(WeakestDirection, EqualPullsOpenTheBurntBoundary) {
    Rig rig(plain(8, 8));
    burn_all(rig);
    for (const double angle : {0.0, 20.0, 45.0, 110.0}) {
        const double c = std::cos(angle * kPi / 180), s = std::sin(angle * kPi / 180);
        for (std::size_t n = 0; n < rig.sheet.glue.size(); ++n) {
            const auto r = static_cast<double>(n / 9), k = static_cast<double>(n % 9);
            rig.sheet.burnout_time[n] = 5 + 0.1 * (c * k + s * r);  // the front came along `angle`
        }
        FractureParams f;
        f.grain = 1;
        f.boundary = 0.3;
        const PlaneTensor strength =
            strength_tensor(rig.lattice, rig.sheet, f, rig.lattice.site(4, 4));
        const WeakestDirection w = weakest_direction({0.01, 0.01, 0}, strength);
        EXPECT_LT(between(degrees(w.normal), angle), 1e-6);
        EXPECT_NEAR(w.ratio, 0.01 / 0.7, 1e-12);
    }
}

TEST(AshStrength, FallsWithAgeToItsShare) {
    Rig rig(plain(4, 4));
    burn_all(rig);
    rig.params.fracture.ash_strength = 0.2;
    rig.params.fracture.ash_time = 2;
    const auto strength = [&](double time) {
        return relative_strength(rig.lattice, rig.sheet, rig.params, 0, 6, time);
    };
    EXPECT_DOUBLE_EQ(strength(0), 1.0);
    EXPECT_NEAR(strength(2), 0.2 + 0.8 * std::exp(-1.0), 1e-15);
    EXPECT_NEAR(strength(100), 0.2, 1e-12);
    rig.params.paper.grammage *= 5;  // there is more to glow out
    EXPECT_NEAR(strength(10), 0.2 + 0.8 * std::exp(-1.0), 1e-15);
}

TEST(AshStrength, VariesSmoothlyWithinItsBoundsAndClosesAroundATube) {
    Params p = plain(40, 60);
    p.sheet.shape = SheetShape::Cylinder;
    Rig rig(p);
    burn_all(rig);
    rig.params.fracture.strength_noise = 0.3;
    rig.params.fracture.noise_length = 0.05;
    double least = 2, most = 0, step = 0;
    for (Index r = 0; r < 40; ++r) {
        for (Index c = 0; c < 60; ++c) {
            const auto at = [&](Index row) {
                return relative_strength(rig.lattice, rig.sheet, rig.params, 0,
                                         rig.lattice.site(row % 40, c), 0);
            };
            least = std::min(least, at(r)), most = std::max(most, at(r));
            step = std::max(step, std::abs(at(r + 1) - at(r)));
        }
    }
    EXPECT_GE(least, 0.7);
    EXPECT_LE(most, 1.3);
    EXPECT_GT(most - least, 0.3);
    EXPECT_LT(step, 0.3 * 2 * 1.5 / 5 + 1e-9);  // steepest smoothstep over 5 rows, seam included
}

TEST(CrackPath, StaysAsCloseToALineOfAnyDirectionAsTheLatticeAllows) {
    for (const double ratio : {1.0, 1.4}) {
        Params p = plain(200, 200);
        p.sheet.width *= ratio;
        const Rig rig(p);
        const double hx = rig.lattice.column_spacing, hz = rig.lattice.row_spacing;
        for (double angle = 0; angle < 360; angle += 7.5) {
            const PlaneVector heading{std::cos(angle * kPi / 180), std::sin(angle * kPi / 180)};
            // half of the distance across the line between the two sites that it may choose from
            const double most = 0.5 * (hx * std::abs(heading.z) + hz * std::abs(heading.x));
            PlaneVector at{}, offset{};
            double advance = 0;
            for (int i = 0; i < 90; ++i) {
                const CrackStep step = next_step(rig.lattice, 0b1111, offset, heading);
                ASSERT_GE(step.edge, 0);
                const PlaneVector e = edge_vector(rig.lattice, step.edge);
                at = {at.x + e.x, at.z + e.z};
                offset = step.offset;
                advance += step.advance;
                EXPECT_LE(std::sqrt(dot(offset, offset)), most * (1 + 1e-9));
                EXPECT_NEAR(at.x + offset.x, advance * heading.x, 1e-12);
                EXPECT_NEAR(at.z + offset.z, advance * heading.z, 1e-12);
            }
        }
    }
}

// A sheet of ash, held along its outline in the state of a pull at `angle` by `load` thresholds,
// that may crack from its middle on. Returns the direction of the crack by principal axes.
struct Crack {
    double angle;
    std::size_t sites;
};
Crack crack_under(double angle, double grain, int cells) {
    Params p = square(cells);
    p.sheet.width = p.sheet.height = 0.25;
    p.springs.stiffness_scale = 40;
    p.fracture.rule = FractureRule::Stress;
    p.fracture.grain = grain;
    p.fracture.boundary = 0;
    Rig rig(p);
    burn_all(rig);
    for (std::size_t n = 0; n < rig.sheet.mass.size(); ++n)
        rig.sheet.mass[n] *= 0.2;
    strain(rig, strain_under(pull(angle, 1.6 * p.fracture.threshold)));
    for (Index i = 0; i <= cells; ++i) {
        for (const auto n :
             {rig.site(0, i), rig.site(cells, i), rig.site(i, 0), rig.site(i, cells)})
            rig.sheet.held[n] = 1;
    }
    constexpr double kNever = std::numeric_limits<double>::infinity();
    rig.sheet.relief_until.assign(rig.sheet.relief_until.size(), kNever);
    rig.sheet.relief_until[rig.site(cells / 2, cells / 2)] = 0;
    rig.refresh();
    const std::vector<Index> none;
    std::vector<Index> cut;
    for (int tick = 1; tick <= 50; ++tick) {
        ActiveNodes active;
        find_active(rig.lattice, rig.sheet, active);
        break_ash({rig.lattice, rig.params, rig.network, active, 0, tick / 60.0, none}, rig.sheet,
                  rig.counters);
        rig.refresh();
        rig.run(1.0 / 60, 24, IntegratorKind::VelocityVerlet);
    }
    double sx = 0, sz = 0, xx = 0, zz = 0, xz = 0, n = 0;
    for (Index site = 0; site < rig.lattice.site_count(); ++site) {
        const auto fan =
            fan_parts(rig.lattice, site, rig.sheet.glue[static_cast<std::size_t>(site)]);
        if (*std::max_element(fan.begin(), fan.end()) == 0) continue;
        const PlaneVector o = crack_offset(rig.sheet.cracks, site);
        const double x = rig.lattice.column_of(site) * rig.lattice.column_spacing + o.x;
        const double z = rig.lattice.row_of(site) * rig.lattice.row_spacing + o.z;
        sx += x, sz += z, xx += x * x, zz += z * z, xz += x * z, n += 1;
    }
    xx -= sx * sx / n, zz -= sz * sz / n, xz -= sx * sz / n;
    return {0.5 * std::atan2(2 * xz, xx - zz) * 180 / kPi, static_cast<std::size_t>(n)};
}

TEST(Crack, RunsAtARightAngleToThePull) {
    for (const double angle : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 90.0, 105.0, 150.0}) {
        const Crack crack = crack_under(angle, 1, 30);
        std::printf("  pull at %5.1f: crack at %6.1f, %zu sites\n", angle, crack.angle,
                    crack.sites);
        EXPECT_GT(crack.sites, 8u);
        EXPECT_LT(between(crack.angle, angle + 90), 3.0) << "pull at " << angle;
    }
}

TEST(Crack, TurnsWithTheGrain) {
    for (const double grain : {0.5, 2.0}) {
        const double c = std::cos(kPi / 4), s = std::sin(kPi / 4) / grain;
        const Crack crack = crack_under(45, grain, 30);
        std::printf("  grain %.1f: crack at %6.1f, expected %6.1f\n", grain, crack.angle,
                    degrees({c, s}) + 90);
        EXPECT_LT(between(crack.angle, degrees({c, s}) + 90), 4.0);
    }
}

}  // namespace
}  // namespace ember
