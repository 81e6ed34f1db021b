// emberleaf bench: how accurate, how fast and how robust the simulation is.
#include <CLI/CLI.hpp>
#include <thread>

#include "app/bench/benches.h"
#include "app/bench/render_bench.h"
#include "app/commands.h"

namespace ember {
namespace {

void add_common(CLI::App& command, BenchOptions& options) {
    options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    command.add_option("--out", options.out, "folder of the tables and charts")
        ->type_name("DIR")
        ->capture_default_str();
    command.add_flag("--quick", options.quick, "fewer and smaller runs");
    command.add_option("--threads", options.threads, "threads to use")
        ->check(CLI::Range(1, 256))
        ->type_name("N")
        ->capture_default_str();
}

void add_work_precision(CLI::App& bench, Task& task) {
    CLI::App* command =
        bench.add_subcommand("work-precision", "error against time, for every method");
    const auto options = std::make_shared<WorkPrecisionOptions>();
    add_common(*command, options->common);
    command->add_option("--problem", options->problem, "only this one; default: all")
        ->check(CLI::IsMember({"swing", "cosine", "burn"}))
        ->type_name("NAME");
    command->add_option("--doc", options->page, "write docs/ACCURACY.md, its charts beside it")
        ->type_name("FILE");
    command->callback(
        [options, &task] { task = [options] { return bench_work_precision(*options); }; });
}

void add_scaling(CLI::App& bench, Task& task) {
    CLI::App* command = bench.add_subcommand("scaling", "time per tick for growing lattices");
    const auto options = std::make_shared<BenchOptions>();
    add_common(*command, *options);
    command->callback([options, &task] { task = [options] { return bench_scaling(*options); }; });
}

void add_stages(CLI::App& bench, Task& task) {
    CLI::App* command = bench.add_subcommand("stages", "time per stage over a burn");
    const auto options = std::make_shared<BenchOptions>();
    const auto presets = std::make_shared<std::vector<std::string>>();
    add_common(*command, *options);
    command->add_option("PRESET", *presets, "presets; default: all built-in ones");
    command->callback([options, presets, &task] {
        task = [options, presets] { return bench_stages(*options, *presets); };
    });
}

void add_render(CLI::App& bench, Task& task) {
    CLI::App* command = bench.add_subcommand("render", "time per pass of a picture in mid-burn");
    const auto options = std::make_shared<RenderBenchOptions>();
    add_common(*command, options->common);
    command->add_option("PRESET", options->preset, "preset")->capture_default_str();
    command->add_option("--gl", options->gl, "how to draw without a window: auto, osmesa or egl")
        ->transform(CLI::CheckedTransformer(std::map<std::string, GlBackend>{
            {"auto", GlBackend::Auto}, {"osmesa", GlBackend::OsMesa}, {"egl", GlBackend::Egl}}))
        ->type_name("auto|osmesa|egl");
    command->callback([options, &task] { task = [options] { return bench_render(*options); }; });
}

void add_stress(CLI::App& bench, Task& task) {
    CLI::App* command = bench.add_subcommand("stress", "parameters far outside what is usual");
    const auto options = std::make_shared<StressOptions>();
    add_common(*command, options->common);
    command->add_option("--cases", options->cases, "number of random cases")
        ->check(CLI::Range(0, 1000000))
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--seed", options->seed, "seed of the cases")
        ->type_name("N")
        ->capture_default_str();
    command->add_option("--case", options->only, "run only the case of this name")
        ->type_name("NAME");
    command->add_flag("!--no-traps", options->traps, "do not watch for floating-point exceptions");
    command->callback([options, &task] { task = [options] { return bench_stress(*options); }; });
}

void add_validate(CLI::App& bench, Task& task) {
    CLI::App* command =
        bench.add_subcommand("validate", "flame spread over strips against that of real paper");
    const auto options = std::make_shared<ValidateOptions>();
    add_common(*command, options->common);
    command->add_option("PRESET", options->presets, "presets; default: all of real/");
    command->add_option("--set", options->sets, "change a parameter of all of them, repeatable")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false)
        ->take_all();
    command->add_option("--doc", options->page, "write docs/VALIDATION.md")->type_name("FILE");
    command->callback([options, &task] { task = [options] { return bench_validate(*options); }; });
}

}  // namespace

void add_bench_command(CLI::App& command, Task& task) {
    command.require_subcommand(1);
    add_work_precision(command, task);
    add_scaling(command, task);
    add_stages(command, task);
    add_render(command, task);
    add_stress(command, task);
    add_validate(command, task);
}

}  // namespace ember
