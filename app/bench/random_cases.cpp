#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "app/bench/bench_run.h"
#include "app/bench/stress_case.h"
#include "sim/param_table.h"
#include "sim/random.h"

namespace ember {
namespace {

enum class Spread { Even, Decades, Any };  // linear, logarithmic, any choice or integer

struct Dimension {
    std::string_view key;
    Spread spread;
    double low = 0, high = 1;  // in the shown unit
};

// Far outside the tested ranges, within the hard ones.
constexpr Dimension kDimensions[] = {{"paper.grammage", Spread::Decades, 5, 2000},
                                     {"paper.density", Spread::Decades, 100, 3000},
                                     {"paper.c_s", Spread::Decades, 1e-5, 1},
                                     {"paper.specific_heat", Spread::Decades, 100, 1e4},
                                     {"paper.conductivity", Spread::Decades, 1e-3, 10},
                                     {"shrinkage.floor", Spread::Even, 0.05, 1},
                                     {"shrinkage.rule", Spread::Any, 0, 1},
                                     {"shrinkage.literal_stiffness", Spread::Any, 0, 1},
                                     {"lighter.x", Spread::Even, -100, 100},
                                     {"lighter.y", Spread::Even, 200, 460},
                                     {"lighter.z", Spread::Even, -10, 10},
                                     {"lighter.rate", Spread::Decades, 10, 1e4},
                                     {"lighter.strength", Spread::Decades, 0.01, 100},
                                     {"sheet.width", Spread::Decades, 10, 500},
                                     {"sheet.height", Spread::Decades, 10, 500},
                                     {"sheet.border", Spread::Any, 0, 1},
                                     {"sheet.shape", Spread::Any, 0, 1},
                                     {"sheet.pose", Spread::Any, 0, 1},
                                     {"sheet.held", Spread::Any, 0, 10},
                                     {"sheet.count", Spread::Any, 1, 3},
                                     {"sheet.gap", Spread::Even, 0, 50},
                                     {"sheet.elevation", Spread::Even, 0, 500},
                                     {"sheet.imperfection", Spread::Decades, 1e-3, 10},
                                     {"springs.stiffness_scale", Spread::Decades, 0.1, 1000},
                                     {"springs.damping", Spread::Even, 0, 50},
                                     {"springs.stiffness_law", Spread::Any, 0, 1},
                                     {"springs.variation", Spread::Even, 0, 80},
                                     {"springs.variation_pattern", Spread::Any, 0, 1},
                                     {"springs.follows_mass", Spread::Any, 0, 1},
                                     {"world.gravity", Spread::Even, 0, 100},
                                     {"world.held_gravity", Spread::Decades, 0.01, 1},
                                     {"world.air_drag", Spread::Decades, 1e-3, 100},
                                     {"world.air_drag_tangential", Spread::Even, 0, 1},
                                     {"world.ground", Spread::Any, 0, 1},
                                     {"contact.sheets", Spread::Any, 0, 1},
                                     {"contact.self", Spread::Any, 0, 1},
                                     {"contact.thickness", Spread::Decades, 0.01, 20},
                                     {"contact.friction", Spread::Even, 0, 2},
                                     {"contact.ground_friction", Spread::Even, 0, 2},
                                     {"contact.interval", Spread::Decades, 1e-3, 0.1},
                                     {"heat.ambient", Spread::Even, -100, 100},
                                     {"heat.flame_limit", Spread::Even, 50, 5000},
                                     {"heat.convection", Spread::Decades, 0.1, 1e4},
                                     {"heat.emissivity", Spread::Even, 0, 1},
                                     {"burning.ignition", Spread::Even, -50, 1200},
                                     {"burning.burn_rate", Spread::Decades, 1, 1e5},
                                     {"burning.residual_mass", Spread::Decades, 1, 90},
                                     {"burning.heat_release", Spread::Decades, 1, 1e6},
                                     {"burning.burn_speed", Spread::Decades, 0.1, 100},
                                     {"fire.temperature", Spread::Even, -50, 3000},
                                     {"fire.emission", Spread::Decades, 1e3, 1e8},
                                     {"fire.heating", Spread::Decades, 1, 1e7},
                                     {"fire.heating_limit", Spread::Decades, 100, 1e7},
                                     {"fire.kernel_radius", Spread::Decades, 0.5, 100},
                                     {"fire.absorption", Spread::Even, 0, 1000},
                                     {"fire.node_strength", Spread::Decades, 0.01, 100},
                                     {"fire.life_min", Spread::Decades, 0.01, 1},
                                     {"fire.life_max", Spread::Decades, 0.01, 1},
                                     {"fire.buoyancy", Spread::Even, 0, 100},
                                     {"fire.drag", Spread::Even, 0, 100},
                                     {"fire.force", Spread::Decades, 1e-4, 100},
                                     {"fire.force_limit", Spread::Decades, 0.01, 1000},
                                     {"fracture.threshold", Spread::Decades, 1e-3, 100},
                                     {"fracture.middle_burnt", Spread::Any, 0, 1},
                                     {"fracture.relief_radius", Spread::Even, 0, 50},
                                     {"fracture.relief_time", Spread::Even, 0, 0.2},
                                     {"fracture.release_hinges", Spread::Any, 0, 1},
                                     {"numerics.seed", Spread::Any, 0, 1000000},
                                     {"numerics.tick_rate", Spread::Decades, 1, 240},
                                     {"numerics.integrator", Spread::Any, 0, 7},
                                     {"numerics.tolerance", Spread::Decades, 1e-9, 1e-3},
                                     {"numerics.safety", Spread::Even, 0.1, 0.9},
                                     {"numerics.heat_solver", Spread::Any, 0, 3},
                                     {"numerics.arithmetic", Spread::Any, 0, 1},
                                     {"numerics.skip", Spread::Any, 0, 1}};

constexpr std::string_view kFactors[] = {"0", "5e-12", "5e-10"};
constexpr std::string_view kSleepSpeeds[] = {"0", "0", "1e-3"};

struct Cells {
    int rows, columns;
};
constexpr Cells kLattices[] = {{64, 96}, {32, 48}, {33, 17}, {16, 24}, {16, 24}, {7, 4}, {3, 5},
                               {3, 5},   {2, 2},   {2, 2},   {1, 6},   {5, 1},   {1, 1}, {1, 1}};

// Column `number` of the hypercube: one value in each of `count` equal parts of [0, 1), shuffled.
std::vector<double> shuffled_parts(std::size_t count, std::uint64_t seed, std::uint64_t number) {
    std::vector<std::uint64_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    const auto bits = [&](std::uint64_t i, std::uint64_t lane) {
        return mix(mix(mix(seed) ^ number) ^ (2 * i + lane));
    };
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[bits(i, 0) % i]);
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        const double within = static_cast<double>(bits(i, 1) >> 11) * 0x1p-53;
        values.push_back((static_cast<double>(order[i]) + within) / static_cast<double>(count));
    }
    return values;
}

std::string assignment(const Dimension& d, double share) {
    const std::string key = std::string(d.key) + '=';
    if (d.spread == Spread::Decades)
        return key + short_text(d.low * std::pow(d.high / d.low, share), 4);
    if (d.spread == Spread::Even) return key + short_text(d.low + share * (d.high - d.low), 4);
    const double whole = d.low + std::floor(share * (d.high - d.low + 1));
    const ParamInfo& row = *find_param(sim_param_rows(), d.key);
    if (!row.choices.empty()) {
        return key + std::string(row.choices[static_cast<std::size_t>(whole)]);
    }
    if (row.kind == ParamKind::Toggle) return key + (whole > 0 ? "true" : "false");
    return key + std::to_string(static_cast<long>(whole));
}

template <class List>
auto pick(const List& list, double share) {
    return list[static_cast<std::size_t>(share * static_cast<double>(std::size(list)))];
}

// About how many node evaluations a tick takes: sub-steps by the fastest springs, times nodes.
double estimated_work(const Params& p, Cells cells) {
    constexpr double kReferenceArea = 0.21 * 0.297 / (33 * 49);  // [m^2] that stiffness is for
    const double dx = p.sheet.height / cells.columns, dz = p.sheet.width / cells.rows;
    double finer = 1;
    if (p.springs.stiffness_law == StiffnessLaw::PerArea) {
        finer = kReferenceArea / (dx * dz) * std::max(dx / dz, dz / dx);
    }
    const double lost = p.springs.follows_mass ? 1.0 : 1.0 / p.burning.residual_mass;
    const double stiffness = p.springs.structural + p.springs.diagonal + p.springs.bending;
    const double omega = std::sqrt(16 * p.springs.stiffness_scale * stiffness * finer * lost);
    const double gamma = 48 * p.springs.damping * finer * lost;
    const double substeps = std::max(omega, gamma) / (p.numerics.tick_rate * p.numerics.safety) + 1;
    return substeps * p.sheet.count * (cells.rows + 1) * (cells.columns + 1);
}

// The lattice that is asked for, or the next smaller one that does not take forever.
Cells affordable(const Params& params, double share) {
    constexpr double kMostWork = 4e5;  // node evaluations per tick
    auto at = static_cast<std::size_t>(share * static_cast<double>(std::size(kLattices)));
    while (at + 1 < std::size(kLattices) && estimated_work(params, kLattices[at]) > kMostWork)
        ++at;
    return kLattices[at];
}

}  // namespace

std::vector<StressCase> random_cases(std::size_t count, std::uint64_t seed) {
    std::vector<StressCase> cases(count);
    std::uint64_t number = 0;
    for (const Dimension& dimension : kDimensions) {
        const std::vector<double> shares = shuffled_parts(count, seed, number++);
        for (std::size_t i = 0; i < count; ++i)
            cases[i].sets.push_back(assignment(dimension, shares[i]));
    }
    const std::vector<double> factors = shuffled_parts(count, seed, number++);
    const std::vector<double> speeds = shuffled_parts(count, seed, number++);
    const std::vector<double> lattices = shuffled_parts(count, seed, number++);
    for (std::size_t i = 0; i < count; ++i) {
        StressCase& c = cases[i];
        c.name = "random_" + std::to_string(i);
        c.sets.push_back("shrinkage.factor=" + std::string(pick(kFactors, factors[i])));
        c.sets.push_back("numerics.sleep_speed=" + std::string(pick(kSleepSpeeds, speeds[i])));
        const Params params = stress_params(c);
        Cells cells = affordable(params, lattices[i]);
        if (params.sheet.shape == SheetShape::Cylinder) {
            // what cannot be built is refused, which is tested elsewhere
            cells.rows = std::max(cells.rows, 3);
            const HeldEdge held = params.sheet.held;
            if ((held & HeldEdge::BothMainEnds) != held)
                c.sets.emplace_back("sheet.held=main_start");
        }
        c.sets.push_back("sheet.rows=" + std::to_string(cells.rows));
        c.sets.push_back("sheet.columns=" + std::to_string(cells.columns));
    }
    return cases;
}

Params stress_params(const StressCase& stress) {
    static const Params corner = bench_params("paper/corner");
    Params params = corner;
    set_params(params, stress.sets);
    return params;
}

std::string reproduction(const StressCase& stress) {
    const double rate = stress_params(stress).numerics.tick_rate;
    std::string text =
        "emberleaf simulate paper/corner --seconds " + short_text(stress.ticks / rate, 6);
    for (const std::string& set : stress.sets)
        text += " --set " + set;
    return text;
}

}  // namespace ember
