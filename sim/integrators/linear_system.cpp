#include "sim/integrators/linear_system.h"

#include <algorithm>
#include <cmath>

#include "sim/integrators/link_rows.h"

namespace ember {
namespace {

constexpr std::ptrdiff_t kGroup = 128;  // nodes whose products are summed up together
constexpr Index kRowsSpanned[kSlotCount] = {0, 1, 1, 1, 0, 2};  // by each kind of slot

// Calls visit(count, i, j, slot) for every kind of springs at the nodes of a row: `count` springs
// from nodes i+n in the row to nodes j+n, of slots slot+n; always in the same order.
template <class Visitor>
void for_links_of_row(const Lattice& lattice, Index row, Visitor&& visit) {
    for_springs_of_row(lattice, row, [&](Index count, Index a, Index b, std::size_t slot) {
        visit(count, a, b, slot);
    });
    for (Index above = 0; above <= 2; ++above) {
        const Index from = lattice.row_at(row, -above);
        if (from == kNone) continue;
        for_springs_of_row(lattice, from, [&](Index count, Index a, Index b, std::size_t slot) {
            const auto kind = static_cast<Index>(slot) / lattice.site_count();
            if (kRowsSpanned[kind] == above) visit(count, b, a, slot);
        });
    }
}

// The rows of the lattice, then the copies in one.
template <class Body>
void for_rows(const Mechanics& m, std::ptrdiff_t work, Body&& body) {
    const auto columns = static_cast<std::ptrdiff_t>(m.lattice.column_count);
    m.pool.for_rows(m.lattice.row_count, work * columns,
                    [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                        for (std::ptrdiff_t row = begin; row < end; ++row)
                            body(static_cast<Index>(row), row * columns, columns);
                    });
    const std::ptrdiff_t sites = m.lattice.site_count();
    const std::ptrdiff_t copies = static_cast<std::ptrdiff_t>(m.node_count()) - sites;
    if (copies > 0) body(kNone, sites, copies);
}

// Sums that do not depend on the number of threads: body(first, count, group) by groups of nodes.
template <class Body>
void for_groups(const Mechanics& m, Body&& body) {
    const auto nodes = static_cast<std::ptrdiff_t>(m.node_count());
    const std::ptrdiff_t groups = (nodes + kGroup - 1) / kGroup;
    m.pool.for_rows(groups, 4 * kGroup, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
        for (std::ptrdiff_t g = begin; g < end; ++g)
            body(g * kGroup, std::min(kGroup, nodes - g * kGroup), static_cast<std::size_t>(g));
    });
}

double sum_of(const std::vector<double>& sums) {
    return sum_in_lanes(sums.data(), static_cast<std::ptrdiff_t>(sums.size()));
}

template <class Pointer>
std::array<Pointer, 3> components(Pointer p, std::size_t nodes, std::ptrdiff_t first) {
    const auto n = static_cast<std::ptrdiff_t>(nodes);
    return {p + first, p + n + first, p + 2 * n + first};
}

}  // namespace

void LinearSystem::begin(const Mechanics& m) {
    const std::size_t n = m.node_count(), slots = m.network.stiffness.size();
    for (auto* array : {&mass_, &inverse_mass_, &drag_, &plate_})
        array->resize(n);
    total_mass_ = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
        inverse_mass_[i] = m.loads.inverse_mass[i];
        mass_[i] = inverse_mass_[i] > 0 ? 1.0 / inverse_mass_[i] : 0.0;
        drag_[i] = m.loads.has_drag ? m.loads.drag[i] : 0.0;
        total_mass_ += mass_[i];
    }
    std::fill(plate_.begin(), plate_.end(), 0.0);
    if (m.plate != nullptr) add_plate_diagonal(m.lattice, *m.plate, plate_);
    for (auto& array : axis_)
        array.resize(slots, 0.0);
    along_.resize(slots, 0.0), across_.resize(slots, 0.0);
    extra_.resize(m.network.extra.size());
    for (auto& array : block_)
        array.resize(n);
    for (auto* array : {&right_, &residual_, &z_, &direction_, &product_})
        array->resize(3 * n);
    const std::size_t groups = (n + kGroup - 1) / kGroup;
    sums_.resize(groups), mass_sums_.resize(groups);
}

void LinearSystem::assemble(const Mechanics& m, const double* x, double s) {
    s_ = s;
    const std::size_t n = m.node_count();
    m.pool.for_rows(m.lattice.row_count, kSlotCount * m.lattice.column_count,
                    [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                        for (std::ptrdiff_t row = begin; row < end; ++row) {
                            for_springs_of_row(
                                m.lattice, static_cast<Index>(row),
                                [&](Index count, Index a, Index b, std::size_t slot) {
                                    linearise(count, components(x, n, a), components(x, n, b),
                                              &m.network.stiffness[slot],
                                              &m.sheet.rest_length[slot],
                                              {&axis_[0][slot], &axis_[1][slot], &axis_[2][slot]},
                                              &along_[slot], &across_[slot]);
                                });
                        }
                    });
    for (std::size_t e = 0; e < extra_.size(); ++e) {
        const ExtraSpring& spring = m.network.extra[e];
        const auto i = static_cast<std::size_t>(spring.a), j = static_cast<std::size_t>(spring.b);
        const Vector3 edge(x[j] - x[i], x[n + j] - x[n + i], x[2 * n + j] - x[2 * n + i]);
        const double length = edge.norm(), k = m.network.extra_stiffness[e];
        const double rest = m.sheet.rest_length[static_cast<std::size_t>(spring.slot)];
        if (!(length > 0)) {
            extra_[e] = {Vector3::Zero(), 0.0, 0.0};
            continue;
        }
        extra_[e] = {edge / length, k, std::max(0.0, k * (1.0 - rest / length))};
    }
    sum_blocks(m, s);
}

// The diagonal blocks of M + s D + s² K, and their inverse.
void LinearSystem::sum_blocks(const Mechanics& m, double s) {
    const auto at = [&](std::ptrdiff_t first) {
        std::array<double*, 6> p{};
        for (std::size_t c = 0; c < p.size(); ++c)
            p[c] = block_[c].data() + first;
        return p;
    };
    for_rows(m, kSlotCount, [&](Index row, std::ptrdiff_t first, std::ptrdiff_t count) {
        begin_blocks(count, s, mass_.data() + first, drag_.data() + first, plate_.data() + first,
                     at(first));
        if (row == kNone) return;
        for_links_of_row(m.lattice, row, [&](Index links, Index i, Index, std::size_t slot) {
            add_blocks(links, s, {&axis_[0][slot], &axis_[1][slot], &axis_[2][slot]}, &along_[slot],
                       &across_[slot], &m.network.damping[slot], at(i));
        });
    });
    for (std::size_t e = 0; e < extra_.size(); ++e) {
        const Link& link = extra_[e];
        const double damping = m.network.extra_damping[e];
        for (const Index node : {m.network.extra[e].a, m.network.extra[e].b}) {
            add_blocks(1, s, {&link.axis.x(), &link.axis.y(), &link.axis.z()}, &link.along,
                       &link.across, &damping, at(node));
        }
    }
    for_rows(m, 1, [&](Index, std::ptrdiff_t first, std::ptrdiff_t count) {
        invert_blocks(count, mass_.data() + first, at(first));
    });
}

// product_ = (mass M + damping D + stiffness K) p; rows of held nodes are 0.
void LinearSystem::apply(const Mechanics& m, const double* p, const Factors& f) {
    const std::size_t n = m.node_count();
    if (m.plate != nullptr) m.plate_forces->evaluate_linear(m.lattice, *m.plate, p, n, m.pool);
    for_rows(m, 2 * kSlotCount, [&](Index row, std::ptrdiff_t first, std::ptrdiff_t count) {
        const auto out = components(product_.data(), n, first);
        begin_product(count, f.mass, f.damping, mass_.data() + first, drag_.data() + first,
                      components(p, n, first), out);
        if (m.plate != nullptr) {
            add_scaled(count, -f.stiffness,
                       components<const double*>(m.plate_forces->total.data(), n, first), out);
        }
        if (row != kNone) {
            for_links_of_row(m.lattice, row, [&](Index links, Index i, Index j, std::size_t slot) {
                add_links(links, f.damping, f.stiffness,
                          {&axis_[0][slot], &axis_[1][slot], &axis_[2][slot]}, &along_[slot],
                          &across_[slot], &m.network.damping[slot], components(p, n, i),
                          components(p, n, j), components(product_.data(), n, i));
            });
        }
        hold(count, mass_.data() + first, out);
    });
    add_extra(m, p, f);
}

void LinearSystem::add_extra(const Mechanics& m, const double* p, const Factors& f) {
    const std::size_t n = m.node_count();
    for (std::size_t e = 0; e < extra_.size(); ++e) {
        const Link& link = extra_[e];
        const auto i = static_cast<std::size_t>(m.network.extra[e].a),
                   j = static_cast<std::size_t>(m.network.extra[e].b);
        const Vector3 d(p[i] - p[j], p[n + i] - p[n + j], p[2 * n + i] - p[2 * n + j]);
        const double along =
            f.damping * m.network.extra_damping[e] + f.stiffness * (link.along - link.across);
        const Vector3 force = f.stiffness * link.across * d + along * link.axis.dot(d) * link.axis;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double component = force[static_cast<Eigen::Index>(axis)];
            if (mass_[i] > 0) product_[axis * n + i] += component;
            if (mass_[j] > 0) product_[axis * n + j] -= component;
        }
    }
}

LinearSystem::Norms LinearSystem::precondition(const Mechanics& m,
                                               const std::vector<double>& residual) {
    const std::size_t n = m.node_count();
    for_groups(m, [&](std::ptrdiff_t first, std::ptrdiff_t count, std::size_t group) {
        std::array<double, kGroup> own{}, by_mass{};
        std::array<const double*, 6> block{};
        for (std::size_t c = 0; c < block.size(); ++c)
            block[c] = block_[c].data() + first;
        multiply_blocks(count, block, inverse_mass_.data() + first,
                        components(residual.data(), n, first), components(z_.data(), n, first),
                        own.data(), by_mass.data());
        sums_[group] = sum_in_lanes(own.data(), count);
        mass_sums_[group] = sum_in_lanes(by_mass.data(), count);
    });
    return {sum_of(sums_), sum_of(mass_sums_)};
}

void LinearSystem::right_side(const Mechanics& m, const double* r_x, const double* r_v) {
    const std::size_t n = m.node_count();
    apply(m, r_x, {0.0, 0.0, s_});
    for_groups(m, [&](std::ptrdiff_t first, std::ptrdiff_t count, std::size_t) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(axis * n) + first;
            subtract_scaled(count, mass_.data() + first, r_v + at, product_.data() + at,
                            right_.data() + at);
        }
    });
}

// One step of the conjugate gradients along direction_, whose residual has the norm rz.
double LinearSystem::advance(const Mechanics& m, double* k, double rz) {
    const std::size_t n = m.node_count();
    apply(m, direction_.data(), {1.0, s_, s_ * s_});
    for_groups(m, [&](std::ptrdiff_t first, std::ptrdiff_t count, std::size_t group) {
        std::array<double, kGroup> terms{};
        dot_terms(count, components<const double*>(direction_.data(), n, first),
                  components<const double*>(product_.data(), n, first), terms.data());
        sums_[group] = sum_in_lanes(terms.data(), count);
    });
    const double alpha = rz / sum_of(sums_);
    for_groups(m, [&](std::ptrdiff_t first, std::ptrdiff_t count, std::size_t) {
        add_scaled(count, alpha, components<const double*>(direction_.data(), n, first),
                   components(k, n, first));
        add_scaled(count, -alpha, components<const double*>(product_.data(), n, first),
                   components(residual_.data(), n, first));
    });
    return alpha;
}

int LinearSystem::solve(const Mechanics& m, double error, double* k) {
    constexpr int kMostIterations = 4000;
    constexpr double kTolerance = 1e-8;
    const std::size_t n = m.node_count();
    apply(m, k, {1.0, s_, s_ * s_});
    for (std::size_t i = 0; i < 3 * n; ++i)
        residual_[i] = right_[i] - product_[i];
    const double limit = kTolerance * kTolerance * precondition(m, right_).preconditioned;
    const double mass_limit = error * error * total_mass_;
    Norms norms = precondition(m, residual_);
    std::copy(z_.begin(), z_.end(), direction_.begin());
    for (int iteration = 0; iteration < kMostIterations; ++iteration) {
        if (norms.preconditioned <= limit || norms.by_mass <= mass_limit) return iteration;
        if (!std::isfinite(norms.preconditioned)) return -iteration - 1;
        (void)advance(m, k, norms.preconditioned);
        const double before = norms.preconditioned;
        norms = precondition(m, residual_);
        const double beta = norms.preconditioned / before;
        for_groups(m, [&](std::ptrdiff_t first, std::ptrdiff_t count, std::size_t) {
            turn(count, beta, components<const double*>(z_.data(), n, first),
                 components(direction_.data(), n, first));
        });
    }
    return -kMostIterations;
}

}  // namespace ember
