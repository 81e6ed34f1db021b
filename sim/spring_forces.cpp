#include "sim/spring_forces.h"

#include <algorithm>
#include <array>

#include "sim/old_rows.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

// `count` springs between listed nodes; see kernel/spring_kernel_loops.h for the law.
EMBER_VECTORISED void evaluate_listed(std::ptrdiff_t count, const NodeMotion m,
                                      const Index* __restrict a, const Index* __restrict b,
                                      const double* __restrict k, const double* __restrict tension,
                                      const double* __restrict d,
                                      const std::array<double*, 6>& pull, double* __restrict loss) {
    const auto n = static_cast<std::ptrdiff_t>(m.node_count);
    const double *x = m.x, *y = m.x + n, *z = m.x + 2 * n;
    const double *vx = m.v, *vy = m.v + n, *vz = m.v + 2 * n;
    double *fx = pull[0], *fy = pull[1], *fz = pull[2], *gx = pull[3], *gy = pull[4], *gz = pull[5];
    // nothing overlaps, but there are too many arrays for the compiler to check
#pragma GCC ivdep
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t p = a[i], q = b[i];
        const double dx = x[q] - x[p], dy = y[q] - y[p], dz = z[q] - z[p];
        const double inverse = 1.0 / std::sqrt(dx * dx + dy * dy + dz * dz + 1e-30);
        const double rate =
            ((vx[q] - vx[p]) * dx + (vy[q] - vy[p]) * dy + (vz[q] - vz[p]) * dz) * inverse;
        const double friction = d[i] * rate, share = inverse * friction;
        const double scale = k[i] + inverse * (friction - tension[i]);
        fx[i] = scale * dx, fy[i] = scale * dy, fz[i] = scale * dz;
        gx[i] = share * dx, gy[i] = share * dy, gz[i] = share * dz;
        loss[i] = friction * rate;
    }
}

// Packs the constants of one kind of springs of a row into every kKinds-th group of a block.
EMBER_VECTORISED void pack_row(std::ptrdiff_t columns, const double* __restrict stiffness,
                               const double* __restrict damping, const double* __restrict rest,
                               double* __restrict packed) {
    for (std::ptrdiff_t begin = 0; begin < columns;
         begin += kBlockColumns, packed += kKinds * kConstants * kBlockColumns) {
        const std::ptrdiff_t lanes =
            columns - begin < kBlockColumns ? columns - begin : kBlockColumns;
        if (lanes == kBlockColumns) {  // of known length, so that it becomes a few vector moves
            for (std::ptrdiff_t i = 0; i < kBlockColumns; ++i) {
                packed[i] = stiffness[begin + i];
                packed[kBlockColumns + i] = stiffness[begin + i] * rest[begin + i];
                packed[2 * kBlockColumns + i] = damping[begin + i];
            }
            continue;
        }
        for (std::ptrdiff_t i = 0; i < kBlockColumns; ++i) {
            const bool real = i < lanes;
            packed[i] = real ? stiffness[begin + i] : 0.0;
            packed[kBlockColumns + i] = real ? stiffness[begin + i] * rest[begin + i] : 0.0;
            packed[2 * kBlockColumns + i] = real ? damping[begin + i] : 0.0;
        }
    }
}

}  // namespace

EMBER_VECTORISED double sum_in_lanes(const double* values, std::ptrdiff_t count) {
    std::array<double, kBlockColumns> sum{};
    std::ptrdiff_t i = 0;
    for (; i + kBlockColumns <= count; i += kBlockColumns) {
        for (std::size_t lane = 0; lane < kBlockColumns; ++lane)
            sum[lane] += values[static_cast<std::size_t>(i) + lane];
    }
    for (std::size_t lane = 0; i < count; ++i, ++lane)
        sum[lane] += values[i];
    return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

void ExtraSprings::prepare(const Lattice& lattice, const SheetState& sheet,
                           const SpringNetwork& network) {
    const std::size_t count = network.extra.size();
    for (auto* array : {&stiffness, &tension, &damping, &loss})
        array->resize(count);
    for (auto& component : pull)
        component.resize(count);
    a.resize(count);
    b.resize(count);
    total.assign(count > 0 ? 6 * sheet.mass.size() : 0, 0.0);
    in_row.assign(static_cast<std::size_t>(lattice.row_count), 0);
    for (const Index node : network.end_nodes) {
        if (node < lattice.site_count()) in_row[static_cast<std::size_t>(lattice.row_of(node))] = 1;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const ExtraSpring& spring = network.extra[i];
        a[i] = spring.a;
        b[i] = spring.b;
        stiffness[i] = network.extra_stiffness[i];
        tension[i] = stiffness[i] * sheet.rest_length[static_cast<std::size_t>(spring.slot)];
        damping[i] = network.extra_damping[i];
    }
}

double ExtraSprings::evaluate(const SpringNetwork& network, const NodeMotion& motion) {
    const auto count = static_cast<std::ptrdiff_t>(a.size());
    if (count == 0) return 0.0;
    std::array<double*, 6> pulls{};
    for (std::size_t c = 0; c < pulls.size(); ++c)
        pulls[c] = pull[c].data();
    evaluate_listed(count, motion, a.data(), b.data(), stiffness.data(), tension.data(),
                    damping.data(), pulls, loss.data());
    const std::size_t n = motion.node_count;
    for (std::size_t t = 0; t < network.end_nodes.size(); ++t) {
        std::array<double, 6> sum{};
        for (Index e = network.end_begin[t]; e < network.end_begin[t + 1]; ++e) {
            const ExtraEnd& end = network.ends[static_cast<std::size_t>(e)];
            for (std::size_t c = 0; c < sum.size(); ++c)
                sum[c] += end.sign * pulls[c][end.spring];
        }
        const auto node = static_cast<std::size_t>(network.end_nodes[t]);
        for (std::size_t c = 0; c < sum.size(); ++c)
            total[c * n + node] = sum[c];
    }
    return sum_in_lanes(loss.data(), count);
}

void SpringForces::prepare(const Lattice& lattice, const SheetState& sheet,
                           const SpringNetwork& network, ThreadPool& pool) {
    const std::ptrdiff_t padded = padded_columns(lattice.column_count);
    const std::ptrdiff_t row_size = padded * kKinds * kConstants;
    pitch = padded;
    const auto rows = static_cast<std::size_t>(lattice.row_count);
    constants.resize(rows * static_cast<std::size_t>(row_size));
    pool.for_rows(
        lattice.row_count, kKinds * padded, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            for (std::ptrdiff_t row = begin; row < end; ++row) {
                for (std::ptrdiff_t kind = 0; kind < kKinds; ++kind) {
                    const auto slot = static_cast<std::size_t>(lattice.slot(
                        static_cast<Slot>(kind), lattice.site(static_cast<Index>(row), 0)));
                    pack_row(lattice.column_count, &network.stiffness[slot], &network.damping[slot],
                             &sheet.rest_length[slot],
                             constants.data() + row * row_size + kind * kConstants * kBlockColumns);
                }
            }
        });
    const auto threads = static_cast<std::size_t>(pool.size());
    rings.resize(threads);
    for (AlignedArray& ring : rings)
        ring.assign_zero(static_cast<std::size_t>(24 * pitch));
    finishing.resize(threads);
    for (AlignedArray& scratch : finishing)
        scratch.resize(static_cast<std::size_t>(4 * pitch));
    row_damping.assign(rows, 0.0);
    row_drag.assign(rows, 0.0);
    extra.prepare(lattice, sheet, network);
}

RowForces::RowForces(const Lattice& lattice, const NodeMotion& motion, const OldRows* old,
                     const SpringKernel& kernel, SpringForces& forces, int thread)
    : lattice_(lattice),
      motion_(motion),
      old_(old),
      kernel_(kernel),
      forces_(forces),
      ring_(forces.rings[static_cast<std::size_t>(thread)].data()),
      force_(ring_ + 18 * forces.pitch) {}

double* RowForces::kept(Index row) {
    return ring_ + (row + 3) % 3 * 6 * forces_.pitch;
}

// Springs anchored at `row`, which on a closed sheet may be given as a row before the first.
void RowForces::evaluate(Index row) {
    const Index r = row < 0 ? row + lattice_.row_count : row;
    const OldRows::View old = old_ != nullptr ? old_->find(r) : OldRows::View{};
    const bool copied = old.motion.node_count > 0;
    const NodeMotion& from = copied ? old.motion : motion_;
    const auto column_0 = [&](Index offset) {
        const Index other = lattice_.row_at(r, offset);
        // springs to rows that do not exist have constants 0; any node will do as their end
        const Index shown = copied ? old.row + offset : other;
        return static_cast<std::ptrdiff_t>(other == kNone ? (copied ? old.row : r) : shown) *
               lattice_.column_count;
    };
    const std::ptrdiff_t begin[] = {column_0(0), column_0(1), column_0(2)};
    const std::ptrdiff_t row_size = padded_columns(lattice_.column_count) * kKinds * kConstants;
    const SpringRow springs{{from.x + begin[0], from.x + begin[1], from.x + begin[2]},
                            {from.v + begin[0], from.v + begin[1], from.v + begin[2]},
                            static_cast<std::ptrdiff_t>(from.node_count),
                            forces_.constants.data() + r * row_size,
                            lattice_.column_count,
                            {kept(row), kept(row + 1), kept(row + 2)},
                            force_,
                            forces_.pitch,
                            loss_.data()};
    if (old_ != nullptr) {
        kernel_.evaluate_split(springs);
    } else {
        kernel_.evaluate(springs);
    }
}

void RowForces::start(Index row) {
    // what does not come from above must not come from an earlier span either
    std::fill_n(ring_, 18 * forces_.pitch, 0.0);
    for (const Index above : {row - 2, row - 1}) {
        if (above >= 0 || lattice_.closed) evaluate(above);
    }
}

void RowForces::next(Index row) {
    evaluate(row);
    forces_.row_damping[static_cast<std::size_t>(row)] = sum_in_lanes(loss_.data(), kBlockColumns);
}

}  // namespace ember
