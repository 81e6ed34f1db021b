#include "sim/heat.h"

#include <algorithm>
#include <cmath>

#include "sim/math.h"

namespace ember {
namespace {

constexpr double kStefanBoltzmann = 5.670374419e-8;  // [W/(m^2 K^4)]

// Rows that are not entirely at ambient.
void find_warm_rows(const Lattice& lattice, const SheetState& sheet, double ambient,
                    HeatScratch& scratch) {
    scratch.first_row = lattice.row_count;
    scratch.last_row = -1;
    for (Index row = 0; row < lattice.row_count; ++row) {
        const double* t = &sheet.temperature[static_cast<std::size_t>(lattice.site(row, 0))];
        bool warm = false;
        for (Index c = 0; c < lattice.column_count; ++c)
            warm |= t[c] != ambient;
        if (!warm) continue;
        scratch.first_row = std::min(scratch.first_row, row);
        scratch.last_row = row;
    }
}

// One explicit step over rows first..last; rows outside are at ambient and stay so.
void conduct_rows(const Lattice& lattice, const SheetState& sheet, const PaperParams& paper,
                  double h, HeatScratch& s, Index first, Index last) {
    const std::vector<double>& t = sheet.temperature;
    for (Index row = first; row <= last; ++row) {
        const Index above = lattice.row_at(row, -1), below = lattice.row_at(row, 1);
        for (Index c = 0; c < lattice.column_count; ++c) {
            const auto i = static_cast<std::size_t>(lattice.site(row, c));
            double flow = 0.0;  // [W] into the node
            if (c > 0) flow += s.main[i - 1] * (t[i - 1] - t[i]);
            if (c + 1 < lattice.column_count) flow += s.main[i] * (t[i + 1] - t[i]);
            if (above != kNone) {
                const auto j = static_cast<std::size_t>(lattice.site(above, c));
                flow += s.cross[j] * (t[j] - t[i]);
            }
            if (below != kNone) {
                const auto j = static_cast<std::size_t>(lattice.site(below, c));
                flow += s.cross[i] * (t[j] - t[i]);
            }
            s.next[i] = t[i] + h * flow / heat_capacity(paper, sheet.initial_mass[i]);
        }
    }
}

}  // namespace

void rebuild_conduction(const Lattice& lattice, const SheetState& sheet,
                        const SpringNetwork& network, const PaperParams& paper,
                        HeatScratch& scratch) {
    const auto sites = static_cast<std::size_t>(lattice.site_count());
    scratch.main.resize(sites);
    scratch.cross.resize(sites);
    scratch.next = sheet.temperature;
    scratch.next.resize(sites);
    std::vector<double> sum(sites, 0.0);
    for (const Slot kind : {Slot::Main, Slot::Cross}) {
        std::vector<double>& conductance = kind == Slot::Main ? scratch.main : scratch.cross;
        const double whole = lattice.edge_conductance[kind == Slot::Main ? 0 : 1];
        for (std::size_t i = 0; i < sites; ++i) {
            const Index anchor = static_cast<Index>(i);
            conductance[i] =
                whole * network.weight[static_cast<std::size_t>(lattice.slot(kind, anchor))];
            if (conductance[i] == 0) continue;
            for (const Index end : lattice.ends(kind, anchor)) {
                sum[static_cast<std::size_t>(end)] += conductance[i];
            }
        }
    }
    scratch.most_per_capacity = 0;
    for (std::size_t i = 0; i < sites; ++i) {
        scratch.most_per_capacity = std::max(scratch.most_per_capacity,
                                             sum[i] / heat_capacity(paper, sheet.initial_mass[i]));
    }
    scratch.topology_version = sheet.topology_version;
}

void conduct_heat(const Lattice& lattice, SheetState& sheet, const PaperParams& paper,
                  double ambient, double dt, int refine, HeatScratch& scratch,
                  StepCounters& counters) {
    find_warm_rows(lattice, sheet, ambient, scratch);
    if (scratch.last_row < 0) return;
    const double needed = std::max(1.0, std::ceil(dt * scratch.most_per_capacity)) * refine;
    const double h = dt / needed;
    for (double step = 0; step < needed; ++step) {
        // heat reaches one row further in every step; around a seam it may reach any row
        const bool all = lattice.closed;
        const Index first = all ? 0 : std::max(0, scratch.first_row - 1);
        const Index last =
            all ? lattice.row_count - 1 : std::min(lattice.row_count - 1, scratch.last_row + 1);
        conduct_rows(lattice, sheet, paper, h, scratch, first, last);
        const auto begin = static_cast<std::ptrdiff_t>(lattice.site(first, 0));
        const auto end = static_cast<std::ptrdiff_t>(lattice.site(last, 0)) + lattice.column_count;
        std::copy(scratch.next.begin() + begin, scratch.next.begin() + end,
                  sheet.temperature.begin() + begin);
        scratch.first_row = first;
        scratch.last_row = last;
        counters.heat_nodes += end - begin;
        ++counters.heat_substeps;
    }
}

void exchange_heat(SheetState& sheet, const Params& params, const std::vector<double>& source,
                   double dt, HeatLedger& ledger, StepCounters& counters) {
    const HeatParams& heat = params.heat;
    const double ambient = heat.ambient;
    const double span = heat.flame_limit - ambient;
    // losses act on the sheet's true areal heat capacity c G: c_s speeds up diffusion only
    const double both_faces = 2.0 / (params.paper.specific_heat * params.paper.grammage);
    for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
        const bool burning = sheet.phase[n] == Phase::Burning;
        const double own = burning && span > 0 ? params.burning.heat_release : 0.0;
        const double fire = n < source.size() && span > 0 ? source[n] : 0.0;
        const double u = sheet.temperature[n] - ambient;
        if (u == 0 && own + fire == 0) continue;
        const double t = sheet.temperature[n];
        const double radiation = heat.emissivity * kStefanBoltzmann * (t + ambient) *
                                 (t * t + ambient * ambient);  // [W/(m^2 K)], frozen for the tick
        const double loss = both_faces * (heat.convection + radiation);  // [1/s]
        const double given = own + fire;                                 // [K/s]
        // du/dt = given - rate u, solved exactly; ∫u dt follows from it
        const double rate = (given > 0 ? given / span : 0.0) + loss;
        const double decay = ember::exp(-rate * dt);
        const double limit = rate > 0 ? given / rate : 0.0;
        const double after = rate > 0 ? limit + (u - limit) * decay : u + given * dt;
        const double integral = rate > 0 ? limit * dt + (u - limit) * (1.0 - decay) / rate : u * dt;
        sheet.temperature[n] = ambient + after;
        const double capacity = heat_capacity(params.paper, sheet.initial_mass[n]);
        // lost and given come from the same integral but not from each other, so that the ledger
        // checks the temperature
        ledger.lost_air += capacity * loss * integral;
        const double per_heating = span > 0 ? capacity * (dt - integral / span) : 0.0;
        ledger.given_burning += own * per_heating;
        ledger.given_fire += fire * per_heating;
        ++counters.heat_nodes;
    }
}

void cool_held(SheetState& sheet, const PaperParams& paper, double ambient, HeatLedger& ledger) {
    for (std::size_t n = 0; n < sheet.held.size(); ++n) {
        if (sheet.held[n] == 0 || sheet.temperature[n] == ambient) continue;
        const double above = sheet.temperature[n] - ambient;
        ledger.lost_held += heat_capacity(paper, sheet.initial_mass[n]) * above;
        sheet.temperature[n] = ambient;
    }
}

double stored_heat(const SheetState& sheet, const PaperParams& paper, double ambient) {
    double sum = 0.0;
    for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
        sum += heat_capacity(paper, sheet.initial_mass[n]) * (sheet.temperature[n] - ambient);
    }
    return sum;
}

}  // namespace ember
