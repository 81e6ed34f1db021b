// emberleaf: burning paper, in a window or without one.
#include <cstdio>

#include "app/command_check.h"
#include "app/command_list.h"
#include "app/command_render.h"
#include "app/command_simulate.h"
#include "app/command_window.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/version.h"

namespace {

using namespace ember;

constexpr const char* kExamples =
    "examples:\n"
    "  emberleaf paper/corner                                   the window\n"
    "  emberleaf render paper/corner -o out/frame_####.png      pictures\n"
    "  emberleaf render paper/corner -o out/burn.mp4 --turntable 90\n"
    "  emberleaf simulate paper/corner --seconds 10 --stats out/stats.json\n";

int run(int argc, char** argv) {
    CLI::App program("Burning paper, simulated at the fibre's level", "emberleaf");
    program.set_version_flag("--version", std::string("emberleaf ") + kVersion);
    program.footer(kExamples);
    program.require_subcommand(0, 1);
    std::string preset = "paper/corner";
    program.add_option("PRESET", preset, "Open the window on this preset")->capture_default_str();
    Command command;
    declare_render(program, command);
    declare_simulate(program, command);
    declare_check(program, command);
    declare_presets(program, command);
    declare_params(program, command);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        const bool informed = e.get_exit_code() == 0;  // --help, --version
        program.exit(e);
        return informed ? kOk : kBadInput;
    }
    watch_for_interrupts();
    return command ? command() : run_window_command(preset);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const ember::InputError& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return ember::kBadInput;
    } catch (const std::invalid_argument& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return ember::kBadInput;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "emberleaf: %s\n", e.what());
        return ember::kRunFailed;
    }
}
