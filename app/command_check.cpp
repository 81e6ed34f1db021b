// emberleaf check: every problem of every preset, where it stands.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/run_options.h"
#include "sim/param_table.h"

namespace ember {
namespace {

using Severity = Diagnostic::Severity;

// What can be said only of the parameters together.
void check_together(const std::string& file, Params& params, RenderParams& render,
                    PresetResult& result) {
    std::vector<Diagnostic>& diagnostics = result.diagnostics;
    for (const auto& problems :
         {scene_problems(params, result.info), read_prints(render, result.info)}) {
        diagnostics.insert(diagnostics.end(), problems.begin(), problems.end());
    }
    for (const std::string& warning : plausibility_warnings(params)) {
        diagnostics.push_back({Severity::Warning, file, 0, 0, "", warning});
    }
}

bool check_file(const std::string& name) {
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    PresetResult result;
    try {
        const std::filesystem::path path = resolve_preset(name);
        result = load_preset(path, bindings);
        if (result.ok()) check_together(path.string(), params, render, result);
    } catch (const InputError& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return false;
    }
    const std::string text = diagnostics_text(result.diagnostics);
    if (!text.empty()) std::fprintf(stderr, "%s\n", text.c_str());
    if (result.ok()) std::printf("%s: ok\n", name.c_str());
    return result.ok();
}

}  // namespace

void add_check_command(CLI::App& command, Task& task) {
    const auto files = std::make_shared<std::vector<std::string>>();
    command.add_option("FILE", *files, "preset files or names of built-in presets")->required();
    command.callback([files, &task] {
        task = [files] {
            bool good = true;
            for (const std::string& file : *files)
                good = check_file(file) && good;
            return good ? kOk : kBadInput;
        };
    });
}

}  // namespace ember
