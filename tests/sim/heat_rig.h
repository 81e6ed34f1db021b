// A sheet that only conducts, for the tests of the heat solvers.
#pragma once

#include <cmath>
#include <numbers>

#include "rig.h"
#include "sim/heat.h"
#include "sim/random.h"
#include "sim/topology.h"

namespace ember::test {

inline constexpr double kAmbient = 293.15;
inline constexpr HeatSolverKind kHeatSolvers[] = {HeatSolverKind::Ftcs, HeatSolverKind::Rkl2,
                                                  HeatSolverKind::Adi};

struct HeatRig : Rig {
    HeatScratch scratch;

    explicit HeatRig(const Params& p, HeatSolverKind solver = HeatSolverKind::Auto) : Rig(p) {
        params.numerics.heat_solver = solver;
        rebuild();
    }

    /// After any change of topology.
    void rebuild() {
        refresh();
        rebuild_heat(lattice, sheet, network, params.paper, scratch);
    }

    HeatSolverKind conduct(double dt, int refine = 1) {
        return conduct_heat(sheet, params, dt, refine, scratch, counters);
    }

    [[nodiscard]] double limit() const { return 1.0 / scratch.conduction.most_per_capacity; }

    [[nodiscard]] double stored() const { return stored_heat(sheet, params.paper, kAmbient); }

    /// temperature = f(row, column) at every site
    template <class Function>
    void set(Function&& f) {
        for (Index r = 0; r < lattice.row_count; ++r) {
            for (Index c = 0; c < lattice.column_count; ++c)
                sheet.temperature[site(r, c)] = f(r, c);
        }
    }

    /// Cuts every site with probability `share`, along either direction.
    void cut_at_random(double share) {
        sheet.phase.assign(sheet.phase.size(), Phase::BurntOut);
        for (Index i = 0; i < lattice.site_count(); ++i) {
            const auto n = static_cast<std::uint64_t>(i);
            if (random_uniform(7, RandomUse::MainSpring, 0, n) > share) continue;
            const bool main = random_uniform(7, RandomUse::CrossSpring, 0, n) < 0.5;
            cut_site(lattice, sheet, i, main ? CutLine::AlongMain : CutLine::AlongCross);
        }
        ++sheet.topology_version;
        rebuild();
    }

    /// A few hot spots with sharp edges.
    void heat_spots() {
        for (const auto& [r, c] : {std::pair{0.3, 0.4}, {0.7, 0.75}, {0.0, 0.9}}) {
            const auto row = static_cast<Index>(r * lattice.row_count);
            const auto column = static_cast<Index>(c * lattice.column_count);
            for (Index k = 0; k < 3; ++k)
                sheet.temperature[site(row, std::min(column + k, lattice.column_count - 1))] =
                    900.0 + 100.0 * k;
        }
    }
};

inline Params tube(int rows, int columns) {
    Params p = plain(rows, columns);
    p.sheet.shape = SheetShape::Cylinder;
    return p;
}

/// A manufactured solution: conducts for 1 s in `steps`, each between two halves of a source.
/// exact(row, column, time) is the solution [K]; add_source(from, to) adds the source's integral.
/// Returns the RMS error at the end [K].
template <class Exact, class AddSource>
double error_after_a_second(HeatRig& rig, int steps, Exact&& exact, AddSource&& add_source) {
    rig.set([&](Index r, Index c) { return exact(r, c, 0.0); });
    const double dt = 1.0 / steps;
    for (int i = 0; i < steps; ++i) {
        add_source(i * dt, (i + 0.5) * dt);
        rig.conduct(dt);
        add_source((i + 0.5) * dt, (i + 1) * dt);
    }
    double sum = 0;
    for (Index r = 0; r < rig.lattice.row_count; ++r) {
        for (Index c = 0; c < rig.lattice.column_count; ++c)
            sum += std::pow(rig.sheet.temperature[rig.site(r, c)] - exact(r, c, 1.0), 2);
    }
    return std::sqrt(sum / rig.lattice.site_count());
}

}  // namespace ember::test
