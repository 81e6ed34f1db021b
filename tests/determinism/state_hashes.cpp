// The state hash of every tick of a preset, as `emberleaf simulate --hashes` writes it, by a
// program that is quick to compile: nothing but the simulation and what reads presets.
//
//     state_hashes PRESET TICKS THREADS FILE [KEY=VALUE...]
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "app/preset_io/atomic_file.h"
#include "app/preset_io/mask_file.h"
#include "app/preset_io/preset_io.h"
#include "app/preset_io/steering.h"
#include "render/view_params.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember {
namespace {

void expect_none(const std::vector<Diagnostic>& problems) {
    if (!problems.empty()) throw std::runtime_error(problems.front().text());
}

World load(const std::string& name, int threads, const std::vector<std::string>& assignments) {
    Params params;
    RenderParams render;
    const std::vector bindings{bind(params), bind(render)};
    PresetResult preset = load_preset(find_preset(name, ""), bindings);
    if (!preset.ok()) expect_none(preset.diagnostics);
    for (const std::string& assignment : assignments)
        expect_none(apply_override(assignment, bindings));
    expect_none(read_masks(params, preset.info));
    World world = make_world(params, threads);
    std::vector<Diagnostic> problems;
    world.set_script(params, script_of(params, preset.info, problems));
    expect_none(problems);
    return world;
}

std::string hashes(World& world, long ticks) {
    std::string text = "tick state_hash\n";
    for (long tick = 0;; ++tick) {
        char line[64];
        std::snprintf(line, sizeof line, "%ld %016" PRIx64 "\n", tick, world.hash());
        text += line;
        if (tick == ticks) return text;
        const StepReport report = world.step();
        if (!report.ok()) throw std::runtime_error(cause_text(report));
    }
}

}  // namespace
}  // namespace ember

int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: %s PRESET TICKS THREADS FILE [KEY=VALUE...]\n", argv[0]);
        return 2;
    }
    try {
        ember::World world = ember::load(argv[1], std::atoi(argv[3]),
                                         std::vector<std::string>(argv + 5, argv + argc));
        ember::write_file(argv[4], ember::hashes(world, std::atol(argv[2])));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s: %s\n", argv[1], e.what());
        return 1;
    }
    return 0;
}
