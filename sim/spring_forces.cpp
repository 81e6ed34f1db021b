#include "sim/spring_forces.h"

#include <cmath>

#include "sim/vectorise.h"

namespace ember {
namespace {

#ifdef EMBERLEAF_PLANT_FORCE_ERROR
// For the test of the energy ledger only: a law that breaks Newton's third by one per cent.
constexpr double kReaction = 1.01;
#else
constexpr double kReaction = 1.0;
#endif

// `count` springs between nodes a+i and b+i. All pointers are to the first spring's data.
EMBER_VECTORISED void evaluate_run(std::ptrdiff_t count, const NodeMotion& m, std::ptrdiff_t a,
                                   std::ptrdiff_t b, const double* __restrict k,
                                   const double* __restrict d, const double* __restrict rest,
                                   double weight, double* __restrict fx, double* __restrict fy,
                                   double* __restrict fz, double* __restrict dissipated) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = m.x[b + i] - m.x[a + i];
        const double dy = m.y[b + i] - m.y[a + i];
        const double dz = m.z[b + i] - m.z[a + i];
        const double squared = dx * dx + dy * dy + dz * dz;
        const double safe = squared > 0.0 ? squared : 1.0;  // length 0: no direction, no force
        const double length = std::sqrt(safe);
        const double inverse = 1.0 / length;
        const double rate = ((m.vx[b + i] - m.vx[a + i]) * dx + (m.vy[b + i] - m.vy[a + i]) * dy +
                             (m.vz[b + i] - m.vz[a + i]) * dz) *
                            inverse;
        const double scale = (k[i] * (length - rest[i]) + d[i] * rate) * inverse;
        fx[i] = scale * dx;
        fy[i] = scale * dy;
        fz[i] = scale * dz;
        dissipated[i] += weight * d[i] * rate * rate;
    }
}

void evaluate_slot_row(const Lattice& lattice, const SheetState& sheet,
                       const SpringNetwork& network, const NodeMotion& motion, double weight,
                       Slot kind, Index row, SpringForces& forces) {
    const Index anchor = lattice.site(row, 0);
    const auto [a, b] = lattice.ends(kind, anchor);
    if (a == kNone) return;
    const Index columns =
        lattice.column_count - (kind == Slot::BendMain                           ? 2
                                : kind == Slot::Cross || kind == Slot::BendCross ? 0
                                                                                 : 1);
    const auto slot = static_cast<std::size_t>(lattice.slot(kind, anchor));
    const std::size_t f = SpringForces::offset(lattice, kind, row);
    evaluate_run(columns, motion, a, b, &network.stiffness[slot], &network.damping[slot],
                 &sheet.rest_length[slot], weight, &forces.x[f], &forces.y[f], &forces.z[f],
                 &forces.dissipated[slot]);
}

void evaluate_extra(const SheetState& sheet, const SpringNetwork& network, const NodeMotion& motion,
                    double weight, SpringForces& forces) {
    for (std::size_t i = 0; i < network.extra.size(); ++i) {
        const ExtraSpring& spring = network.extra[i];
        evaluate_run(
            1, motion, spring.a, spring.b, &network.extra_stiffness[i], &network.extra_damping[i],
            &sheet.rest_length[static_cast<std::size_t>(spring.slot)], weight, &forces.extra_x[i],
            &forces.extra_y[i], &forces.extra_z[i], &forces.extra_dissipated[i]);
    }
}

// The twelve dense springs of the nodes of a row, as pointers to the value at column 0.
// Springs that would come from outside the sheet are zeros: columns before the first find the
// unused slots at the end of the row before, or the kFront zeros; missing rows find `zeros`.
struct RowStencil {
    const double *main, *cross, *cross_above, *down, *down_above, *up, *up_above, *bend_main,
        *bend_cross, *bend_cross_above;
};

RowStencil stencil(const Lattice& lattice, const SpringForces& forces,
                   const std::vector<double>& component, Index row) {
    const auto at = [&](Slot kind, Index r) {
        if (r == kNone) return forces.zeros.data() + SpringForces::kFront;
        return component.data() + SpringForces::offset(lattice, kind, r);
    };
    const Index above = lattice.row_at(row, -1), two_above = lattice.row_at(row, -2);
    return {at(Slot::Main, row),           at(Slot::Cross, row),      at(Slot::Cross, above),
            at(Slot::DiagDown, row),       at(Slot::DiagDown, above), at(Slot::DiagUp, row),
            at(Slot::DiagUp, above),       at(Slot::BendMain, row),   at(Slot::BendCross, row),
            at(Slot::BendCross, two_above)};
}

EMBER_VECTORISED void gather_component(const RowStencil& s, Index columns, double* __restrict out) {
    for (std::ptrdiff_t c = 0; c < columns; ++c) {
        double f = s.main[c] - kReaction * s.main[c - 1];
        f += s.cross[c] - kReaction * s.cross_above[c];
        f += s.down[c] - kReaction * s.down_above[c - 1];
        f += s.up[c - 1] - kReaction * s.up_above[c];
        f += s.bend_main[c] - kReaction * s.bend_main[c - 2];
        f += s.bend_cross[c] - kReaction * s.bend_cross_above[c];
        out[c] = f;
    }
}

}  // namespace

void SpringForces::begin_tick(const Lattice& lattice, const SpringNetwork& network) {
    const std::size_t slots = network.weight.size(), extra = network.extra.size();
    x.assign(slots + kSlotCount * kFront, 0.0);
    y.assign(slots + kSlotCount * kFront, 0.0);
    z.assign(slots + kSlotCount * kFront, 0.0);
    dissipated.assign(slots, 0.0);
    extra_x.assign(extra, 0.0);
    extra_y.assign(extra, 0.0);
    extra_z.assign(extra, 0.0);
    extra_dissipated.assign(extra, 0.0);
    zeros.assign(kFront + static_cast<std::size_t>(lattice.column_count), 0.0);
}

void evaluate_springs(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
                      const NodeMotion& motion, double weight, SpringForces& forces,
                      ThreadPool& pool) {
    pool.for_rows(lattice.row_count, kSlotCount * lattice.column_count,
                  [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                      for (auto row = begin; row < end; ++row) {
                          for (int kind = 0; kind < kSlotCount; ++kind) {
                              evaluate_slot_row(lattice, sheet, network, motion, weight,
                                                static_cast<Slot>(kind), static_cast<Index>(row),
                                                forces);
                          }
                      }
                  });
    evaluate_extra(sheet, network, motion, weight, forces);
}

void gather_row(const Lattice& lattice, const SpringForces& forces, Index row, double* fx,
                double* fy, double* fz) {
    const Index columns = lattice.column_count;
    gather_component(stencil(lattice, forces, forces.x, row), columns, fx);
    gather_component(stencil(lattice, forces, forces.y, row), columns, fy);
    gather_component(stencil(lattice, forces, forces.z, row), columns, fz);
}

Vector3 gather_extra(const SpringNetwork& network, const SpringForces& forces, std::size_t node) {
    Vector3 sum = Vector3::Zero();
    for (Index e = network.end_begin[node]; e < network.end_begin[node + 1]; ++e) {
        const ExtraEnd& end = network.ends[static_cast<std::size_t>(e)];
        const auto i = static_cast<std::size_t>(end.spring);
        sum += end.sign * Vector3(forces.extra_x[i], forces.extra_y[i], forces.extra_z[i]);
    }
    return sum;
}

double elastic_energy(const Lattice& lattice, const SheetState& sheet,
                      const SpringNetwork& network) {
    double sum = 0.0;
    for_each_spring(lattice, network, [&](Index a, Index b, Index slot, double k, double) {
        const Vector3 d = sheet.position.at(static_cast<std::size_t>(b)) -
                          sheet.position.at(static_cast<std::size_t>(a));
        const double stretch = d.norm() - sheet.rest_length[static_cast<std::size_t>(slot)];
        sum += 0.5 * k * stretch * stretch;
    });
    return sum;
}

}  // namespace ember
