// emberleaf [PRESET]: the window.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/run_options.h"
#ifdef EMBERLEAF_WITH_UI
#include "ui/window_app.h"
#endif

namespace ember {
namespace {

constexpr const char* kDefaultPreset = "paper/corner";

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

int open_window(const std::string& preset) {
    RunOptions run;
    run.preset = preset.empty() ? kDefaultPreset : preset;
    run.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const LoadedPreset loaded = load_run(run);
    if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY")) {
        throw RunError(
            "no display (DISPLAY and WAYLAND_DISPLAY are not set); to draw without a "
            "window: emberleaf render " +
            run.preset + " -o frame_####.png");
    }
#ifdef EMBERLEAF_WITH_UI
    return run_window({loaded.info, loaded.params, loaded.render, run.threads});
#else
    throw RunError("built without a window; to draw: emberleaf render " + run.preset +
                   " -o frame_####.png");
#endif
}

}  // namespace

void add_window_command(CLI::App& app, Task& task) {
    const auto preset = std::make_shared<std::string>();
    app.add_option("PRESET", *preset, "opens the window with this preset file or built-in preset");
    app.parse_complete_callback([&app, preset, &task] {
        if (!app.get_subcommands().empty()) return;
        task = [preset] { return open_window(*preset); };
    });
}

}  // namespace ember
