#include "app/bench/shipped_defaults.h"

#include <algorithm>

#include "app/preset_io/parameter_value.h"
#include "app/run_options.h"
#include "sim/param_table.h"

namespace ember {
namespace {

// Rows that say how the springs are solved.
constexpr std::string_view kSolving[] = {
    "numerics.integrator",   "numerics.tolerance",   "numerics.safety",
    "numerics.substeps_min", "numerics.tick_rate",   "numerics.arithmetic",
    "numerics.skip",         "numerics.sleep_speed", "numerics.heat_solver"};

std::string value_of(std::string_view key, const Params& params) {
    std::string text = value_text(*find_param(sim_param_rows(), key), &params);
    std::erase(text, '"');  // words stand without quotes on the command line
    return text;
}

WorkSetting setting_of(const Params& params) {
    WorkSetting setting;
    const Params standard;
    setting.method = value_of("numerics.integrator", params);
    for (const std::string_view key : kSolving) {
        const std::string value = value_of(key, params);
        setting.sets.push_back(std::string(key) + '=' + value);
        // what everybody has is not worth saying
        if (key == "numerics.integrator" || value == value_of(key, standard)) continue;
        setting.label +=
            (setting.label.empty() ? "" : ", ") + std::string(key.substr(9)) + ' ' + value;
    }
    if (setting.label.empty()) setting.label = "as the program has it";
    return setting;
}

}  // namespace

std::vector<WorkPoint> shipped_defaults(PresetKind kind) {
    std::vector<WorkPoint> found;
    for (const std::string& name : built_in_presets()) {
        const Params params = bench_params(name);
        if ((params.lighter.on ? PresetKind::Burns : PresetKind::OnlyMoves) != kind) continue;
        const WorkSetting setting = setting_of(params);
        const auto same = std::find_if(found.begin(), found.end(), [&](const WorkPoint& p) {
            return p.setting.sets == setting.sets;
        });
        if (same != found.end()) {
            same->presets.push_back(name);
        } else {
            found.push_back({.setting = setting, .presets = {name}});
        }
    }
    return found;
}

}  // namespace ember
