// Plates at rest under a load, against the theory of beams and plates.
#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <vector>

#include "rig.h"

namespace ember {
namespace {

using test::plain;
using test::Rig;
constexpr double kPi = std::numbers::pi;

// ---- small deflections: K w = f, by the elements that the forces are made of -------------------

class DeflectionMatrix {
  public:
    explicit DeflectionMatrix(const Rig& rig) : rig_(rig) {
        for_each_element(rig.lattice, rig.plate, [this](const PlateElement& e) {
            const Terms main{{e.west, 1}, {e.centre, -2}, {e.east, 1}};
            const Terms cross{{e.north, 1}, {e.centre, -2}, {e.south, 1}};
            add(main, main, e.left * e.main);
            add(cross, cross, e.left * e.cross);
            add(main, cross, e.left * e.coupling);
            add(cross, main, e.left * e.coupling);
        });
        for_each_cell(rig.lattice, rig.plate, [this](const PlateCell& c) {
            const Terms twist{{c.nodes[0], 1}, {c.nodes[1], -1}, {c.nodes[2], 1}, {c.nodes[3], -1}};
            add(twist, twist, c.left * rig_.plate.twist);
        });
        for (const PlateClamp& c : rig.plate.clamps) {
            const Terms slope{{c.next, 1}, {c.held, -1}};
            add(slope, slope, c.left * c.stiffness);
        }
    }

    // Deflections [m] under a weight of `load` [N/m²] on every node's share of the area.
    [[nodiscard]] std::vector<double> under(double load) const {
        const auto n = static_cast<Eigen::Index>(rig_.sheet.mass.size());
        Eigen::SparseMatrix<double> k(n, n);
        std::vector<Eigen::Triplet<double>> entries = entries_;
        Eigen::VectorXd f(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto node = static_cast<std::size_t>(i);
            const bool held = rig_.sheet.held[node] != 0;
            f[i] = held ? 0 : load * rig_.sheet.mass[node] / rig_.params.paper.grammage;
            if (held) entries.emplace_back(i, i, 1.0);
        }
        k.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(k);
        EXPECT_EQ(solver.info(), Eigen::Success);
        const Eigen::VectorXd w = solver.solve(f);
        return {w.data(), w.data() + n};
    }

  private:
    struct Term {
        Index node;
        double factor;
    };
    using Terms = std::initializer_list<Term>;

    void add(const Terms& rows, const Terms& columns, double k) {
        for (const Term& r : rows) {
            for (const Term& c : columns) {
                const bool held = rig_.sheet.held[static_cast<std::size_t>(r.node)] != 0 ||
                                  rig_.sheet.held[static_cast<std::size_t>(c.node)] != 0;
                if (!held && k != 0) entries_.emplace_back(r.node, c.node, k * r.factor * c.factor);
            }
        }
    }

    const Rig& rig_;
    std::vector<Eigen::Triplet<double>> entries_;
};

constexpr double kRigidity = 1e-3;  // [N m]

Params plate(int rows, int columns) {
    Params p = plain(rows, columns);
    p.springs.structural = p.springs.diagonal = p.springs.bending = p.springs.damping = 0;
    p.plate.rigidity_main = p.plate.rigidity_cross = kRigidity;
    return p;
}

// Deflection in the middle of a square whose whole border is held, times D / (q a⁴).
double middle_of_square(int cells, bool clamped) {
    Params p = plate(cells, cells);
    p.sheet.width = p.sheet.height = 0.2;
    p.plate.clamped = clamped;
    Rig rig(p);
    for (Index site = 0; site < rig.lattice.site_count(); ++site) {
        for (int d = 0; d < 4; ++d) {
            if (rig.lattice.neighbour(site, d) == kNone)
                rig.sheet.held[static_cast<std::size_t>(site)] = 1;
        }
    }
    rig.refresh();
    const double w = DeflectionMatrix(rig).under(1.0)[rig.site(cells / 2, cells / 2)];
    return w * kRigidity / std::pow(p.sheet.width, 4);
}

TEST(PlateEquilibrium, SquaresHeldAroundDeflectAsInTimoshenko) {
    // Timoshenko and Woinowsky-Krieger 1959, tables 8 and 35
    constexpr double kSupported = 0.0040624, kClamped = 0.0012653;
    EXPECT_NEAR(middle_of_square(32, false), kSupported, 0.003 * kSupported);
    EXPECT_NEAR(middle_of_square(32, true), kClamped, 0.01 * kClamped);
    // and come closer with the square of the cell
    for (const bool clamped : {false, true}) {
        const double exact = clamped ? kClamped : kSupported;
        const double coarse = middle_of_square(16, clamped) / exact - 1;
        const double fine = middle_of_square(32, clamped) / exact - 1;
        EXPECT_NEAR(coarse / fine, 4.0, 0.6) << coarse << ' ' << fine;
    }
}

TEST(PlateEquilibrium, DoesNotDependOnTheLattice) {
    // an A4 sheet of an anisotropic paper, clamped along one edge, from 16×24 to 128×192: the
    // deflection of the free corner and of the middle, against the finest
    std::vector<std::vector<double>> seen;
    for (const int refinement : {1, 2, 4, 8}) {
        Params p = plate(16 * refinement, 24 * refinement);
        p.sheet.width = 0.210, p.sheet.height = 0.297;
        p.sheet.held = HeldEdge::MainStart;
        p.plate.rigidity_cross = 0.4 * kRigidity;
        Rig rig(p);
        const std::vector<double> w = DeflectionMatrix(rig).under(1e-3);
        const Index m = 8 * refinement, n = 12 * refinement;
        seen.push_back({w[rig.site(0, 2 * n)], w[rig.site(m, 2 * n)], w[rig.site(m, n)],
                        w[rig.site(2 * m, n)]});
    }
    const std::vector<double>& finest = seen.back();
    for (std::size_t lattice = 0; lattice + 1 < seen.size(); ++lattice) {
        for (std::size_t place = 0; place < finest.size(); ++place) {
            // of the second order: 16×24 is worst
            const double tolerance = 0.01 / std::pow(4.0, static_cast<double>(lattice));
            EXPECT_NEAR(seen[lattice][place] / finest[place], 1.0, tolerance)
                << "lattice " << lattice << " place " << place;
        }
    }
}

TEST(PlateEquilibrium, ASquareDeflectsSymmetricallyAndTurnedPaperTurns) {
    const auto deflection = [](HeldEdge held, double main, double cross) {
        Params p = plate(12, 12);
        p.sheet.held = held;
        p.plate.rigidity_main = main, p.plate.rigidity_cross = cross;
        Rig rig(p);
        const std::vector<double> w = DeflectionMatrix(rig).under(1.0);
        return held == HeldEdge::MainStart ? w[rig.site(3, 12)] : w[rig.site(12, 3)];
    };
    const double along = deflection(HeldEdge::MainStart, 1e-3, 1e-3);
    EXPECT_NEAR(deflection(HeldEdge::CrossStart, 1e-3, 1e-3), along, 1e-9 * along);
    const double stiff = deflection(HeldEdge::MainStart, 2e-3, 1e-3);
    EXPECT_NEAR(deflection(HeldEdge::CrossStart, 1e-3, 2e-3), stiff, 1e-9 * stiff);
    EXPECT_NEAR(stiff, 0.5 * along, 0.1 * along);
}

// ---- large deflections: the elastica -----------------------------------------------------------

// Droop of the end of a heavy strip of length l that is clamped horizontally, over l. θ'' =
// -(w/D)(l - s) cos θ with θ(0) = 0, θ'(l) = 0, found by shooting; θ is the slope downwards.
double elastica_droop(double length, double weight, double rigidity) {
    constexpr int kSteps = 2000;
    const double h = length / kSteps;
    const auto shoot = [&](double curvature, double& droop) {
        double angle = 0, y = 0;
        const auto bend = [&](double s, double a) {
            return -weight / rigidity * (length - s) * std::cos(a);
        };
        for (int i = 0; i < kSteps; ++i) {
            const double s = i * h;
            const double a1 = curvature, b1 = bend(s, angle);
            const double a2 = curvature + 0.5 * h * b1,
                         b2 = bend(s + 0.5 * h, angle + 0.5 * h * a1);
            const double a3 = curvature + 0.5 * h * b2,
                         b3 = bend(s + 0.5 * h, angle + 0.5 * h * a2);
            const double a4 = curvature + h * b3, b4 = bend(s + h, angle + h * a3);
            const double middle = angle + 0.25 * h * (a1 + a2);
            const double next = angle + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
            y += h / 6 * (std::sin(angle) + 4 * std::sin(middle) + std::sin(next));
            curvature += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
            angle = next;
        }
        droop = y;
        return curvature;
    };
    double low = 0, high = weight * length * length / rigidity, droop = 0;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (shoot(middle, droop) < 0 ? low : high) = middle;
    }
    (void)shoot(0.5 * (low + high), droop);
    return droop / length;
}

TEST(PlateEquilibrium, TheElasticaItselfHasTheKnownLimits) {
    EXPECT_NEAR(elastica_droop(0.05, 0.01, 1e-3), 0.01 * std::pow(0.05, 3) / 8e-3, 1e-8);
    EXPECT_GT(elastica_droop(0.16, 0.8, 1e-4), 0.85);  // hangs
    EXPECT_LT(elastica_droop(0.16, 0.8, 1e-4), 1.0);
}

struct Strip {
    bool along_main = true;
    double length = 0.1;  // [m]
    double poisson = 0.0;
    int cells = 24;
};

constexpr double kStripRigidity = 5e-4;  // [N m] of office paper
constexpr int kSubsteps = 6;

// Droop over length of a strip of 80 g/m², two cells wide, when it has come to rest.
double settled_droop(const Strip& strip) {
    const int rows = strip.along_main ? 2 : strip.cells,
              columns = strip.along_main ? strip.cells : 2;
    Params p = plain(rows, columns);
    const double h = strip.length / strip.cells;
    p.sheet.width = rows * h, p.sheet.height = columns * h;
    p.sheet.held = strip.along_main ? HeldEdge::MainStart : HeldEdge::CrossStart;
    p.springs.stiffness_scale = 1e4;  // no strip that stretches is an elastica
    p.springs.bending = 0;
    (strip.along_main ? p.plate.rigidity_main : p.plate.rigidity_cross) = kStripRigidity;
    (strip.along_main ? p.plate.rigidity_cross : p.plate.rigidity_main) = 0.5 * kStripRigidity;
    p.plate.poisson = strip.poisson;
    p.world.gravity = 9.81;
    p.world.air_drag = 3.0;
    p.world.air_drag_tangential = 1.0;
    Rig rig(p);
    const std::size_t end = strip.along_main ? rig.site(1, columns) : rig.site(rows, 1);
    const double height = rig.sheet.position.y[end];
    double speed = 1;
    for (int tick = 0; tick < 600 && speed > 1e-4; ++tick) {
        EXPECT_EQ(rig.run(1.0 / 60, kSubsteps, IntegratorKind::Rosenbrock).failure, nullptr);
        speed = tick < 10 ? 1 : rig.sheet.velocity.at(end).norm();
    }
    EXPECT_LT(speed, 1e-4) << "not at rest";
    return (height - rig.sheet.position.y[end]) / strip.length;
}

TEST(PlateEquilibrium, ACantileverDroopsLikeTheElasticaInBothDirections) {
    const double weight = 0.080 * 9.81;
    const double natural = std::cbrt(kStripRigidity / weight);
    for (const bool along_main : {true, false}) {
        for (const double lengths : {0.5, 1.0, 1.5, 2.5}) {
            const double length = lengths * natural;
            const double exact = elastica_droop(length, weight, kStripRigidity);
            const double seen = settled_droop({along_main, length});
            RecordProperty((along_main ? "x_" : "z_") + std::to_string(lengths),
                           std::to_string(seen / exact));
            EXPECT_NEAR(seen, exact, 0.03 * exact) << along_main << ' ' << lengths;
        }
    }
}

TEST(PlateEquilibrium, ANarrowStripBendsFreelyAcross) {
    // ... and so has 1 - ν² of the rigidity
    constexpr double kPoisson = 0.4;
    const double weight = 0.080 * 9.81;
    const double exact = elastica_droop(0.12, weight, kStripRigidity * (1 - kPoisson * kPoisson));
    EXPECT_NEAR(settled_droop({true, 0.12, kPoisson}), exact, 0.03 * exact);
}

TEST(PlateEquilibrium, DroopConvergesToTheElastica) {
    const double weight = 0.080 * 9.81;
    const double exact = elastica_droop(0.12, weight, kStripRigidity);
    const double coarse = settled_droop({true, 0.12, 0.0, 6}) / exact - 1;
    const double fine = settled_droop({true, 0.12, 0.0, 24}) / exact - 1;
    EXPECT_LT(std::abs(fine), 0.3 * std::abs(coarse));
    EXPECT_LT(std::abs(fine), 0.005);
}

}  // namespace
}  // namespace ember
