// emberleaf [PRESET]: the window.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/run_options.h"
#include "app/version.h"
#ifdef EMBERLEAF_WITH_UI
#include "ui/bindings.h"
#include "ui/window_app.h"
#endif

namespace ember {
namespace {

constexpr const char* kDefaultPreset = "paper/corner";

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

struct WindowCommand {
    std::string preset;
    double ui_scale = 0;
    bool list_bindings = false;
    std::string shaders;
};

int open_window(const WindowCommand& command) {
    RunOptions run;
    run.preset = command.preset.empty() ? kDefaultPreset : command.preset;
    const LoadedPreset loaded = load_run(run);  // says what is wrong with it, and where
    if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) {
        throw RunError(
            "no display (DISPLAY and WAYLAND_DISPLAY are not set); to draw without a "
            "window: emberleaf render " +
            run.preset + " -o frame_####.png");
    }
#ifdef EMBERLEAF_WITH_UI
    const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    return run_window(
        {open_document(loaded.info.path), threads, command.ui_scale, kVersion, command.shaders});
#else
    throw RunError("built without a window; to draw: emberleaf render " + run.preset +
                   " -o frame_####.png");
#endif
}

int list_bindings() {
#ifdef EMBERLEAF_WITH_UI
    std::fputs(bindings_markdown().c_str(), stdout);
    return kOk;
#else
    throw RunError("built without a window");
#endif
}

}  // namespace

void add_window_command(CLI::App& app, Task& task) {
    const auto command = std::make_shared<WindowCommand>();
    app.add_option("PRESET", command->preset,
                   "opens the window with this preset file or built-in preset");
    app.add_option("--ui-scale", command->ui_scale,
                   "size of the window's text and panels; default: as the monitor says")
        ->check(CLI::Range(0.5, 8.0))
        ->type_name("FACTOR");
    app.add_option("--shaders", command->shaders,
                   "take shaders and textures from here, and again whenever they change")
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR");
    app.add_flag("--list-bindings", command->list_bindings,
                 "print the window's keys and what the mouse does");
    app.parse_complete_callback([&app, command, &task] {
        if (!app.get_subcommands().empty()) return;
        task = [command] {
            return command->list_bindings ? list_bindings() : open_window(*command);
        };
    });
}

}  // namespace ember
