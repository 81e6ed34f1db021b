// emberleaf sweep: the same scene with many different parameters.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <thread>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/sweep.h"

namespace ember {
namespace {

int run_sweep(SweepOptions options) {
    if (!options.output.ends_with(".png"))
        throw InputError("-o " + options.output + ": error: expected a name that ends in .png");
    options.share = parse_share(options.array);
    std::vector<SweepAxis> axes;
    for (const std::string& text : options.vary)
        axes.push_back(parse_axis(text));
    Sweep sweep(options, axes);
    watch_for_interrupts();
    sweep.run();
    if (interrupt_signal() != 0) {
        std::fprintf(stderr, "interrupted; the same command goes on where this one ended\n");
        return 128 + interrupt_signal();
    }
    const std::string where = sweep.assemble();
    if (!options.shot.run.quiet) std::fprintf(stderr, "%s\n", where.c_str());
    return kOk;
}

}  // namespace

void add_sweep_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<SweepOptions>();
    add_run_options(command, options->shot.run);
    options->shot.run.threads = 1;
    command.get_option("--threads")->description("in each case; default: 1");
    options->shot.size = "320x240";
    options->jobs = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    command
        .add_option("--vary", options->vary,
                    "60,80,120, 1..5:9 (nine values) or 1e-4..1e-2:log:5; repeatable: all "
                    "combinations")
        ->required()
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("KEY=VALUES");
    command
        .add_option("-o,--output", options->output,
                    "sheet.png, with a table in sheet.csv and the pictures in sheet_cases/")
        ->required()
        ->type_name("FILE");
    command.add_option("--at", options->shot.at, "when; default: the end of the shot")
        ->type_name("SECONDS");
    command.add_option("--jobs", options->jobs, "cases at a time; default: as many as processors")
        ->check(CLI::Range(1, 256))
        ->type_name("N");
    command
        .add_option("--array", options->array,
                    "only the Kth of N shares; whichever is last makes the sheet")
        ->type_name("K/N");
    command.add_option("--progress", options->shot.progress, "on stderr")
        ->check(CLI::IsMember({"auto", "json", "none"}))
        ->type_name("auto|json|none");
    add_view_options(command, options->shot);
    add_picture_options(command, options->shot);
    command.callback([options, &task] { task = [options] { return run_sweep(*options); }; });
}

}  // namespace ember
