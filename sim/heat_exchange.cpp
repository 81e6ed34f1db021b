// Sources, losses and sums over nodes: in blocks, so that cold ones cost one comparison per node
// and warm ones vectorise.
#include <algorithm>
#include <array>

#include "sim/heat.h"
#include "sim/math.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr double kStefanBoltzmann = 5.670374419e-8;  // [W/(m^2 K^4)]
constexpr std::size_t kBlock = 64;                   // nodes
constexpr std::size_t kLanes = 8;                    // partial sums

// Numbers of the law that are the same for all nodes.
struct ExchangeLaw {
    double ambient, span;          // [K]
    double own;                    // [K/s] of a burning node
    double both_faces;             // [m^2 K/J] 2 / areal heat capacity
    double convection, radiation;  // [W/(m^2 K)], [W/(m^2 K^4)]
    double capacity_per_mass;      // [J/(kg K)]
    double dt;                     // [s]
};

ExchangeLaw law_of(const Params& params, double dt) {
    const HeatParams& heat = params.heat;
    const double span = heat.flame_limit - heat.ambient;
    // losses act on the sheet's true areal heat capacity c G: c_s speeds up diffusion only
    return {heat.ambient,
            span,
            span > 0 ? params.burning.heat_release : 0.0,
            2.0 / (params.paper.specific_heat * params.paper.grammage),
            heat.convection,
            heat.emissivity * kStefanBoltzmann,
            heat_capacity(params.paper, 1.0),
            dt};
}

// Quantities of a block, one entry per node.
struct ExchangeBlock {
    std::array<double, kBlock> own, fire;                     // [K/s]
    std::array<double, kBlock> loss, rate, exponent, decay;   // [1/s], [1/s], [1], [1]
    std::array<double, kBlock> lost_air, burning, particles;  // [J]
};

EMBER_VECTORISED
bool any_warm(const double* t, std::size_t count, double ambient) {
    std::int64_t other = 0;
    for (std::size_t n = 0; n < count; ++n)
        other += t[n] != ambient ? 1 : 0;
    return other != 0;
}

// Fills own and fire; returns whether any of the two is given.
bool gather_sources(const SheetState& sheet, const std::vector<double>& source, std::size_t first,
                    std::size_t count, const ExchangeLaw& law, ExchangeBlock& b) {
    bool any = false;
    for (std::size_t n = 0; n < count; ++n) {
        b.own[n] = sheet.phase[first + n] == Phase::Burning ? law.own : 0.0;
        any |= b.own[n] != 0;
    }
    const std::size_t known = law.span > 0 && source.size() > first ? source.size() - first : 0;
    for (std::size_t n = 0; n < count; ++n) {
        b.fire[n] = n < known ? source[first + n] : 0.0;
        any |= b.fire[n] != 0;
    }
    return any;
}

EMBER_VECTORISED
void find_rates(const double* t, std::size_t count, const ExchangeLaw& law, ExchangeBlock& b) {
    for (std::size_t n = 0; n < count; ++n) {
        const double radiation = law.radiation * (t[n] + law.ambient) *
                                 (t[n] * t[n] + law.ambient * law.ambient);  // frozen for the tick
        b.loss[n] = law.both_faces * (law.convection + radiation);
        const double given = b.own[n] + b.fire[n];
        b.rate[n] = (given > 0 ? given / law.span : 0.0) + b.loss[n];
        b.exponent[n] = -b.rate[n] * law.dt;
    }
}

// du/dt = given - rate u, solved exactly; ∫u dt follows from it.
EMBER_VECTORISED
void relax(double* __restrict t, const double* initial_mass, std::size_t count,
           const ExchangeLaw& law, ExchangeBlock& b) {
    for (std::size_t n = 0; n < count; ++n) {
        const double u = t[n] - law.ambient;
        const double given = b.own[n] + b.fire[n], rate = b.rate[n];
        const double limit = rate > 0 ? given / rate : 0.0;
        const double after = rate > 0 ? limit + (u - limit) * b.decay[n] : u + given * law.dt;
        const double integral =
            rate > 0 ? limit * law.dt + (u - limit) * (1.0 - b.decay[n]) / rate : u * law.dt;
        // a cold node that nothing heats stays exactly as it is
        t[n] = u == 0 && given == 0 ? t[n] : law.ambient + after;
        const double capacity = law.capacity_per_mass * initial_mass[n];
        // lost and given come from the same integral but not from each other, so that the ledger
        // checks the temperature
        b.lost_air[n] = capacity * b.loss[n] * integral;
        const double per_heating = law.span > 0 ? capacity * (law.dt - integral / law.span) : 0.0;
        b.burning[n] = b.own[n] * per_heating;
        b.particles[n] = b.fire[n] * per_heating;
    }
}

// Pairwise over the lanes of a block; always the same order.
double sum_of(const std::array<double, kBlock>& values, std::size_t count) {
    std::array<double, kLanes> lane{};
    for (std::size_t n = 0; n < count; ++n)
        lane[n % kLanes] += values[n];
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) +
           ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

void exchange_block(double* t, const double* initial_mass, std::size_t count,
                    const ExchangeLaw& law, ExchangeBlock& b, HeatLedger& ledger) {
    find_rates(t, count, law, b);
    for (std::size_t n = 0; n < count; ++n)
        b.decay[n] = ember::exp(b.exponent[n]);
    relax(t, initial_mass, count, law, b);
    ledger.lost_air += sum_of(b.lost_air, count);
    ledger.given_burning += sum_of(b.burning, count);
    ledger.given_fire += sum_of(b.particles, count);
}

}  // namespace

void exchange_heat(SheetState& sheet, const Params& params, const std::vector<double>& source,
                   double dt, HeatLedger& ledger, StepCounters& counters) {
    const ExchangeLaw law = law_of(params, dt);
    ExchangeBlock block;
    const std::size_t nodes = sheet.temperature.size();
    for (std::size_t first = 0; first < nodes; first += kBlock) {
        const std::size_t count = std::min(kBlock, nodes - first);
        double* t = &sheet.temperature[first];
        const bool heated = gather_sources(sheet, source, first, count, law, block);
        if (params.numerics.skip && !heated && !any_warm(t, count, law.ambient)) continue;
        exchange_block(t, &sheet.initial_mass[first], count, law, block, ledger);
        counters.heat_nodes += static_cast<std::int64_t>(count);
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

EMBER_VECTORISED
void add_heat(const double* t, const double* initial_mass, std::size_t count, double ambient,
              double* sum) {
    std::size_t n = 0;
    for (; n + kLanes <= count; n += kLanes) {
        for (std::size_t k = 0; k < kLanes; ++k)
            sum[k] += initial_mass[n + k] * (t[n + k] - ambient);
    }
    for (; n < count; ++n)
        sum[n % kLanes] += initial_mass[n] * (t[n] - ambient);
}

double stored_heat(const SheetState& sheet, const PaperParams& paper, double ambient) {
    double sum[kLanes] = {};
    add_heat(sheet.temperature.data(), sheet.initial_mass.data(), sheet.temperature.size(), ambient,
             sum);
    double mass_kelvin = 0;  // [kg K]
    for (const double s : sum)
        mass_kelvin += s;
    return heat_capacity(paper, 1.0) * mass_kelvin;
}

}  // namespace ember
