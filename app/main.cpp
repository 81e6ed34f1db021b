// The program: reads the command line, runs what it asks for, turns failures into exit codes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/preset_io/nearest_word.h"
#include "app/version.h"

namespace {

// "--frmes" is near "--frames" of the chosen subcommand.
std::string suggestion(const CLI::App& app) {
    const CLI::App* chosen = app.get_subcommands().empty() ? &app : app.get_subcommands().front();
    std::vector<std::string> names;
    for (const CLI::Option* option : chosen->get_options()) {
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    }
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    for (const std::string& word : app.remaining(true)) {
        const std::string flag = word.substr(0, word.find('='));
        const std::string near = ember::nearest_word(flag, candidates);
        if (flag.starts_with("-") && !near.empty()) {
            return "; for " + flag + ", did you mean " + near + '?';
        }
    }
    return {};
}

int parse_and_run(int argc, char** argv) {
    CLI::App app("Simulates and draws burning paper.", "emberleaf");
    app.set_version_flag("--version", std::string("emberleaf ") + ember::kVersion);
    app.require_subcommand(0, 1);
    ember::Task task;
    ember::add_render_command(app, task);
    ember::add_simulate_command(app, task);
    ember::add_check_command(app, task);
    ember::add_presets_command(app, task);
    ember::add_params_command(app, task);
    ember::add_window_command(app, task);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& e) {  // --help and --version
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        throw ember::InputError(std::string("error: ") + e.what() + suggestion(app) +
                                "\nemberleaf --help, emberleaf COMMAND --help");
    }
    return task();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return parse_and_run(argc, argv);
    } catch (const ember::InputError& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return ember::kBadInput;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "error: not enough memory\n");
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
    }
    return ember::kRunFailed;
}
