#include "app/stats_json.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "app/version.h"
#include "sim/param_table.h"
#include "sim/units.h"

namespace ember {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kStatsSchema = 1;

Json stages(const std::array<double, kStageCount>& ms) {
    Json out;
    for (std::size_t s = 0; s < kStageCount; ++s)
        out[std::string(kStageNames[s])] = ms[s];
    return out;
}

Json work(const StepCounters& counters) {
    Json out;
    for_each_counter(counters, [&](const char* name, std::int64_t count) { out[name] = count; });
    return out;
}

// Name of a value of a parameter that is a choice.
template <class Choice>
std::string choice_name(std::string_view key, Choice value) {
    const ParamInfo* row = find_param(sim_param_rows(), key);
    return std::string(row->choices[static_cast<std::size_t>(value)]);
}

Json nodes(const PhaseCounts& counts) {
    return {
        {"unburnt", counts.unburnt}, {"burning", counts.burning}, {"burnt_out", counts.burnt_out}};
}

Json frame(const TickStats& t) {
    return {{"tick", t.tick},
            {"t", t.time},
            {"nodes", nodes(t.nodes)},
            {"mass", t.mass},
            {"temperature", {{"min", t.coldest}, {"max", t.hottest}}},
            {"energy",
             {{"kinetic", t.kinetic}, {"elastic", t.elastic}, {"gravitational", t.gravitational}}},
            {"particles", t.particles},
            {"emitters", t.emitters},
            {"cuts", t.cuts},
            {"substeps", t.work.substeps},
            {"integrator", choice_name("numerics.integrator", t.integrator)},
            {"heat_solver", choice_name("numerics.heat_solver", t.heat_solver)},
            {"retries", t.retries},
            {"ms", stages(t.ms)},
            {"work", work(t.work)}};
}

Json energy_ledger(const EnergyLedger& e) {
    return {{"initial", e.initial},
            {"kinetic", e.kinetic},
            {"elastic", e.elastic},
            {"gravitational", e.gravitational},
            {"work_fire", e.work_fire},
            {"work_wind", e.work_wind},
            {"loss_damping", e.loss_damping},
            {"loss_drag", e.loss_drag},
            {"loss_sleep", e.loss_sleep},
            {"change_scheme", e.change_scheme},
            {"work_contact", e.work_contact},
            {"change_mass", e.change_mass},
            {"change_rest_length", e.change_rest_length},
            {"change_topology", e.change_topology},
            {"change_edit", e.change_edit}};
}

Json heat_ledger(const HeatLedger& h) {
    return {{"stored", h.stored},
            {"given_fire", h.given_fire},
            {"given_burning", h.given_burning},
            {"lost_air", h.lost_air},
            {"lost_held", h.lost_held}};
}

std::size_t quad_count(const WorldState& state) {
    std::size_t count = 0;
    for (const SheetState& sheet : state.sheets)
        count += sheet.quads.size();
    return count;
}

}  // namespace

PhaseCounts count_phases(const WorldState& state) {
    PhaseCounts counts;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.phase.size(); ++n) {
            if (sheet.initial_mass[n] == 0) continue;  // no paper
            counts.unburnt += sheet.phase[n] == Phase::Unburnt;
            counts.burning += sheet.phase[n] == Phase::Burning;
            counts.burnt_out += sheet.phase[n] == Phase::BurntOut;
        }
    }
    return counts;
}

std::string labelled_hash(const World& world) {
    const bool fast = world.params().numerics.arithmetic == Arithmetic::Fast;
    return (fast ? "fast state hash: " : "state hash: ") + hash_text(world.hash());
}

std::string hash_text(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

void StatsRecorder::record(const World& world, const StepReport& report) {
    const WorldState& state = world.state();
    TickStats t;
    t.tick = state.tick;
    t.time = state.time;
    t.nodes = count_phases(state);
    t.coldest = std::numeric_limits<double>::infinity();
    t.hottest = -t.coldest;
    for (const SheetState& sheet : state.sheets) {
        t.mass = std::accumulate(sheet.mass.begin(), sheet.mass.end(), t.mass);
        const auto [low, high] =
            std::minmax_element(sheet.temperature.begin(), sheet.temperature.end());
        t.coldest = std::min(t.coldest, unit::celsius.from_si(*low));
        t.hottest = std::max(t.hottest, unit::celsius.from_si(*high));
    }
    t.kinetic = state.energy.kinetic;
    t.elastic = state.energy.elastic;
    t.gravitational = state.energy.gravitational;
    t.particles = static_cast<std::int64_t>(state.fire.size());
    t.emitters = t.nodes.burning;
    for (const LighterView& lighter : world.view().lighters)
        t.emitters += lighter.lit ? 1 : 0;
    t.cuts = state.totals.cuts;
    t.retries = report.retries;
    t.work = report.counters;
    t.integrator = report.integrator;
    t.heat_solver = report.heat_solver;
    t.ms = clock_.milliseconds();
    clock_.reset();
    ticks_.push_back(t);
}

std::array<double, kStageCount> StatsRecorder::mean_ms() const {
    std::array<double, kStageCount> mean{};
    for (const TickStats& t : ticks_) {
        for (std::size_t s = 0; s < kStageCount; ++s) {
            mean[s] += t.ms[s] / static_cast<double>(ticks_.size());
        }
    }
    return mean;
}

double StatsRecorder::burnt_out_time(double share) const {
    for (const TickStats& t : ticks_) {
        if (static_cast<double>(t.nodes.burnt_out) >=
            share * static_cast<double>(t.nodes.total())) {
            return t.time;
        }
    }
    return std::numeric_limits<double>::quiet_NaN();  // null in JSON
}

std::string StatsRecorder::json(const World& world, const LoadedPreset& preset) const {
    LoadedPreset copy = preset;
    const ParamBinding bindings[] = {bind(copy.params), bind(copy.render)};
    const WorldState& state = world.state();
    Json document = {{"schema", kStatsSchema},
                     {"program", "emberleaf"},
                     {"version", kVersion},
                     {"preset",
                      {{"file", preset.info.path.string()},
                       {"title", preset.info.title},
                       {"text", preset_text(bindings, preset.info)}}},
                     {"seed", preset.params.numerics.seed},
                     {"tick_duration", world.tick_duration()},
                     {"frames", Json::array()}};
    for (const TickStats& t : ticks_)
        document["frames"].push_back(frame(t));
    document["totals"] = {{"ticks", state.tick},
                          {"t", state.time},
                          {"nodes", nodes(count_phases(state))},
                          {"quads", quad_count(state)},
                          {"ignitions", state.totals.ignitions},
                          {"burnouts", state.totals.burnouts},
                          {"cuts", state.totals.cuts},
                          {"retries", state.totals.retries},
                          {"burnt_mass", state.totals.burnt_mass},
                          {"t10", burnt_out_time(0.1)},
                          {"t50", burnt_out_time(0.5)},
                          {"t90", burnt_out_time(0.9)},
                          {"mean_ms", stages(mean_ms())},
                          {"energy", energy_ledger(state.energy)},
                          {"heat", heat_ledger(state.heat)}};
    const bool fast = world.params().numerics.arithmetic == Arithmetic::Fast;
    document[fast ? "fast_state_hash" : "state_hash"] = hash_text(world.hash());
    return document.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace ember
