#include "sim/spring_forces.h"

#include <algorithm>
#include <array>

#include "sim/vectorise.h"

namespace ember {
namespace {

// `count` springs between listed nodes; see kernel/spring_kernel_loops.h for the law.
EMBER_VECTORISED void evaluate_listed(std::ptrdiff_t count, const NodeMotion m,
                                      const Index* __restrict a, const Index* __restrict b,
                                      const double* __restrict k, const double* __restrict tension,
                                      const double* __restrict d, double* __restrict fx,
                                      double* __restrict fy, double* __restrict fz,
                                      double* __restrict loss, double* __restrict friction) {
    const auto n = static_cast<std::ptrdiff_t>(m.node_count);
    const double *x = m.x, *y = m.x + n, *z = m.x + 2 * n;
    const double *vx = m.v, *vy = m.v + n, *vz = m.v + 2 * n;
    const double *w = m.drift, *wx = w, *wy = w + n, *wz = w + 2 * n;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t p = a[i], q = b[i];
        const double dx = x[q] - x[p], dy = y[q] - y[p], dz = z[q] - z[p];
        const double inverse = 1.0 / std::sqrt(dx * dx + dy * dy + dz * dz + 1e-30);
        const double rate =
            ((vx[q] - vx[p]) * dx + (vy[q] - vy[p]) * dy + (vz[q] - vz[p]) * dz) * inverse;
        const double slowing = d[i] * rate;
        const double scale = k[i] + inverse * (slowing - tension[i]);
        fx[i] = scale * dx;
        fy[i] = scale * dy;
        fz[i] = scale * dz;
        if (w == nullptr) {
            loss[i] = slowing * rate;
            continue;
        }
        const double drift =
            ((wx[q] - wx[p]) * dx + (wy[q] - wy[p]) * dy + (wz[q] - wz[p]) * dz) * inverse;
        loss[i] = 0.5 * (slowing + friction[i]) * drift;
        friction[i] = slowing;
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

constexpr std::ptrdiff_t kForceRows = kKinds * 3;  // rows of `pitch` that one lattice row has

}  // namespace

double sum_in_lanes(const double* values, std::ptrdiff_t count) {
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

void ExtraSprings::prepare(const SheetState& sheet, const SpringNetwork& network) {
    const std::size_t count = network.extra.size();
    for (auto* array : {&stiffness, &tension, &damping, &x, &y, &z, &loss})
        array->resize(count);
    a.resize(count);
    b.resize(count);
    friction.assign(count, 0.0);
    total.assign(count > 0 ? 3 * sheet.mass.size() : 0, 0.0);
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
    evaluate_listed(count, motion, a.data(), b.data(), stiffness.data(), tension.data(),
                    damping.data(), x.data(), y.data(), z.data(), loss.data(), friction.data());
    const std::size_t n = motion.node_count;
    for (std::size_t t = 0; t < network.end_nodes.size(); ++t) {
        double fx = 0.0, fy = 0.0, fz = 0.0;
        for (Index e = network.end_begin[t]; e < network.end_begin[t + 1]; ++e) {
            const ExtraEnd& end = network.ends[static_cast<std::size_t>(e)];
            const auto i = static_cast<std::size_t>(end.spring);
            fx += end.sign * x[i];
            fy += end.sign * y[i];
            fz += end.sign * z[i];
        }
        const auto node = static_cast<std::size_t>(network.end_nodes[t]);
        total[node] = fx;
        total[n + node] = fy;
        total[2 * n + node] = fz;
    }
    return sum_in_lanes(loss.data(), count);
}

void SpringForces::prepare(const Lattice& lattice, const SheetState& sheet,
                           const SpringNetwork& network, int threads) {
    const std::ptrdiff_t padded = padded_columns(lattice.column_count);
    const std::ptrdiff_t row_size = padded * kKinds * kConstants;
    pitch = padded + kBlockColumns;
    const auto rows = static_cast<std::size_t>(lattice.row_count);
    constants.resize(rows * static_cast<std::size_t>(row_size));
    for (Index row = 0; row < lattice.row_count; ++row) {
        for (std::ptrdiff_t kind = 0; kind < kKinds; ++kind) {
            const auto slot = static_cast<std::size_t>(
                lattice.slot(static_cast<Slot>(kind), lattice.site(row, 0)));
            pack_row(lattice.column_count, &network.stiffness[slot], &network.damping[slot],
                     &sheet.rest_length[slot],
                     constants.data() + row * row_size + kind * kConstants * kBlockColumns);
        }
    }
    const auto force_rows = static_cast<std::size_t>(kForceRows * pitch);
    no_forces.assign_zero(force_rows + kBlockColumns);
    rings.resize(static_cast<std::size_t>(threads));
    for (AlignedArray& ring : rings)
        ring.assign_zero(3 * force_rows + static_cast<std::size_t>(5 * pitch));
    friction.assign_zero(rows * static_cast<std::size_t>(padded * kKinds));
    row_damping.assign(rows, 0.0);
    row_drag.assign(rows, 0.0);
    extra.prepare(sheet, network);
}

RowForces::RowForces(const Lattice& lattice, const NodeMotion& motion, const SpringKernel& kernel,
                     SpringForces& forces, int thread)
    : lattice_(lattice),
      motion_(motion),
      kernel_(kernel),
      forces_(forces),
      ring_(forces.rings[static_cast<std::size_t>(thread)].data() + kBlockColumns),
      total_(ring_ + 3 * kForceRows * forces.pitch),
      loss_(total_ + 3 * forces.pitch) {}

double* RowForces::kept(Index row) {
    return ring_ + (row + 3) % 3 * kForceRows * forces_.pitch;
}

// Springs anchored at `row`, which on a closed sheet may be given as a row before the first.
void RowForces::evaluate(Index row, bool drift) {
    const Index r = (row + lattice_.row_count) % lattice_.row_count;
    const auto column_0 = [&](Index offset) {
        const Index other = lattice_.row_at(r, offset);
        // springs to rows that do not exist have constants 0; any node will do as their end
        return static_cast<std::ptrdiff_t>(lattice_.site(other == kNone ? r : other, 0));
    };
    const std::ptrdiff_t begin[] = {column_0(0), column_0(1), column_0(2)};
    const std::ptrdiff_t row_size = padded_columns(lattice_.column_count) * kKinds * kConstants;
    const SpringRow springs{{motion_.x + begin[0], motion_.x + begin[1], motion_.x + begin[2]},
                            {motion_.v + begin[0], motion_.v + begin[1], motion_.v + begin[2]},
                            static_cast<std::ptrdiff_t>(motion_.node_count),
                            forces_.constants.data() + r * row_size,
                            lattice_.column_count,
                            kept(row),
                            forces_.pitch,
                            loss_};
    if (!drift) return kernel_.evaluate(springs);
    SpringRow drifting = springs;
    for (std::size_t i = 0; i < 3; ++i)
        drifting.drift[i] = motion_.drift + begin[i];
    drifting.friction =
        forces_.friction.data() + r * padded_columns(lattice_.column_count) * kKinds;
    kernel_.evaluate_drift(drifting);
}

void RowForces::start(Index row) {
    for (const Index above : {row - 2, row - 1}) {
        // only their forces are wanted: their losses are those of another part
        if (above >= 0 || lattice_.closed) evaluate(above, false);
    }
}

void RowForces::next(Index row) {
    evaluate(row, motion_.drift != nullptr);
    forces_.row_damping[static_cast<std::size_t>(row)] = sum_in_lanes(loss_, lattice_.column_count);
    const auto rows_above = [&](Index above) -> const double* {
        const bool exists = above >= 0 || lattice_.closed;
        return exists ? kept(above) : forces_.no_forces.data() + kBlockColumns;
    };
    kernel_.gather({kept(row), rows_above(row - 1), rows_above(row - 2), forces_.pitch,
                    lattice_.column_count, total_});
}

}  // namespace ember
