#include "sim/plate_forces.h"

#include <algorithm>

#include "sim/kernel/plate_rows.h"

namespace ember {
namespace {

bool is_curved(const Lattice& lattice, const RestCurvature& rest, Index row) {
    const auto first = static_cast<std::size_t>(lattice.site(row, 0));
    for (std::size_t s = first; s < first + static_cast<std::size_t>(lattice.column_count); ++s) {
        if (rest.main[s] != 0 || rest.cross[s] != 0 || rest.twist[s] != 0) return true;
    }
    return false;
}

// Dense elements and cells of one row; sheets without rest curvature have no turns.
struct Row {
    Index number, above, below;  // kNone beyond the sheet
    bool curved;
};

void find_moments(const Lattice& lattice, const Plate& plate, const RestCurvature* rest,
                  const double* x, std::size_t nodes, const Row& row, PlateForces& f) {
    const Index columns = lattice.column_count;
    const auto first = static_cast<std::ptrdiff_t>(lattice.site(row.number, 0));
    const auto n = static_cast<std::ptrdiff_t>(nodes);
    const auto at = [&](Index r) {
        const double* p = x + lattice.site(r == kNone ? row.number : r, 0);
        return ConstPointers{p, p + n, p + 2 * n};
    };
    RowPointers p{};
    p.x = at(row.number), p.above = at(row.above), p.below = at(row.below);
    p.left = plate.left.data() + first, p.cell_left = plate.cell_left.data() + first;
    p.main = row_of(f.main, first), p.cross = row_of(f.cross, first);
    p.twist = row_of(f.twist, first);
    const Stiffness k{plate.main, plate.coupling, plate.cross};
    const bool inside = row.above != kNone && row.below != kNone, cells = row.below != kNone;
    if (!row.curved) {
        for (std::size_t a = 0; a < 3; ++a) {
            if (inside) {
                flat_row(columns, k, p.left, p.x[a], p.above[a], p.below[a], p.main[a], p.cross[a]);
            }
            if (cells)
                flat_cells(columns, plate.twist, p.cell_left, p.x[a], p.below[a], p.twist[a]);
        }
        return;
    }
    const double dx = lattice.column_spacing, dz = lattice.row_spacing;
    p.bent_main = rest->main.data() + first, p.bent_cross = rest->cross.data() + first;
    p.bent_twist = rest->twist.data() + first;
    p.turn_main = row_of(f.turn_main, first), p.turn_cross = row_of(f.turn_cross, first);
    p.turn_down = row_of(f.turn_down, first), p.turn_up = row_of(f.turn_up, first);
    if (inside) curved_row(columns, k, {dx * dx, dz * dz, 0.0}, p);
    if (cells) curved_cells(columns, plate.twist, dx * dz, p);
}

void clear_turns(const Lattice& lattice, Index row, PlateForces& f) {
    for (MomentArray* array : {&f.turn_main, &f.turn_cross, &f.turn_down, &f.turn_up}) {
        for (int axis = 0; axis < 3; ++axis) {
            std::fill_n(array->component(axis) + lattice.site(row, 0), lattice.column_count, 0.0);
        }
    }
}

void gather(const Lattice& lattice, std::size_t nodes, const Row& row, bool turned,
            PlateForces& f) {
    const Index columns = lattice.column_count;
    const auto here = static_cast<std::ptrdiff_t>(lattice.site(row.number, 0));
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](MomentArray& array, Index r) -> const double* {
            return r == kNone ? f.zeros.data() + 1 : array.component(axis) + lattice.site(r, 0);
        };
        double* to = f.total.data() + axis * static_cast<std::ptrdiff_t>(nodes) + here;
        gather_row(columns, at(f.main, row.number), at(f.cross, row.above), at(f.cross, row.number),
                   at(f.cross, row.below), at(f.twist, row.above), at(f.twist, row.number), to);
        if (!turned) continue;
        gather_turns(columns, at(f.turn_main, row.number), at(f.turn_cross, row.above),
                     at(f.turn_cross, row.below), at(f.turn_down, row.above),
                     at(f.turn_down, row.number), at(f.turn_up, row.above),
                     at(f.turn_up, row.number), to);
    }
}

// Adds forces to single nodes of `total`.
class Scatter {
  public:
    Scatter(const double* x, std::size_t nodes, double* total) : x_(x), n_(nodes), f_(total) {}

    [[nodiscard]] Triple at(Index node) const {
        const auto i = static_cast<std::size_t>(node);
        return {x_[i], x_[n_ + i], x_[2 * n_ + i]};
    }
    void add(Index node, const Triple& force) {
        const auto i = static_cast<std::size_t>(node);
        f_[i] += force.x, f_[n_ + i] += force.y, f_[2 * n_ + i] += force.z;
    }

  private:
    const double* x_;
    std::size_t n_;
    double* f_;
};

void add_listed(const Lattice& lattice, const Plate& plate, const RestCurvature& rest, bool linear,
                Scatter& nodes) {
    for (const PlateElement& e : plate.elements) {
        const Moments m =
            plate::moments_of({e.left * e.main, e.left * e.coupling, e.left * e.cross},
                              {nodes.at(e.centre), nodes.at(e.west), nodes.at(e.east),
                               nodes.at(e.north), nodes.at(e.south)},
                              plate::bent_at(lattice, rest, e.site));
        nodes.add(e.centre, 2.0 * (m.main + m.cross));
        nodes.add(e.west, -1.0 * (m.main + m.turn.u));
        nodes.add(e.east, m.turn.u - m.main);
        nodes.add(e.north, -1.0 * (m.cross + m.turn.w));
        nodes.add(e.south, m.turn.w - m.cross);
    }
    for (const PlateCell& c : plate.cells) {
        const auto& [i, j, k, l] = c.nodes;
        const Twist t = plate::twist_of(c.left * plate.twist, nodes.at(i), nodes.at(j), nodes.at(k),
                                        nodes.at(l), plate::bent_at(lattice, rest, c.site).twist);
        nodes.add(i, -1.0 * (t.moment + t.turn.u));
        nodes.add(j, t.moment - t.turn.w);
        nodes.add(k, t.turn.u - t.moment);
        nodes.add(l, t.moment + t.turn.w);
    }
    for (const PlateClamp& c : plate.clamps) {
        const Vector3 offset = linear ? Vector3(Vector3::Zero()) : c.offset;
        const Triple bend =
            nodes.at(c.next) - nodes.at(c.held) - Triple{offset.x(), offset.y(), offset.z()};
        nodes.add(c.next, -c.left * c.stiffness * bend);
    }
}

}  // namespace

void MomentArray::resize(Index sites) {
    const std::ptrdiff_t wanted = sites + 2;
    if (pitch == wanted) return;
    pitch = wanted;
    values.assign(3 * static_cast<std::size_t>(pitch), 0.0);
}

void PlateForces::evaluate(const Lattice& lattice, const Plate& plate, const RestCurvature& rest,
                           const double* x, std::size_t nodes, ThreadPool& pool) {
    run(lattice, plate, &rest, x, nodes, pool);
}

void PlateForces::evaluate_linear(const Lattice& lattice, const Plate& plate, const double* p,
                                  std::size_t nodes, ThreadPool& pool) {
    run(lattice, plate, nullptr, p, nodes, pool);
}

void PlateForces::run(const Lattice& lattice, const Plate& plate, const RestCurvature* rest,
                      const double* x, std::size_t nodes, ThreadPool& pool) {
    static const RestCurvature kFlat;
    const bool linear = rest == nullptr, turned = !linear && !rest->main.empty();
    for (MomentArray* array : {&main, &cross, &twist})
        array->resize(lattice.site_count());
    if (turned) {
        for (MomentArray* array : {&turn_main, &turn_cross, &turn_down, &turn_up})
            array->resize(lattice.site_count());
    }
    zeros.resize(static_cast<std::size_t>(lattice.column_count) + 2, 0.0);
    total.resize(3 * nodes);
    std::fill(total.begin(), total.end(), 0.0);
    Scatter scatter(x, nodes, total.data());
    add_listed(lattice, plate, linear ? kFlat : *rest, linear, scatter);
    constexpr std::ptrdiff_t kWork = 4;  // a node's share, in springs
    const auto row_at = [&](std::ptrdiff_t r) {
        const auto row = static_cast<Index>(r);
        return Row{row, lattice.row_at(row, -1), lattice.row_at(row, 1),
                   turned && is_curved(lattice, *rest, row)};
    };
    pool.for_rows(lattice.row_count, kWork * lattice.column_count,
                  [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                      for (std::ptrdiff_t r = begin; r < end; ++r) {
                          const Row row = row_at(r);
                          if (turned && !row.curved) clear_turns(lattice, row.number, *this);
                          find_moments(lattice, plate, rest, x, nodes, row, *this);
                      }
                  });
    pool.for_rows(lattice.row_count, kWork * lattice.column_count,
                  [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                      for (std::ptrdiff_t r = begin; r < end; ++r)
                          gather(lattice, nodes, row_at(r), turned, *this);
                  });
}

}  // namespace ember
