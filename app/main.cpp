// The program: reads the command line, runs what it asks for, turns failures into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/preset_io/nearest_word.h"
#include "app/preset_io/preset_io.h"

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

// A mistyped command looks like the window's preset to the command line.
std::string mistyped_command(const CLI::App& app, const std::string& word) {
    if (word.starts_with("-") || !ember::find_preset(word, "").empty()) return {};
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    const std::string near =
        ember::nearest_word(word, std::vector<std::string_view>(names.begin(), names.end()));
    const bool known = std::find(names.begin(), names.end(), word) != names.end();
    return near.empty() || known
               ? ""
               : word + ": error: neither a command nor a preset; did you mean " + near + '?';
}

int parse_and_run(int argc, char** argv) {
    CLI::App app(std::string(ember::find_command("")->summary), "emberleaf");
    ember::Task task;
    ember::build_command_line(app, task);
    const std::string mistyped = argc > 1 ? mistyped_command(app, argv[1]) : "";
    if (!mistyped.empty()) throw ember::InputError(mistyped);
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
