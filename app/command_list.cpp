#include "app/command_list.h"

#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/exit_code.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/param_table.h"

namespace ember {
namespace {

int list_presets() {
    for (const std::string& name : built_in_presets()) {
        Params params;
        RenderParams render;
        const ParamBinding bindings[] = {bind(params), bind(render)};
        const PresetResult result = load_preset(find_preset(name, "."), bindings);
        std::printf("%-24s %s\n", name.c_str(), result.info.title.c_str());
    }
    return kOk;
}

int list_params(bool markdown) {
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    if (markdown) {
        std::fputs(parameters_markdown(bindings).c_str(), stdout);
        return kOk;
    }
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            std::printf("%-28s %-12s %-14s %s\n", std::string(row.key).c_str(),
                        value_text(row, binding.object).c_str(), std::string(row.unit.name).c_str(),
                        std::string(row.help).c_str());
        }
    }
    return kOk;
}

}  // namespace

std::vector<std::string> built_in_presets() {
    std::vector<std::string> names;
    for (const std::filesystem::path& folder : preset_folders()) {
        std::error_code error;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
            if (entry.path().extension() != ".toml") continue;
            names.push_back(
                entry.path().lexically_relative(folder).replace_extension().generic_string());
        }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void declare_presets(CLI::App& program, Command& command) {
    program.add_subcommand("presets", "List the built-in presets")->callback([&command] {
        command = list_presets;
    });
}

void declare_params(CLI::App& program, Command& command) {
    CLI::App* sub = program.add_subcommand("params", "List every parameter with its default");
    const auto markdown = std::make_shared<bool>(false);
    sub->add_flag("--markdown", *markdown, "As docs/PARAMETERS.md");
    sub->callback(
        [&command, markdown] { command = [markdown] { return list_params(*markdown); }; });
}

}  // namespace ember
