#include "app/command_check.h"

#include <cstdio>
#include <memory>

#include "app/exit_code.h"
#include "app/preset_io/preset_io.h"
#include "app/run_options.h"
#include "sim/param_table.h"
#include "sim/scene.h"
#include "sim/sheet_builder.h"

namespace ember {
namespace {

// Prints every problem of one preset; returns whether it can be used.
bool check_one(const std::string& file) {
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    std::filesystem::path path = file;
    if (!std::filesystem::exists(path)) path = locate_preset(file);
    const PresetResult result = load_preset(path, bindings);
    for (const Diagnostic& d : result.diagnostics)
        std::printf("%s\n", d.text().c_str());
    if (!result.ok()) return false;
    try {
        for (const SheetPlan& plan : make_scene(params.sheet).sheets)
            validate(plan);
    } catch (const std::invalid_argument& e) {
        std::printf("%s: error: %s\n", file.c_str(), e.what());
        return false;
    }
    for (const std::string& warning : plausibility_warnings(params)) {
        std::printf("%s: warning: %s\n", file.c_str(), warning.c_str());
    }
    std::printf("%s: ok\n", file.c_str());
    return true;
}

}  // namespace

void declare_check(CLI::App& program, Command& command) {
    CLI::App* sub = program.add_subcommand("check", "Validate presets; prints all problems");
    const auto files = std::make_shared<std::vector<std::string>>();
    sub->add_option("FILE", *files, "Presets")->required();
    sub->callback([&command, files] {
        command = [files] {
            bool good = true;
            for (const std::string& file : *files)
                good = check_one(file) && good;
            return good ? kOk : kBadInput;
        };
    });
}

}  // namespace ember
