#include "sim/integrator.h"

#include <algorithm>

#include "sim/vectorise.h"

namespace ember {
namespace {

// One Runge-Kutta stage: how it enters the sum, and how far the next stage looks ahead.
struct RungeKuttaStage {
    double sum_weight;     // [1]
    double next;           // [s]
    double energy_weight;  // [s] weight of the stage's power in the work done
    bool first, last;
};

struct NodeArrays {
    double *x, *y, *z;
    explicit NodeArrays(Vector3Array& a) : x(a.x.data()), y(a.y.data()), z(a.z.data()) {}
};

// Everything that the update of a range of nodes touches.
struct Update {
    const NodeLoads& loads;
    NodeArrays x, v, stage_x, stage_v, sum_x, sum_v;
    double* drag_loss;
    double h;  // [s] sub-step
};

// Advances one component of `count` nodes by one stage: force f + load gives the acceleration, the
// stage velocity is the rate of the position. The branches do not depend on the node, so that the
// compiler takes them out of the loop.
EMBER_VECTORISED void advance(const RungeKuttaStage s, double h, std::ptrdiff_t count,
                              const double* __restrict f, const double* __restrict load,
                              const double* __restrict inverse_mass, double* __restrict x,
                              double* __restrict v, double* __restrict stage_x,
                              double* __restrict stage_v, double* __restrict sum_x,
                              double* __restrict sum_v) {
    const double sixth = h / 6.0;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const double a = (f[i] + load[i]) * inverse_mass[i];
        const double w = stage_v[i];
        const double total_x = (s.first ? 0.0 : sum_x[i]) + s.sum_weight * w;
        const double total_v = (s.first ? 0.0 : sum_v[i]) + s.sum_weight * a;
        sum_x[i] = total_x;
        sum_v[i] = total_v;
        const double new_x = s.last ? x[i] + sixth * total_x : x[i];
        const double new_v = s.last ? v[i] + sixth * total_v : v[i];
        stage_x[i] = s.last ? new_x : new_x + s.next * w;
        stage_v[i] = s.last ? new_v : new_v + s.next * a;
        x[i] = new_x;
        v[i] = new_v;
    }
}

// Drag F = -c [(v·n) n + τ (v - (v·n) n)] on nodes; adds the energy lost.
EMBER_VECTORISED void add_drag(const Update& u, const RungeKuttaStage& s, std::ptrdiff_t first,
                               std::ptrdiff_t count, double* __restrict fx, double* __restrict fy,
                               double* __restrict fz) {
    const double tau = u.loads.drag_tangential;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const std::ptrdiff_t n = first + i;
        const auto m = static_cast<std::size_t>(n);
        const double vx = u.stage_v.x[n], vy = u.stage_v.y[n], vz = u.stage_v.z[n];
        const double nx = u.loads.normal.x[m], ny = u.loads.normal.y[m], nz = u.loads.normal.z[m];
        const double across = vx * nx + vy * ny + vz * nz;
        const double along = (1.0 - tau) * across;
        const double c = u.loads.drag[m];
        fx[i] -= c * (along * nx + tau * vx);
        fy[i] -= c * (along * ny + tau * vy);
        fz[i] -= c * (along * nz + tau * vz);
        const double power = c * (along * across + tau * (vx * vx + vy * vy + vz * vz));
        u.drag_loss[n] += u.loads.inverse_mass[m] > 0.0 ? s.energy_weight * power : 0.0;
    }
}

// Nodes first .. first+count with spring forces f: adds loads and advances the scheme.
void update_nodes(const Update& u, const RungeKuttaStage& s, std::ptrdiff_t first,
                  std::ptrdiff_t count, double* __restrict fx, double* __restrict fy,
                  double* __restrict fz) {
    if (u.loads.has_drag) add_drag(u, s, first, count, fx, fy, fz);
    const double* __restrict inverse = u.loads.inverse_mass.data() + first;
    advance(s, u.h, count, fx, u.loads.force.x.data() + first, inverse, u.x.x + first,
            u.v.x + first, u.stage_x.x + first, u.stage_v.x + first, u.sum_x.x + first,
            u.sum_v.x + first);
    advance(s, u.h, count, fy, u.loads.force.y.data() + first, inverse, u.x.y + first,
            u.v.y + first, u.stage_x.y + first, u.stage_v.y + first, u.sum_x.y + first,
            u.sum_v.y + first);
    advance(s, u.h, count, fz, u.loads.force.z.data() + first, inverse, u.x.z + first,
            u.v.z + first, u.stage_x.z + first, u.stage_v.z + first, u.sum_x.z + first,
            u.sum_v.z + first);
}

void add_extra(const SpringNetwork& network, const SpringForces& forces, std::ptrdiff_t first,
               std::ptrdiff_t count, double* fx, double* fy, double* fz) {
    if (network.extra.empty()) return;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        const auto node = static_cast<std::size_t>(first + i);
        if (network.end_begin[node] == network.end_begin[node + 1]) continue;
        const Vector3 f = gather_extra(network, forces, node);
        fx[i] += f.x();
        fy[i] += f.y();
        fz[i] += f.z();
    }
}

void run_stage(const Lattice& lattice, const SheetState& sheet, const SpringNetwork& network,
               const RungeKuttaStage& stage, const Update& u, SpringForces& forces,
               IntegratorScratch& scratch, ThreadPool& pool) {
    const NodeMotion motion{u.stage_x.x, u.stage_x.y, u.stage_x.z,
                            u.stage_v.x, u.stage_v.y, u.stage_v.z};
    evaluate_springs(lattice, sheet, network, motion, stage.energy_weight, forces, pool);
    const std::ptrdiff_t columns = lattice.column_count;
    const auto update_run = [&](double* f, std::ptrdiff_t first, std::ptrdiff_t count) {
        add_extra(network, forces, first, count, f, f + columns, f + 2 * columns);
        update_nodes(u, stage, first, count, f, f + columns, f + 2 * columns);
    };
    pool.for_rows(lattice.row_count, kSlotCount * lattice.column_count,
                  [&](std::ptrdiff_t begin, std::ptrdiff_t end) {
                      double* f = scratch.row_force.data() + 3 * columns * begin;
                      for (auto row = begin; row < end; ++row) {
                          gather_row(lattice, forces, static_cast<Index>(row), f, f + columns,
                                     f + 2 * columns);
                          update_run(f, row * columns, columns);
                      }
                  });
    // copies made by cuts come after the sites, and have extra springs only
    const auto node_count = static_cast<std::ptrdiff_t>(sheet.mass.size());
    for (std::ptrdiff_t first = lattice.site_count(); first < node_count; first += columns) {
        const std::ptrdiff_t count = std::min(columns, node_count - first);
        double* f = scratch.row_force.data();
        std::fill(f, f + 3 * columns, 0.0);
        update_run(f, first, count);
    }
}

TickWork work_done(const SheetState& sheet, const NodeLoads& loads, const SpringForces& forces,
                   const IntegratorScratch& scratch) {
    TickWork work;
    for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
        work.fire += loads.fire.x[n] * (sheet.position.x[n] - scratch.start_x.x[n]) +
                     loads.fire.y[n] * (sheet.position.y[n] - scratch.start_x.y[n]) +
                     loads.fire.z[n] * (sheet.position.z[n] - scratch.start_x.z[n]);
        work.drag += scratch.drag_loss[n];
    }
    for (const double loss : forces.dissipated)
        work.damping += loss;
    for (const double loss : forces.extra_dissipated)
        work.damping += loss;
    return work;
}

}  // namespace

TickWork integrate(const Lattice& lattice, SheetState& sheet, const SpringNetwork& network,
                   const NodeLoads& loads, double dt, std::int64_t substeps, SpringForces& forces,
                   IntegratorScratch& scratch, ThreadPool& pool, StepCounters& counters) {
    const std::size_t n = sheet.mass.size();
    forces.begin_tick(lattice, network);
    scratch.stage_x = sheet.position;
    scratch.stage_v = sheet.velocity;
    scratch.start_x = sheet.position;
    scratch.sum_x.resize(n);
    scratch.sum_v.resize(n);
    scratch.drag_loss.assign(n, 0.0);
    scratch.row_force.resize(static_cast<std::size_t>(3 * lattice.site_count()));
    const double h = dt / static_cast<double>(substeps);
    const Update u{loads,
                   NodeArrays(sheet.position),
                   NodeArrays(sheet.velocity),
                   NodeArrays(scratch.stage_x),
                   NodeArrays(scratch.stage_v),
                   NodeArrays(scratch.sum_x),
                   NodeArrays(scratch.sum_v),
                   scratch.drag_loss.data(),
                   h};
    const RungeKuttaStage stages[] = {{1, 0.5 * h, h / 6, true, false},
                                      {2, 0.5 * h, h / 3, false, false},
                                      {2, h, h / 3, false, false},
                                      {1, 0, h / 6, false, true}};
    for (std::int64_t step = 0; step < substeps; ++step) {
        for (const RungeKuttaStage& stage : stages) {
            run_stage(lattice, sheet, network, stage, u, forces, scratch, pool);
        }
    }
    const auto springs = static_cast<std::int64_t>(network.weight.size() + network.extra.size());
    counters.right_hand_sides += 4 * substeps;
    counters.spring_evaluations += 4 * substeps * springs;
    return work_done(sheet, loads, forces, scratch);
}

}  // namespace ember
