#include "sim/fire_coupling.h"

#include <algorithm>
#include <cmath>

#include "sim/math.h"

namespace ember {
namespace {

constexpr Index kMostCells = 1 << 20;

Index clamp_cell(double distance, double cell, Index count) {
    return std::clamp(static_cast<Index>(std::floor(distance / cell)), 0, count - 1);
}

Index cell_of(const ParticleGrid& grid, const Vector3& p) {
    const Vector3 d = p - grid.origin;
    const Index ix = clamp_cell(d.x(), grid.cell, grid.nx);
    const Index iy = clamp_cell(d.y(), grid.cell, grid.ny);
    const Index iz = clamp_cell(d.z(), grid.cell, grid.nz);
    return (iz * grid.ny + iy) * grid.nx + ix;
}

// Grid over the particles' box with cells of the kernel radius, or larger ones where particles
// have flown so far that there would be too many.
void size_grid(const FireState& fire, double radius, ParticleGrid& grid) {
    Vector3 low = fire.position.at(0), high = low;
    for (std::size_t i = 1; i < fire.size(); ++i) {
        low = low.cwiseMin(fire.position.at(i));
        high = high.cwiseMax(fire.position.at(i));
    }
    grid.origin = low;
    grid.cell = radius;
    for (;;) {
        const Vector3 cells = ((high - low) / grid.cell).array().floor() + 1.0;
        if (cells.prod() <= kMostCells) {
            grid.nx = static_cast<Index>(cells.x());
            grid.ny = static_cast<Index>(cells.y());
            grid.nz = static_cast<Index>(cells.z());
            return;
        }
        grid.cell *= 2.0;
    }
}

void fill_grid(const FireState& fire, double heating, double span, double ambient, double time,
               double heating_time, ParticleGrid& grid) {
    const std::size_t count = fire.size();
    const auto cells = static_cast<std::size_t>(grid.nx * grid.ny * grid.nz);
    grid.begin.assign(cells + 1, 0);
    for (std::size_t i = 0; i < count; ++i) {
        ++grid.begin[static_cast<std::size_t>(cell_of(grid, fire.position.at(i))) + 1];
    }
    for (std::size_t c = 0; c < cells; ++c)
        grid.begin[c + 1] += grid.begin[c];
    grid.order.resize(count);
    grid.position.resize(count);
    grid.velocity.resize(count);
    grid.heating.resize(count);
    grid.freshness.resize(count);
    grid.absorbed.assign(count, 0.0);
    // begin[c] serves as the next free place of cell c, and is set back afterwards
    for (std::size_t i = 0; i < count; ++i) {
        Index& next = grid.begin[static_cast<std::size_t>(cell_of(grid, fire.position.at(i)))];
        const auto at = static_cast<std::size_t>(next++);
        grid.order[at] = static_cast<Index>(i);
        grid.position.set(at, fire.position.at(i));
        grid.velocity.set(at, fire.velocity.at(i));
        grid.freshness[at] = ember::exp((fire.birth[i] - time) / heating_time);
        grid.heating[at] = heating * fire.strength[i] * grid.freshness[at] *
                           (fire.temperature[i] - ambient) / span;
    }
    for (std::size_t c = cells; c > 0; --c)
        grid.begin[c] = grid.begin[c - 1];
    grid.begin[0] = 0;
}

// Sums over the particles near one node.
struct Received {
    double heating = 0;                  // [K/s]
    double weight = 0;                   // [1] Σ W
    Vector3 momentum = Vector3::Zero();  // [m/s] Σ W v
};

// Particles of cells first..last of one grid line, which lie next to each other in memory.
void visit_line(ParticleGrid& grid, Index first_cell, Index last_cell, const Vector3& p,
                double inverse_r2, double absorbed_per_weight, Received& sum,
                StepCounters& counters) {
    const auto begin = static_cast<std::size_t>(grid.begin[static_cast<std::size_t>(first_cell)]);
    const auto end = static_cast<std::size_t>(grid.begin[static_cast<std::size_t>(last_cell) + 1]);
    counters.coupling_pairs += static_cast<std::int64_t>(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
        const double dx = grid.position.x[i] - p.x(), dy = grid.position.y[i] - p.y(),
                     dz = grid.position.z[i] - p.z();
        const double q = 1.0 - (dx * dx + dy * dy + dz * dz) * inverse_r2;
        if (!(q > 0)) continue;
        const double w = q * q;
        sum.heating += grid.heating[i] * w;
        sum.weight += w;
        sum.momentum += w * grid.velocity.at(i);
        grid.absorbed[i] += absorbed_per_weight * w;
    }
}

Received receive(ParticleGrid& grid, const Vector3& p, double radius, double absorbed_per_weight,
                 StepCounters& counters) {
    Received sum;
    const Vector3 low = (p - grid.origin).array() - radius, high = low.array() + 2.0 * radius;
    const Vector3 size(grid.nx * grid.cell, grid.ny * grid.cell, grid.nz * grid.cell);
    if ((high.array() < 0).any() || (low.array() > size.array()).any()) return sum;
    const Index x0 = clamp_cell(low.x(), grid.cell, grid.nx);
    const Index x1 = clamp_cell(high.x(), grid.cell, grid.nx);
    const Index y0 = clamp_cell(low.y(), grid.cell, grid.ny);
    const Index y1 = clamp_cell(high.y(), grid.cell, grid.ny);
    const Index z0 = clamp_cell(low.z(), grid.cell, grid.nz);
    const Index z1 = clamp_cell(high.z(), grid.cell, grid.nz);
    const double inverse_r2 = 1.0 / (radius * radius);
    for (Index z = z0; z <= z1; ++z) {
        for (Index y = y0; y <= y1; ++y) {
            const Index line = (z * grid.ny + y) * grid.nx;
            visit_line(grid, line + x0, line + x1, p, inverse_r2, absorbed_per_weight, sum,
                       counters);
        }
    }
    return sum;
}

// Push on a node: force · area · Σ W (v_p - v), limited to a greatest acceleration.
Vector3 push(const FireParams& fire, const Received& sum, const Vector3& velocity, double area,
             double mass) {
    const Vector3 force = fire.force * area * (sum.momentum - sum.weight * velocity);
    const double limit = fire.force_limit * mass, size = force.norm();
    return size > limit ? Vector3(force * (limit / size)) : force;
}

void couple_sheet(const Params& params, const SheetState& sheet, ParticleGrid& grid,
                  NodeFire& received, StepCounters& counters) {
    const FireParams& f = params.fire;
    const double per_area = f.absorption > 0 ? 1.0 / (f.kernel_radius * f.kernel_radius) : 0.0;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        const double area = sheet.initial_mass[n] / params.paper.grammage;
        const bool takes_heat = sheet.phase[n] != Phase::BurntOut && sheet.held[n] == 0;
        const Received sum = receive(grid, sheet.position.at(n), f.kernel_radius,
                                     takes_heat ? area * per_area : 0.0, counters);
        if (!(sum.weight > 0)) continue;
        if (takes_heat) {
            received.heating[n] =
                f.heating_limit * (1.0 - ember::exp(-sum.heating / f.heating_limit));
        }
        if (sheet.held[n] == 0) {
            received.force.set(n, push(f, sum, sheet.velocity.at(n), area, sheet.mass[n]));
        }
    }
}

}  // namespace

double particle_heating(const FireParams& fire, const PaperParams& paper) {
    return fire.heating * ember::pow(0.080 / paper.grammage, fire.grammage_exponent) *
           ember::pow(2e-4 / paper.c_s, fire.stability_exponent);
}

void couple_fire(const Params& params, double time, double dt,
                 const std::vector<SheetState>& sheets, FireState& fire, ParticleGrid& grid,
                 std::vector<NodeFire>& received, StepCounters& counters) {
    received.resize(sheets.size());
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        const std::size_t nodes = fire.size() > 0 ? sheets[s].mass.size() : 0;
        received[s].heating.assign(nodes, 0.0);
        received[s].force.x.assign(nodes, 0.0);
        received[s].force.y.assign(nodes, 0.0);
        received[s].force.z.assign(nodes, 0.0);
    }
    const double ambient = params.heat.ambient;
    const double span = params.fire.temperature - ambient;
    if (fire.size() == 0 || !(span > 0)) return;
    size_grid(fire, params.fire.kernel_radius, grid);
    fill_grid(fire, particle_heating(params.fire, params.paper), span, ambient, time,
              params.fire.heating_time, grid);
    for (std::size_t s = 0; s < sheets.size(); ++s) {
        couple_sheet(params, sheets[s], grid, received[s], counters);
    }
    for (std::size_t i = 0; i < grid.order.size(); ++i) {
        if (!(grid.absorbed[i] > 0)) continue;
        double& t = fire.temperature[static_cast<std::size_t>(grid.order[i])];
        t = ambient + (t - ambient) * ember::exp(-params.fire.absorption * grid.freshness[i] *
                                                 grid.absorbed[i] * dt);
    }
}

}  // namespace ember
