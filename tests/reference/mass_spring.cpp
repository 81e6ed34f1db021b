#include "mass_spring.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace ember::reference {
namespace {

// Makes the springs of a sheet, quad by quad.
class SpringMaker {
  public:
    SpringMaker(const Lattice& lattice, const SheetState& sheet, const Params& params,
                std::vector<Spring>& springs)
        : lattice_(lattice), sheet_(sheet), params_(params), springs_(springs) {}

    void make() {
        for (Index r = 0; r < lattice_.cell_rows; ++r) {
            for (Index c = 0; c < lattice_.cell_columns; ++c) {
                edges(r, c);
                bends(r, c);
            }
        }
    }

  private:
    const Quad* quad(Index r, Index c) const {
        if (lattice_.closed) r = (r + lattice_.cell_rows) % lattice_.cell_rows;
        if (r < 0 || r >= lattice_.cell_rows || c < 0 || c >= lattice_.cell_columns) return nullptr;
        return &sheet_.quads[static_cast<std::size_t>(r * lattice_.cell_columns + c)];
    }

    Index site(Index r, Index c) const {
        return r % lattice_.row_count * lattice_.column_count + c;
    }

    bool glued(Index at, int direction) const {
        return (sheet_.glue[static_cast<std::size_t>(at)] & (1u << direction)) != 0;
    }

    double burnt(Index node) const {
        const auto n = static_cast<std::size_t>(node);
        return params_.springs.follows_mass ? sheet_.mass[n] / sheet_.initial_mass[n] : 1.0;
    }

    // `beyond` is what lies on the other side of the line that the spring lies on.
    void add_half(Index a, Index b, Slot kind, Index anchor, const Quad* beyond) {
        const bool whole = lattice_.border == Border::Uniform && beyond == nullptr;
        add(a, b, kind, anchor, whole ? 1.0 : 0.5);
    }

    void add(Index a, Index b, Slot kind, Index anchor, double share) {
        const auto slot = static_cast<std::size_t>(
            static_cast<Index>(kind) * lattice_.row_count * lattice_.column_count + anchor);
        const double factor = share * std::min(burnt(a), burnt(b));
        springs_.push_back({a, b, lattice_.stiffness[slot] * factor,
                            lattice_.damping[slot] * factor, sheet_.rest_length[slot]});
    }

    void edges(Index r, Index c) {
        const Quad& q = *quad(r, c);
        add_half(q[0], q[1], Slot::Main, site(r, c), quad(r - 1, c));
        add_half(q[3], q[2], Slot::Main, site(r + 1, c), quad(r + 1, c));
        add_half(q[0], q[3], Slot::Cross, site(r, c), quad(r, c - 1));
        add_half(q[1], q[2], Slot::Cross, site(r, c + 1), quad(r, c + 1));
        add(q[0], q[2], Slot::DiagDown, site(r, c), 1.0);
        add(q[1], q[3], Slot::DiagUp, site(r, c), 1.0);
    }

    // Across two neighbouring quads, on both of their sides, where they hold together.
    void bends(Index r, Index c) {
        const Quad& q = *quad(r, c);
        if (const Quad* p = quad(r, c + 1)) {
            if (glued(site(r, c + 1), 1)) {
                add_half(q[0], (*p)[1], Slot::BendMain, site(r, c), quad(r - 1, c));
            }
            if (glued(site(r + 1, c + 1), 3)) {
                add_half(q[3], (*p)[2], Slot::BendMain, site(r + 1, c), quad(r + 1, c));
            }
        }
        if (const Quad* p = quad(r + 1, c)) {
            if (glued(site(r + 1, c), 0)) {
                add_half(q[0], (*p)[3], Slot::BendCross, site(r, c), quad(r, c - 1));
            }
            if (glued(site(r + 1, c + 1), 2)) {
                add_half(q[1], (*p)[2], Slot::BendCross, site(r, c + 1), quad(r, c + 1));
            }
        }
    }

    const Lattice& lattice_;
    const SheetState& sheet_;
    const Params& params_;
    std::vector<Spring>& springs_;
};

void set_normals(const SheetState& sheet, std::vector<Node>& nodes) {
    for (const Quad& q : sheet.quads) {
        const auto at = [&](std::size_t k) {
            return nodes[static_cast<std::size_t>(q[k])].position;
        };
        const Vector3 area = (at(2) - at(0)).cross(at(3) - at(1));
        for (const Index n : q)
            nodes[static_cast<std::size_t>(n)].normal += area;
    }
    for (Node& node : nodes) {
        if (node.normal.norm() > 0) node.normal /= node.normal.norm();
    }
}

// The two halves of a spring between two quads are one spring again.
void merge(std::vector<Spring>& springs) {
    const auto ends = [](const Spring& s) { return std::pair(s.a, s.b); };
    std::stable_sort(springs.begin(), springs.end(),
                     [&](const Spring& p, const Spring& q) { return ends(p) < ends(q); });
    std::vector<Spring> merged;
    for (const Spring& spring : springs) {
        const bool again = !merged.empty() && ends(merged.back()) == ends(spring) &&
                           merged.back().rest == spring.rest;
        if (!again) {
            merged.push_back(spring);
            continue;
        }
        merged.back().stiffness += spring.stiffness;
        merged.back().damping += spring.damping;
    }
    springs.swap(merged);
}

// The sheet moved from `from` for `h` [s] with velocities and accelerations of `rate`.
void move(const MassSpringSheet& from, const std::vector<Vector3>& velocity,
          const std::vector<Vector3>& acceleration, double h, MassSpringSheet& to) {
    for (std::size_t i = 0; i < from.nodes.size(); ++i) {
        to.nodes[i].position = from.nodes[i].position + h * velocity[i];
        to.nodes[i].velocity = from.nodes[i].velocity + h * acceleration[i];
    }
}

}  // namespace

MassSpringSheet make_mass_springs(const Lattice& lattice, const SheetState& sheet,
                                  const Params& params) {
    MassSpringSheet made;
    made.drag_tangential = params.world.air_drag_tangential;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        const double gravity =
            params.world.gravity * (sheet.piece_held[n] != 0 ? params.world.held_gravity : 1.0);
        Node node;
        node.position = sheet.position.at(n);
        node.velocity = sheet.velocity.at(n);
        node.load = Vector3(0, -sheet.mass[n] * gravity, 0);
        node.normal.setZero();
        node.mass = sheet.mass[n];
        node.drag = params.world.air_drag * sheet.initial_mass[n] / params.paper.grammage;
        node.held = sheet.held[n] != 0;
        made.nodes.push_back(node);
    }
    set_normals(sheet, made.nodes);
    SpringMaker(lattice, sheet, params, made.springs).make();
    merge(made.springs);
    return made;
}

void accelerations(const MassSpringSheet& sheet, std::vector<Vector3>& result) {
    result.resize(sheet.nodes.size());
    for (std::size_t i = 0; i < sheet.nodes.size(); ++i) {
        const Node& node = sheet.nodes[i];
        result[i] = node.load;
        if (node.drag == 0) continue;
        const Vector3 across = node.velocity.dot(node.normal) * node.normal;
        result[i] -= node.drag * (across + sheet.drag_tangential * (node.velocity - across));
    }
    for (const Spring& spring : sheet.springs) {
        const auto a = static_cast<std::size_t>(spring.a), b = static_cast<std::size_t>(spring.b);
        const Vector3 edge = sheet.nodes[b].position - sheet.nodes[a].position;
        const double length = edge.norm();
        const Vector3 n = edge / length;
        const double rate = (sheet.nodes[b].velocity - sheet.nodes[a].velocity).dot(n);
        const Vector3 force =
            (spring.stiffness * (length - spring.rest) + spring.damping * rate) * n;
        result[a] += force;
        result[b] -= force;
    }
    for (std::size_t i = 0; i < sheet.nodes.size(); ++i) {
        if (sheet.nodes[i].held) {
            result[i].setZero();
        } else {
            result[i] /= sheet.nodes[i].mass;
        }
    }
}

void step_runge_kutta(MassSpringSheet& sheet, double h) {
    const std::size_t n = sheet.nodes.size();
    MassSpringSheet stage = sheet;
    std::vector<Vector3> v(n), a, sum_v(n, Vector3::Zero()), sum_a(n, Vector3::Zero());
    constexpr double kWeight[] = {1, 2, 2, 1}, kAhead[] = {0.5, 0.5, 1, 0};
    for (int s = 0; s < 4; ++s) {
        accelerations(stage, a);
        for (std::size_t i = 0; i < n; ++i) {
            v[i] = stage.nodes[i].velocity;
            sum_v[i] += kWeight[s] * v[i];
            sum_a[i] += kWeight[s] * a[i];
        }
        move(sheet, v, a, kAhead[s] * h, stage);
    }
    move(sheet, sum_v, sum_a, h / 6, sheet);
}

}  // namespace ember::reference
