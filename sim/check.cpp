#include "sim/check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sim/energy.h"
#include "sim/vectorise.h"

namespace ember {
namespace {

constexpr double kSmallestEnergy = 1e-12;  // [J] below which a ledger is rounding only

void fail(StepReport& report, Stage stage, std::string reason) {
    report.status = StepStatus::Diverged;
    report.stage = stage;
    report.reason = std::move(reason);
}

std::string in_joules(const char* format, double a, double b) {
    char text[160];
    std::snprintf(text, sizeof text, format, a, b);
    return text;
}

// Whether all values are finite: x * 0 is 0 for every finite x and NaN otherwise, without a branch,
// in eight sums side by side, as one could not be vectorised.
EMBER_VECTORISED bool all_finite(const double* __restrict values, std::size_t count) {
    double sums[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        for (std::size_t l = 0; l < 8; ++l)
            sums[l] += values[i + l] * 0.0;
    }
    for (; i < count; ++i)
        sums[0] += values[i] * 0.0;
    for (std::size_t l = 1; l < 8; ++l)
        sums[0] += sums[l];
    return sums[0] == 0.0;
}

// First value that is not finite, or -1.
Index first_bad(const std::vector<double>& values) {
    if (all_finite(values.data(), values.size())) return kNone;
    const auto bad =
        std::find_if_not(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
    return static_cast<Index>(bad - values.begin());
}

struct NamedArray {
    const std::vector<double>& values;
    Stage stage;
    const char* name;
};

bool check_sheet(const SheetState& sheet, Index number, StepReport& report) {
    const NamedArray arrays[] = {{sheet.position.x, Stage::Springs, "position"},
                                 {sheet.position.y, Stage::Springs, "position"},
                                 {sheet.position.z, Stage::Springs, "position"},
                                 {sheet.velocity.x, Stage::Springs, "velocity"},
                                 {sheet.velocity.y, Stage::Springs, "velocity"},
                                 {sheet.velocity.z, Stage::Springs, "velocity"},
                                 {sheet.temperature, Stage::Heat, "temperature"},
                                 {sheet.mass, Stage::Burning, "mass"}};
    for (const NamedArray& array : arrays) {
        const Index bad = first_bad(array.values);
        if (bad == kNone) continue;
        report.sheet = number;
        report.node = bad;
        fail(report, array.stage, std::string(array.name) + " is not finite");
        return false;
    }
    const Index bad = first_bad(sheet.rest_length);
    if (bad != kNone) fail(report, Stage::Shrinkage, "a rest length is not finite");
    return bad == kNone;
}

bool check_particles(const FireState& fire, StepReport& report) {
    for (const auto* values :
         {&fire.position.x, &fire.position.y, &fire.position.z, &fire.velocity.x, &fire.velocity.y,
          &fire.velocity.z, &fire.temperature}) {
        if (first_bad(*values) == kNone) continue;
        fail(report, Stage::Fire, "a fire particle is not finite");
        return false;
    }
    return true;
}

// The node that moves fastest: where energy comes from nowhere, it comes from there.
void blame_fastest(const WorldState& state, StepReport& report) {
    double fastest = -1.0;
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        const SheetState& sheet = state.sheets[s];
        for (std::size_t n = 0; n < sheet.mass.size(); ++n) {
            const double speed = sheet.velocity.at(n).squaredNorm();
            if (!(speed > fastest)) continue;
            fastest = speed;
            report.sheet = static_cast<Index>(s);
            report.node = static_cast<Index>(n);
        }
    }
}

}  // namespace

void check_state(WorldState& state, StepReport& report) {
    for (std::size_t s = 0; s < state.sheets.size(); ++s) {
        if (!check_sheet(state.sheets[s], static_cast<Index>(s), report)) return;
    }
    if (!check_particles(state.fire, report)) return;
    const double before = state.energy.unaccounted;
    if (!settle(state.energy)) {
        blame_fastest(state, report);
        fail(report, Stage::Springs,
             in_joules("%.3g J of mechanical energy came from nowhere (largest term %.3g J)",
                       state.energy.unaccounted - before, state.energy.largest));
        return;
    }
    const HeatLedger& h = state.heat;
    const double given = h.given_fire + h.given_burning;
    const double missing = h.stored + h.lost_air + h.lost_held - given - h.change_edit;
    const double largest = std::max(given, std::abs(h.change_edit));
    if (!(std::abs(missing) <= std::max(kHeatMargin * largest, kSmallestEnergy))) {
        fail(report, Stage::Heat,
             in_joules("heat ledger is off by %.3g J of %.3g J given", missing, given));
    }
}

}  // namespace ember
