// The arguments that several subcommands share: a preset and what is changed about it.
#pragma once

#include <string>
#include <vector>

#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/world.h"

namespace CLI {
class App;
}

namespace ember {

/// One "key=value" and the flag that it came from, which is named when it is refused.
struct Assignment {
    std::string origin, text;
};

struct RunOptions {
    std::string preset;
    std::vector<std::string> sets;
    std::string seed;  ///< empty: the preset's
    int threads = 1;
    bool quiet = false, verbose = false;
};

/// Adds PRESET, --set, --seed, --threads, -q and -v to `command`.
void add_run_options(CLI::App& command, RunOptions& options);

/// A preset with everything applied to it.
struct LoadedPreset {
    Params params;
    RenderParams render;
    PresetInfo info;
};

/// Reads the preset, applies `more`, then --set and --seed, and looks whether the scene can be
/// built. Throws InputError with all problems at
/// once, or when there is no such preset. Warnings go to stderr when options.verbose.
[[nodiscard]] LoadedPreset load_run(const RunOptions& options,
                                    const std::vector<Assignment>& more = {});

/// Reads the pictures of the sheets' outlines into `params`; says why the scene cannot be built.
[[nodiscard]] std::vector<Diagnostic> scene_problems(Params& params, const PresetInfo& info);

/// The file of a preset given by path or built-in name. Throws InputError with a suggestion.
[[nodiscard]] std::filesystem::path resolve_preset(const std::string& name);

/// Names of the built-in presets, such as "paper/corner", sorted.
[[nodiscard]] std::vector<std::string> built_in_presets();

/// Problems as people read them: one line each with the source line and a caret below.
[[nodiscard]] std::string diagnostics_text(const std::vector<Diagnostic>& diagnostics);

/// Builds the world; what cannot be built is an InputError that names `preset` and the key.
[[nodiscard]] World build_world(const LoadedPreset& preset, int threads);

/// "simulation stopped at t = ... s: stage ..., sheet ..., node ...: reason".
[[nodiscard]] std::string divergence_text(const StepReport& report);

}  // namespace ember
