#include "sim/energy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "sim/spring_forces.h"
#include "sim/vectorise.h"

namespace ember {

namespace {

constexpr std::ptrdiff_t kBlock = 64;  // terms that are summed at once
using Block = std::array<double, kBlock>;

// ½ k (L - l)² of `count` springs between nodes a+i and b+i.
EMBER_VECTORISED void elastic_terms(std::ptrdiff_t count, const SheetState& sheet, std::ptrdiff_t a,
                                    std::ptrdiff_t b, const double* __restrict stiffness,
                                    const double* __restrict rest, double* __restrict out) {
    const double *x = sheet.position.x.data(), *y = sheet.position.y.data(),
                 *z = sheet.position.z.data();
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double dx = x[b + i] - x[a + i], dy = y[b + i] - y[a + i], dz = z[b + i] - z[a + i];
        const double stretch = std::sqrt(dx * dx + dy * dy + dz * dz) - rest[i];
        out[i] = 0.5 * stiffness[i] * stretch * stretch;
    }
}

EMBER_VECTORISED void motion_terms(std::ptrdiff_t first, std::ptrdiff_t count,
                                   const SheetState& sheet, const WorldParams& world,
                                   double* __restrict kinetic, double* __restrict gravitational) {
    const double *x = sheet.velocity.x.data() + first, *y = sheet.velocity.y.data() + first,
                 *z = sheet.velocity.z.data() + first, *mass = sheet.mass.data() + first,
                 *height = sheet.position.y.data() + first;
    const std::uint8_t* piece_held = sheet.piece_held.data() + first;
    const double while_held = world.gravity_while_held();
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double gravity = piece_held[i] != 0 ? while_held : world.gravity;
        kinetic[i] = 0.5 * mass[i] * (x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        gravitational[i] = mass[i] * gravity * height[i];
    }
}

double elastic_of(const SheetState& sheet, std::ptrdiff_t count, std::ptrdiff_t a, std::ptrdiff_t b,
                  const double* stiffness, const double* rest) {
    Block terms{};
    double sum = 0.0;
    for (std::ptrdiff_t i = 0; i < count; i += kBlock) {
        const std::ptrdiff_t size = std::min(kBlock, count - i);
        elastic_terms(size, sheet, a + i, b + i, stiffness + i, rest + i, terms.data());
        sum += sum_in_lanes(terms.data(), size);
    }
    return sum;
}

void add_motion(const SheetState& sheet, const WorldParams& world, std::ptrdiff_t begin,
                std::ptrdiff_t end, MechanicalEnergy& energy) {
    Block kinetic{}, gravitational{};
    for (std::ptrdiff_t first = begin; first < end; first += kBlock) {
        const std::ptrdiff_t count = std::min(kBlock, end - first);
        motion_terms(first, count, sheet, world, kinetic.data(), gravitational.data());
        energy.kinetic += sum_in_lanes(kinetic.data(), count);
        energy.gravitational += sum_in_lanes(gravitational.data(), count);
    }
}

}  // namespace

MechanicalEnergy sheet_energy(const Lattice& lattice, const WorldParams& world,
                              const SheetState& sheet, const SpringNetwork& network,
                              ThreadPool& pool, std::vector<MechanicalEnergy>& rows) {
    const std::ptrdiff_t columns = lattice.column_count;
    rows.resize(static_cast<std::size_t>(lattice.row_count));
    pool.for_rows(
        lattice.row_count, kSlotCount * columns, [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
            for (std::ptrdiff_t row = begin; row < end; ++row) {
                MechanicalEnergy& energy = rows[static_cast<std::size_t>(row)] = {};
                const auto add = [&](std::ptrdiff_t count, Index a, Index b, std::size_t slot) {
                    energy.elastic += elastic_of(sheet, count, a, b, &network.stiffness[slot],
                                                 &sheet.rest_length[slot]);
                };
                for_springs_of_row(lattice, static_cast<Index>(row), add);
                add_motion(sheet, world, row * columns, (row + 1) * columns, energy);
            }
        });
    MechanicalEnergy sum;
    for (const MechanicalEnergy& row : rows)
        sum += row;
    add_motion(sheet, world, lattice.site_count(), static_cast<std::ptrdiff_t>(sheet.mass.size()),
               sum);  // copies
    for (std::size_t i = 0; i < network.extra.size(); ++i) {
        const ExtraSpring& spring = network.extra[i];
        sum.elastic += elastic_of(sheet, 1, spring.a, spring.b, &network.extra_stiffness[i],
                                  &sheet.rest_length[static_cast<std::size_t>(spring.slot)]);
    }
    return sum;
}

double unaccounted_energy(const EnergyLedger& e, double& scale) {
    const double now = e.kinetic + e.elastic + e.gravitational;
    const double changes = e.work_fire + e.work_wind + e.change_scheme + e.work_contact +
                           e.change_mass + e.change_rest_length + e.change_curvature +
                           e.change_topology + e.change_edit;
    const double losses = e.loss_damping + e.loss_drag + e.loss_sleep;
    // potential energy counts by its change, as its zero is arbitrary
    const double fallen = e.gravitational + e.elastic + e.kinetic - e.initial;
    scale = 0.0;
    for (const double term : {e.kinetic, e.elastic, fallen, e.work_fire, e.work_wind, losses,
                              e.work_contact, e.change_mass, e.change_rest_length,
                              e.change_curvature, e.change_topology, e.change_edit}) {
        scale = std::max(scale, std::abs(term));
    }
    return now - (e.initial + changes - losses);
}

namespace {

constexpr double kSmallest = 1e-12;  // [J] of rounding

// All energy that can have gone into springs and motion.
double put_in(const EnergyLedger& e) {
    double sum = std::abs(e.initial - e.initial_gravitational);
    sum += std::max(0.0, e.initial_gravitational - e.gravitational);
    for (const double change :
         {e.work_fire, e.work_wind, e.work_contact, e.change_mass, e.change_rest_length,
          e.change_curvature, e.change_topology, e.change_edit}) {
        sum += std::abs(change);
    }
    return sum;
}

bool scheme_is_bounded(EnergyLedger& ledger) {
    constexpr double kNothing = 1e-3;  // of what was put in: a tick that is not to blame
    const double limit = put_in(ledger);
    const double added = ledger.change_scheme - ledger.scheme_settled;
    ledger.scheme_settled = ledger.change_scheme;
    return ledger.change_scheme <= limit + kSmallest || added <= kNothing * limit;
}

}  // namespace

bool settle(EnergyLedger& ledger) {
    constexpr double kUsed = 0.9;     // share of the margin that refinement makes do with
    constexpr double kAlways = 1e-3;  // share of it that any tick may use
    double scale = 0.0;
    const double excess = unaccounted_energy(ledger, scale);
    ledger.largest = std::max(ledger.largest, scale);
    const double margin = kUsed * kEnergyMargin * ledger.largest;
    const double allowed =
        std::max({0.5 * (margin - ledger.unaccounted), kAlways * margin, kSmallest});
    const bool good = std::isfinite(excess) && excess - ledger.unaccounted <= allowed;
    ledger.unaccounted = excess;
    return scheme_is_bounded(ledger) && good;
}

}  // namespace ember
