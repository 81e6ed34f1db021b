// emberleaf presets and emberleaf params: what there is.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/preset_io/parameter_value.h"
#include "app/run_options.h"
#include "sim/param_table.h"

namespace ember {
namespace {

int list_presets() {
    for (const std::string& name : built_in_presets()) {
        Params params;
        RenderParams render;
        const ParamBinding bindings[] = {bind(params), bind(render)};
        const PresetResult result = load_preset(resolve_preset(name), bindings);
        std::printf("%-24s %s\n", name.c_str(),
                    result.ok() ? result.info.title.c_str() : "(broken: see emberleaf check)");
    }
    return kOk;
}

int list_parameters(bool markdown) {
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    if (markdown) {
        std::fputs(parameters_markdown(bindings).c_str(), stdout);
        return kOk;
    }
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            const std::string value =
                value_text(row, binding.object) + ' ' + std::string(row.unit.name);
            std::printf("%-28s %-16s %s\n%-28s %-16s %s\n", std::string(row.key).c_str(),
                        value.c_str(), expected(row).c_str(), "", "",
                        std::string(row.help).c_str());
        }
    }
    return kOk;
}

}  // namespace

void add_presets_command(CLI::App& command, Task& task) {
    command.callback([&task] { task = list_presets; });
}

void add_params_command(CLI::App& command, Task& task) {
    const auto markdown = std::make_shared<bool>(false);
    command.add_flag("--markdown", *markdown, "as docs/PARAMETERS.md");
    command.callback(
        [markdown, &task] { task = [markdown] { return list_parameters(*markdown); }; });
}

}  // namespace ember
