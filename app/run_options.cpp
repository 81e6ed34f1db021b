#include "app/run_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <sstream>
#include <thread>

#include "app/exit_code.h"
#include "app/preset_io/mask_file.h"
#include "app/preset_io/memory_limit.h"
#include "app/preset_io/nearest_word.h"
#include "app/preset_io/steering.h"
#include "sim/param_table.h"
#include "sim/scene_check.h"

namespace ember {

void add_run_options(CLI::App& command, RunOptions& options) {
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    command
        .add_option("PRESET", options.preset,
                    "a file, a built-in name such as paper/corner, or a picture of emberleaf's")
        ->required();
    command.add_option("--set", options.sets, "change a parameter: --set paper.grammage=160")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false)
        ->take_all();
    command.add_option("--seed", options.seed, "seed of all random numbers")->type_name("N");
    command
        .add_option("--threads", options.threads,
                    "default: as many as processors; never changes the result")
        ->check(CLI::Range(1, 256))
        ->type_name("N");
    auto* quiet = command.add_flag("-q,--quiet", options.quiet, "only errors and results");
    command.add_flag("-v,--verbose", options.verbose, "warnings too")->excludes(quiet);
}

std::vector<std::string> built_in_presets() {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : preset_folders()) {
        std::error_code error;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
            if (entry.path().extension() != ".toml") continue;
            auto name = entry.path().lexically_relative(folder);
            names.push_back(name.replace_extension().generic_string());
        }
        if (!names.empty()) break;
    }
    std::sort(names.begin(), names.end());
    return names;
}

std::filesystem::path resolve_preset(const std::string& name) {
    const std::filesystem::path path = find_preset(name, "");
    if (!path.empty()) return path;
    std::string message = name + ": error: no such preset";
    const std::vector<std::string> names = built_in_presets();
    const std::string near =
        nearest_word(name, std::vector<std::string_view>(names.begin(), names.end()));
    if (!near.empty()) message += "; did you mean " + near + '?';
    throw InputError(message + " (emberleaf presets lists the built-in ones)");
}

std::string diagnostics_text(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics) {
        if (!text.empty()) text += '\n';
        text += diagnostic.text();
        const std::string excerpt = diagnostic.excerpt();
        if (!excerpt.empty()) text += '\n' + excerpt;
    }
    return text;
}

std::vector<Diagnostic> scene_problems(Params& params, const PresetInfo& info) {
    try {
        check_memory(params);  // before pictures are read
    } catch (const SceneError& e) {
        return {place_error(info, e)};
    }
    std::vector<Diagnostic> problems = read_masks(params, info);
    if (!problems.empty()) return problems;
    try {
        validate(make_scene(params), caliper(params.paper));
    } catch (const SceneError& e) {
        problems.push_back(place_error(info, e));
    }
    static_cast<void>(script_of(params, info, problems));
    return problems;
}

LoadedPreset load_run(const RunOptions& options, const std::vector<Assignment>& more) {
    LoadedPreset loaded;
    const ParamBinding bindings[] = {bind(loaded.params), bind(loaded.render)};
    PresetResult result = load_preset(resolve_preset(options.preset), bindings);
    std::vector<Assignment> assignments = more;
    for (const std::string& text : options.sets)
        assignments.push_back({"--set", text});
    if (!options.seed.empty()) {
        assignments.push_back({"--seed", "numerics.seed=" + options.seed});
    }
    for (const Assignment& assignment : assignments) {
        const auto problems =
            apply_override(assignment.text, bindings, assignment.origin, result.info);
        result.diagnostics.insert(result.diagnostics.end(), problems.begin(), problems.end());
    }
    if (result.ok()) {
        for (const auto& problems : {scene_problems(loaded.params, result.info),
                                     read_prints(loaded.render, result.info)}) {
            result.diagnostics.insert(result.diagnostics.end(), problems.begin(), problems.end());
        }
    }
    if (!result.ok()) {
        std::erase_if(result.diagnostics, [](const Diagnostic& d) {
            return d.severity == Diagnostic::Severity::Warning;
        });
        throw InputError(diagnostics_text(result.diagnostics));
    }
    if (options.verbose) {
        const std::string warnings = diagnostics_text(result.diagnostics);
        if (!warnings.empty()) std::fprintf(stderr, "%s\n", warnings.c_str());
        for (const std::string& warning : plausibility_warnings(loaded.params)) {
            std::fprintf(stderr, "%s: warning: %s\n", options.preset.c_str(), warning.c_str());
        }
    }
    loaded.info = result.info;
    return loaded;
}

World build_world(const LoadedPreset& preset, int threads) {
    try {
        World world = make_world(preset.params, threads);
        std::vector<Diagnostic> ignored;  // load_run() has reported them
        world.set_script(preset.params, script_of(preset.params, preset.info, ignored));
        return world;
    } catch (const SceneError& e) {  // of parameters that have been changed since
        throw InputError(diagnostics_text({place_error(preset.info, e)}));
    }
}

std::string divergence_text(const StepReport& report) {
    std::ostringstream out;
    out << "simulation stopped at t = " << report.time << " s: " << cause_text(report) << " (after "
        << report.retries << " retries with half the step)";
    return out.str();
}

}  // namespace ember
