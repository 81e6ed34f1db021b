#include "sim/burning.h"

#include <algorithm>

#include "sim/vectorise.h"

namespace ember {
namespace {

// Nodes looked at together. Where nothing in a block is hot enough, one branch-free pass says so.
constexpr std::size_t kBlock = 64;

EMBER_VECTORISED bool any_hot(const double* temperature, std::size_t count, double ignition) {
    std::uint64_t hot = 0;
    for (std::size_t i = 0; i < count; ++i)
        hot |= temperature[i] < ignition ? 0u : 1u;
    return hot != 0;
}

struct Burn {
    const Params& params;
    double time, dt;
    SheetState& sheet;
    std::vector<Index>& burnt_out;
    StepCounters& counters;
    double gone = 0;  // [kg]
};

void light(Burn& b, std::size_t n) {
    if (b.sheet.temperature[n] < b.params.burning.ignition || b.sheet.held[n] != 0) return;
    b.sheet.phase[n] = Phase::Burning;
    b.sheet.ignition_time[n] = b.time;
    ++b.counters.nodes_ignited;
}

void burn(Burn& b, std::size_t n) {
    SheetState& sheet = b.sheet;
    const BurningParams& burning = b.params.burning;
    const double area = sheet.initial_mass[n] / b.params.paper.grammage;
    const double residue = burning.residual_mass * sheet.initial_mass[n];
    const double left = sheet.mass[n] - burning.burn_rate * area * b.dt;
    const double after = left > residue ? left : residue;
    b.gone += sheet.mass[n] - after;
    sheet.mass[n] = after;
    if (left > residue) {
        ++b.counters.nodes_burning;
        return;
    }
    sheet.phase[n] = Phase::BurntOut;
    sheet.burnout_time[n] = b.time;
    b.burnt_out.push_back(sheet.site[n]);
    ++b.counters.nodes_burnt_out;
}

void update_all(Burn& b) {
    b.counters.burning_visited += static_cast<std::int64_t>(b.sheet.phase.size());
    for (std::size_t n = 0; n < b.sheet.phase.size(); ++n) {
        if (b.sheet.phase[n] == Phase::Unburnt) {
            light(b, n);
        } else if (b.sheet.phase[n] == Phase::Burning) {
            burn(b, n);
        }
    }
}

// The burning nodes, and the blocks with a node at the ignition temperature. What is lit here does
// not burn before the next tick, so the two do not mix.
void update_active(Burn& b, const std::vector<Index>& burning) {
    b.counters.burning_visited += static_cast<std::int64_t>(burning.size());
    const std::size_t nodes = b.sheet.phase.size();
    for (std::size_t begin = 0; begin < nodes; begin += kBlock) {
        const std::size_t end = std::min(begin + kBlock, nodes);
        const double* temperature = b.sheet.temperature.data() + begin;
        if (!any_hot(temperature, end - begin, b.params.burning.ignition)) continue;
        for (std::size_t n = begin; n < end; ++n) {
            if (b.sheet.phase[n] != Phase::Unburnt) continue;
            ++b.counters.burning_visited;
            light(b, n);
        }
    }
    for (const Index n : burning)
        burn(b, static_cast<std::size_t>(n));
}

}  // namespace

double update_phases(const Params& params, double time, double dt, const ActiveNodes* active,
                     SheetState& sheet, std::vector<Index>& burnt_out, StepCounters& counters) {
    Burn b{params, time, dt, sheet, burnt_out, counters};
    if (active != nullptr) {
        update_active(b, active->burning);
    } else {
        update_all(b);
    }
    return b.gone;
}

}  // namespace ember
