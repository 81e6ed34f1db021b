#include "app/bench/state_oracle.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "app/bench/bench_run.h"

namespace ember {
namespace {

constexpr double kEnergyShare = 1e-3;  // of the largest term that energy may exceed its ledger by
constexpr double kHeatShare = 1e-10;   // of the heat given that may be missing
constexpr double kRounding = 1e-9;     // of sums over all nodes in another order
constexpr double kNoEnergy = 1e-12;    // [J]

// NaN is wrong everywhere; infinity stands for "never" in times, and nowhere else.
struct NumberScan {
    std::string problem;

    template <class T>
    void operator()(const char* name, const std::vector<T>& array) {
        if constexpr (std::is_same_v<T, double>) {
            for (std::size_t i = 0; i < array.size(); ++i)
                look(name, array[i], i);
        }
    }
    void operator()(const char* name, const double& value) { look(name, value, 0); }
    template <class T>
    void operator()(const char*, const T&) {}

  private:
    void look(std::string_view name, double value, std::size_t i) {
        const bool may_be_never = name == "sheet.ignition_time" || name == "sheet.burnout_time" ||
                                  name == "sheet.relief_until";
        if (std::isfinite(value) || (may_be_never && !std::isnan(value)) || !problem.empty())
            return;
        problem = std::string(name) + '[' + std::to_string(i) + "] is " + short_text(value);
    }
};

std::string compared(const char* what, double found, double expected) {
    return std::string(what) + " is " + short_text(found, 12) + ", expected " +
           short_text(expected, 12);
}

}  // namespace

StateOracle::StateOracle(const Params& params, const WorldState& start)
    : coldest_(params.heat.ambient),
      hottest_(params.heat.ambient),
      at_first_(start.energy.kinetic + start.energy.elastic),
      height_(start.energy.gravitational) {
    for (const SheetState& sheet : start.sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            coldest_ = std::min(coldest_, sheet.temperature[n]);
            hottest_ = std::max(hottest_, sheet.temperature[n]);
            initial_mass_ += sheet.initial_mass[n];
        }
    }
}

std::string StateOracle::bad_number(const WorldState& state) const {
    NumberScan scan;
    for_each_field(state, scan);
    return scan.problem;
}

std::string StateOracle::bad_temperature(const Params& params, const WorldState& state) {
    hottest_ = std::max(hottest_, params.heat.flame_limit);
    const double room = 1e-9 * hottest_;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
            const double t = sheet.temperature[n];
            if (t >= coldest_ - room && t <= hottest_ + room) continue;
            return "temperature of node " + std::to_string(n) + " is " + short_text(t, 9) +
                   " K, outside " + short_text(coldest_, 9) + " to " + short_text(hottest_, 9);
        }
    }
    return {};
}

std::string StateOracle::bad_mass(const WorldState& state) const {
    double now = state.totals.burnt_mass, initial = 0;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            now += sheet.mass[n];
            initial += sheet.initial_mass[n];
            if (!(sheet.mass[n] > 0) && sheet.initial_mass[n] != 0)
                return "mass of node " + std::to_string(n) + " is not positive";
        }
    }
    if (std::abs(initial - initial_mass_) > kRounding * initial_mass_) {
        return compared("initial mass", initial, initial_mass_);
    }
    if (std::abs(now - initial_mass_) <= kRounding * initial_mass_) return {};
    return compared("mass with what has burnt", now, initial_mass_);
}

std::string StateOracle::bad_energy(const WorldState& state) {
    const EnergyLedger& e = state.energy;
    double kinetic = 0;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.mass.size(); ++n)
            kinetic += 0.5 * sheet.mass[n] * sheet.velocity.at(n).squaredNorm();
    }
    if (std::abs(kinetic - e.kinetic) > kRounding * std::max(kinetic, e.largest) + kNoEnergy) {
        return compared("kinetic energy in the ledger", e.kinetic, kinetic);
    }
    fallen_ = std::max(fallen_, height_ - e.gravitational);
    const double put_in = at_first_ + fallen_ + std::abs(e.work_fire) + std::abs(e.work_wind) +
                          std::abs(e.change_mass) + std::abs(e.change_rest_length) +
                          std::abs(e.change_topology) + std::abs(e.change_edit) +
                          std::abs(e.work_contact);
    if (!(e.change_scheme <= put_in + kNoEnergy)) {
        return "the integrator holds " + short_text(e.change_scheme) + " J of energy, but only " +
               short_text(put_in) + " J were put in";
    }
    const double now = e.kinetic + e.elastic + e.gravitational;
    const double accounted = e.initial + e.work_fire + e.work_wind + e.change_scheme +
                             e.work_contact + e.change_mass + e.change_rest_length +
                             e.change_topology + e.change_edit - e.loss_damping - e.loss_drag -
                             e.loss_sleep;
    // sums of large terms that cancel are only as exact as the largest of them
    const double rounding =
        1e-13 * (std::abs(e.initial) + std::abs(e.gravitational) + std::abs(e.change_edit)) +
        kNoEnergy * static_cast<double>(state.tick + 1);
    if (now - accounted <= kEnergyShare * e.largest + rounding) return {};
    return compared("mechanical energy", now, accounted) + " (largest term " +
           short_text(e.largest) + " J)";
}

std::string StateOracle::bad_heat(const Params& params, const WorldState& state) const {
    double stored = 0;
    for (const SheetState& sheet : state.sheets) {
        for (std::size_t n = 0; n < sheet.temperature.size(); ++n) {
            stored += params.paper.c_s * params.paper.specific_heat * sheet.initial_mass[n] *
                      (sheet.temperature[n] - params.heat.ambient);
        }
    }
    const HeatLedger& h = state.heat;
    const double given = h.given_fire + h.given_burning;
    const double scale = std::max({std::abs(given), std::abs(stored), kNoEnergy});
    if (std::abs(stored - h.stored) > kRounding * scale) {
        return compared("stored heat in the ledger", h.stored, stored);
    }
    if (std::abs(h.stored + h.lost_air + h.lost_held - given) <= kHeatShare * scale + kNoEnergy) {
        return {};
    }
    return compared("heat stored and lost", h.stored + h.lost_air + h.lost_held, given);
}

std::string StateOracle::problem(const Params& params, const WorldState& state) {
    std::string found = bad_number(state);
    if (found.empty()) found = bad_temperature(params, state);
    if (found.empty()) found = bad_mass(state);
    if (found.empty()) found = bad_energy(state);
    if (found.empty()) found = bad_heat(params, state);
    return found;
}

}  // namespace ember
