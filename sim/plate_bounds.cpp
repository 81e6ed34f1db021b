// Energy of a plate, and what it adds to the bounds that solvers need: sums over its elements.
#include <algorithm>
#include <cmath>

#include "sim/kernel/plate_law.h"
#include "sim/plate_forces.h"

namespace ember {
namespace {

using plate::Triple;

Triple at(const Vector3Array& p, Index node) {
    const auto i = static_cast<std::size_t>(node);
    return {p.x[i], p.y[i], p.z[i]};
}

double length(const Triple& t) {
    return std::sqrt(plate::dot(t, t));
}

// One second difference: |c| at each node that it is taken from.
struct Reach {
    Index node;
    double factor;
};

// Adds k |c_i| Σ_j |c_j| root_j at each node.
template <std::size_t count>
void add_square(const std::array<Reach, count>& reach, double k, const std::vector<double>& root,
                std::vector<double>& bound) {
    double sum = 0.0;
    for (const Reach& r : reach)
        sum += r.factor * root[static_cast<std::size_t>(r.node)];
    for (const Reach& r : reach)
        bound[static_cast<std::size_t>(r.node)] += k * sum * r.factor;
}

plate::Around around(const Vector3Array& p, const PlateElement& e) {
    return {at(p, e.centre), at(p, e.west), at(p, e.east), at(p, e.north), at(p, e.south)};
}

plate::Moments moments(const PlateElement& e, const Vector3Array& p, const plate::Bent& bent) {
    return plate::moments_of({e.left * e.main, e.left * e.coupling, e.left * e.cross}, around(p, e),
                             bent);
}

plate::Twist twist(const PlateCell& c, const Plate& plate, const Vector3Array& p, double bent) {
    return plate::twist_of(c.left * plate.twist, at(p, c.nodes[0]), at(p, c.nodes[1]),
                           at(p, c.nodes[2]), at(p, c.nodes[3]), bent);
}

// How fast the unit normal of u × w can turn with u and w: |δn| <= by_u |δu| + by_w |δw|.
struct Turning {
    double by_u, by_w;
};
Turning turning(const Triple& u, const Triple& w) {
    const double area = length(plate::cross(u, w));
    if (!(area > 0)) return {0.0, 0.0};
    return {length(w) / area, length(u) / area};
}

// With |δ²n| <= 7/2 (by_u |δu| + by_w |δw|)²: N = u × w changes by N' = δu × w + u × δw and then by
// 2 δu × δw, and the unit vector's second change is at most 2 |δu × δw|/|N| + 3 |N'|²/|N|².
constexpr double kSecondTurn = 3.5;

void add_element(const PlateElement& e, const Vector3Array& p, const plate::Bent& bent,
                 const std::vector<double>& root, std::vector<double>& bound) {
    // 2 coupling a·b <= poisson (main a² + cross b²)
    const double product = e.main * e.cross;
    const double more = product > 0 ? 1.0 + std::abs(e.coupling) / std::sqrt(product) : 1.0;
    const plate::Around x = around(p, e);
    const Triple u = x.east - x.west, w = x.south - x.north;
    const bool curved = bent.main != 0 || bent.cross != 0;
    const Turning turn = curved ? turning(u, w) : Turning{0.0, 0.0};
    const auto add_line = [&](double k, double rest, Index before, Index after, bool main) {
        if (!(k > 0)) return;
        const double by_u = std::abs(rest) * turn.by_u, by_w = std::abs(rest) * turn.by_w;
        const double own = 1.0 + (main ? by_u : by_w), other = main ? by_w : by_u;
        add_square<5>({Reach{before, own},
                       {e.centre, 2.0},
                       {after, own},
                       {main ? e.north : e.west, other},
                       {main ? e.south : e.east, other}},
                      more * e.left * k, root, bound);
    };
    add_line(e.main, bent.main, e.west, e.east, true);
    add_line(e.cross, bent.cross, e.north, e.south, false);
    if (!curved) return;
    const plate::Moments m = moments(e, p, bent);
    const double pull = length(bent.main * m.main + bent.cross * m.cross);
    add_square<4>(
        {Reach{e.west, turn.by_u}, {e.east, turn.by_u}, {e.north, turn.by_w}, {e.south, turn.by_w}},
        kSecondTurn * pull, root, bound);
}

void add_cell(const PlateCell& c, const Plate& plate, const Vector3Array& p, double bent,
              const std::vector<double>& root, std::vector<double>& bound) {
    Turning turn{0.0, 0.0};
    if (bent != 0) {
        turn =
            turning(at(p, c.nodes[2]) - at(p, c.nodes[0]), at(p, c.nodes[3]) - at(p, c.nodes[1]));
        const double pull = std::abs(bent) * length(twist(c, plate, p, bent).moment);
        add_square<4>({Reach{c.nodes[0], turn.by_u},
                       {c.nodes[1], turn.by_w},
                       {c.nodes[2], turn.by_u},
                       {c.nodes[3], turn.by_w}},
                      kSecondTurn * pull, root, bound);
    }
    const double down = 1.0 + std::abs(bent) * turn.by_u, up = 1.0 + std::abs(bent) * turn.by_w;
    add_square<4>({Reach{c.nodes[0], down}, {c.nodes[1], up}, {c.nodes[2], down}, {c.nodes[3], up}},
                  c.left * plate.twist, root, bound);
}

}  // namespace

double plate_energy(const Lattice& lattice, const Plate& plate, const SheetState& sheet) {
    const Vector3Array& p = sheet.position;
    double energy = 0.0;
    for_each_element(lattice, plate, [&](const PlateElement& e) {
        energy += moments(e, p, plate::bent_at(lattice, sheet.rest_curvature, e.site)).energy;
    });
    for_each_cell(lattice, plate, [&](const PlateCell& c) {
        energy +=
            twist(c, plate, p, plate::bent_at(lattice, sheet.rest_curvature, c.site).twist).energy;
    });
    for (const PlateClamp& c : plate.clamps) {
        const Triple bend =
            at(p, c.next) - at(p, c.held) - Triple{c.offset.x(), c.offset.y(), c.offset.z()};
        energy += 0.5 * c.left * c.stiffness * plate::dot(bend, bend);
    }
    return energy;
}

void add_plate_diagonal(const Lattice& lattice, const Plate& plate, std::vector<double>& diagonal) {
    const auto add = [&](Index node, double k) { diagonal[static_cast<std::size_t>(node)] += k; };
    for_each_element(lattice, plate, [&](const PlateElement& e) {
        add(e.centre, e.left * 4.0 * (e.main + 2.0 * e.coupling + e.cross));
        for (const Index node : {e.west, e.east})
            add(node, node == e.centre ? 0.0 : e.left * e.main);
        for (const Index node : {e.north, e.south})
            add(node, node == e.centre ? 0.0 : e.left * e.cross);
    });
    for_each_cell(lattice, plate, [&](const PlateCell& c) {
        for (const Index node : c.nodes)
            add(node, c.left * plate.twist);
    });
    for (const PlateClamp& c : plate.clamps)
        add(c.next, c.left * c.stiffness);
}

void add_plate_bound(const Lattice& lattice, const Plate& plate, const SheetState& sheet,
                     const std::vector<double>& root, std::vector<double>& bound) {
    const Vector3Array& p = sheet.position;
    for_each_element(lattice, plate, [&](const PlateElement& e) {
        add_element(e, p, plate::bent_at(lattice, sheet.rest_curvature, e.site), root, bound);
    });
    for_each_cell(lattice, plate, [&](const PlateCell& c) {
        add_cell(c, plate, p, plate::bent_at(lattice, sheet.rest_curvature, c.site).twist, root,
                 bound);
    });
    for (const PlateClamp& c : plate.clamps)
        add_square<1>({Reach{c.next, 1.0}}, c.left * c.stiffness, root, bound);
}

}  // namespace ember
