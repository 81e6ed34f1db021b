// emberleaf render and emberleaf sheet: pictures and films without a window.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "app/preset_io/atomic_file.h"
#include "app/render_options.h"
#include "app/shot.h"
#include "app/sprite_sheet.h"

namespace ember {
namespace {

int run_render(const RenderOptions& options) {
    const RenderJob job = load_render_job(options);
    const std::vector<PlannedPicture> pictures = plan_pictures(options, job.preset.render.shot);
    for (const std::string& output : options.outputs)
        static_cast<void>(output_kind(output));
    if (std::count(options.outputs.begin(), options.outputs.end(), "-") > 1)
        throw InputError("-o -: error: standard output takes one stream of pictures");
    World world = start_world(options, job, pictures.front().time);
    watch_for_interrupts();
    return Shot(options, job, world, pictures, open_sink).draw();
}

int run_sheet(const RenderOptions& options) {
    const RenderJob job = load_render_job(options);
    const std::vector<PlannedPicture> pictures = plan_pictures(options, job.preset.render.shot);
    const std::string& output = options.outputs.front();
    if (!output.ends_with(".png"))
        throw InputError("-o " + output + ": error: expected a name that ends in .png");
    World world = start_world(options, job, pictures.front().time);
    watch_for_interrupts();
    const OpenSink open = [](const std::string& path, const PictureFormat& format) {
        return std::make_unique<SpriteSheet>(path, format);
    };
    return Shot(options, job, world, pictures, open).draw();
}

// What both have in common but for the output.
void add_common_options(CLI::App& command, RenderOptions& options) {
    add_time_options(command, options);
    add_exposure_options(command, options);
    add_view_options(command, options);
    add_turntable_option(command, options);
    add_picture_options(command, options);
    const char* group = "Run";
    command.add_flag("--serial", options.serial, "simulate, draw and encode one after the other")
        ->group(group);
    command.add_option("--progress", options.progress, "on stderr")
        ->check(CLI::IsMember({"auto", "json", "none"}))
        ->type_name("auto|json|none")
        ->group(group);
    command.add_option("--stats", options.stats, "write statistics of every tick as JSON")
        ->type_name("FILE")
        ->group(group);
}

CLI::Option* add_output(CLI::App& command, RenderOptions& options, const char* help) {
    return command.add_option("-o,--output", options.outputs, help)
        ->required()
        ->allow_extra_args(false)
        ->type_name("FILE");
}

}  // namespace

void add_render_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<RenderOptions>();
    add_run_options(command, options->run);
    add_output(command, *options,
               "f_####.png, .exr; shot.mp4, .mov, .webm, .gif, .webp, .apng, .mkv; - is raw RGBA")
        ->take_all();
    add_common_options(command, *options);
    command
        .add_flag("--skip-existing", options->skip_existing,
                  "keep the pictures that are there, if made with the same settings")
        ->group("Run");
    command.callback([options, &task] { task = [options] { return run_render(*options); }; });
}

void add_sheet_command(CLI::App& command, Task& task) {
    const auto options = std::make_shared<RenderOptions>();
    options->size = "256x256";
    add_run_options(command, options->run);
    add_output(command, *options, "sheet.png; sheet.json beside it says where each frame is")
        ->expected(1);
    command.add_option("--grid", options->grid, "default: as square as can be")
        ->type_name("COLUMNSxROWS");
    add_common_options(command, *options);
    command.callback([options, &task] { task = [options] { return run_sheet(*options); }; });
}

}  // namespace ember
