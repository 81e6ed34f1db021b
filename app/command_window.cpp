#include "app/command_window.h"

#include "app/exit_code.h"
#include "app/run_options.h"
#ifdef EMBERLEAF_WITH_UI
#include "ui/window_app.h"
#endif

namespace ember {

int run_window_command(const std::string& preset) {
    RunOptions options;
    options.preset = preset;
    LoadedPreset loaded = load(options);
#ifdef EMBERLEAF_WITH_UI
    return run_window({loaded.info, loaded.params, loaded.render, options.thread_count()});
#else
    throw RunError("this emberleaf was built without the window (EMBERLEAF_BUILD_UI is off)");
#endif
}

}  // namespace ember
