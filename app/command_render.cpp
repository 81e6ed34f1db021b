// emberleaf render: pictures and films without a window.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/frame_list.h"
#include "app/frame_source.h"
#include "app/interrupt.h"
#include "app/picture_sink.h"
#include "app/preset_io/atomic_file.h"
#include "app/preset_io/parameter_value.h"
#include "app/progress.h"
#include "app/run_options.h"
#include "app/stats_json.h"
#include "app/version.h"
#include "render/camera.h"
#include "render/offscreen_context.h"
#include "render/renderer.h"
#include "sim/param_table.h"
#include "sim/units.h"

namespace ember {
namespace {

struct RenderOptions {
    RunOptions run;
    std::vector<std::string> outputs;
    std::string frames, at, fps, size = "960x540", camera, view, stats, shaders;
    double turntable = 0;  // [deg] over the whole shot
    bool no_flames = false, transparent = false;
    int msaa = 4;
    GlBackend gl = GlBackend::Auto;
};

struct PlannedPicture {
    long number;
    double time;  // [s]
};

// The flags that are short for parameters.
std::vector<Assignment> assignments(const RenderOptions& options) {
    std::vector<Assignment> list;
    if (!options.fps.empty()) list.push_back({"--fps", "shot.fps=" + options.fps});
    if (!options.view.empty()) list.push_back({"--view", "view.mode=" + options.view});
    if (options.no_flames) list.push_back({"--no-flames", "view.flames=false"});
    if (options.transparent) list.push_back({"--transparent", "view.transparent=true"});
    if (options.camera.empty()) return list;
    if (find_camera_view(options.camera) != nullptr) return list;  // applied to the preset's camera
    const std::vector<std::string> parts = CLI::detail::split(options.camera, ',');
    if (parts.size() != 3) {
        throw InputError("--camera: error: expected " + camera_view_names() +
                         " or AZIMUTH,ELEVATION,DISTANCE in degrees, degrees and metres, got \"" +
                         options.camera + '"');
    }
    list.push_back({"--camera", "camera.azimuth=" + parts[0]});
    list.push_back({"--camera", "camera.elevation=" + parts[1]});
    list.push_back({"--camera", "camera.distance=" + parts[2]});
    return list;
}

std::vector<PlannedPicture> plan(const RenderOptions& options, const ShotParams& shot) {
    std::vector<PlannedPicture> pictures;
    if (!options.at.empty()) {
        for (const double time : parse_times(options.at)) {
            pictures.push_back({static_cast<long>(pictures.size()), time});
        }
        return pictures;
    }
    if (!options.frames.empty()) {
        for (const long frame : parse_frames(options.frames)) {
            pictures.push_back({frame, static_cast<double>(frame) / shot.fps});
        }
        return pictures;
    }
    const long count = std::max(1l, std::lround(shot.duration * shot.fps));
    for (long frame = 0; frame < count; ++frame) {
        pictures.push_back({frame, static_cast<double>(frame) / shot.fps});
    }
    return pictures;
}

ImageText metadata(const LoadedPreset& preset, const Renderer& renderer) {
    LoadedPreset copy = preset;
    const ParamBinding bindings[] = {bind(copy.params), bind(copy.render)};
    return {{"Software", "emberleaf"},
            {"Version", kVersion},
            {"Preset", preset_text(bindings, preset.info)},
            {"Seed", std::to_string(preset.params.numerics.seed)},
            {"Renderer", renderer.description()}};
}

// A shot while it is being drawn.
class Shot {
  public:
    Shot(const RenderOptions& options, const LoadedPreset& preset, World& world, bool several)
        : options_(options),
          preset_(preset),
          world_(world),
          size_(parse_size(options.size)),
          context_(OffscreenContext::create(options.gl)),
          renderer_(context_->loader(), options.msaa),
          source_(
              world, options.stats.empty() ? nullptr : stats_.observer(),
              [this](const StepReport& report) { note(report); },
              needs_springs(preset.render.view.mode)) {
        if (!options.shaders.empty()) renderer_.reload(options.shaders);
        const PictureFormat format{size_.width, size_.height, preset.render.shot.fps, several,
                                   metadata(preset, renderer_)};
        for (const std::string& output : options.outputs)
            sinks_.push_back(open_sink(output, format));
        if (!options.run.verbose) return;
        std::fprintf(stderr, "%s: %s\n", std::string(context_->name()).c_str(),
                     renderer_.description().c_str());
    }

    // Returns the exit code; what has been drawn until then is complete in any case.
    int draw(const std::vector<PlannedPicture>& pictures) {
        Progress progress("pictures", static_cast<long>(pictures.size()), options_.run.quiet);
        bool good = true;
        for (std::size_t i = 0; good && i < pictures.size() && interrupt_signal() == 0; ++i) {
            good = draw(pictures[i]);
            if (good) progress.update(static_cast<long>(i) + 1);
        }
        progress.finish();
        const bool whole = options_.frames.empty() && options_.at.empty();
        if (good && whole && interrupt_signal() == 0) {
            good = source_.advance_to(preset_.render.shot.duration);
        }
        finish();
        if (!good) throw RunError(divergence_text(last_report_));
        return interrupt_signal() == 0 ? kOk : 128 + interrupt_signal();
    }

  private:
    bool draw(const PlannedPicture& picture) {
        FrameView frame;
        if (!source_.show(picture.time, frame)) return false;
        RenderParams look = preset_.render;
        const double turn = unit::degree.to_si(options_.turntable);
        look.camera.azimuth += turn * picture.time / std::max(look.shot.duration, 1e-9);
        const Frame shown{&frame.view, frame.springs};
        const auto wanted = [&](bool layers) {
            return std::any_of(sinks_.begin(), sinks_.end(),
                               [&](const auto& sink) { return sink->wants_layers() == layers; });
        };
        Picture drawn{{}, {}, picture.number, picture.time};
        if (wanted(false))
            drawn.image = renderer_.draw_image(shown, look, size_.width, size_.height);
        if (wanted(true))
            drawn.layers = renderer_.draw_layers(shown, look, size_.width, size_.height);
        for (const auto& sink : sinks_)
            sink->put(drawn);
        return true;
    }

    void finish() {
        for (const auto& sink : sinks_) {
            sink->finish();
            if (!options_.run.quiet) std::fprintf(stderr, "%s\n", sink->where().c_str());
        }
        if (!options_.stats.empty()) write_file(options_.stats, stats_.json(world_, preset_));
        if (options_.run.quiet) return;
        std::fprintf(stderr, "%s\n", labelled_hash(world_).c_str());
    }

    void note(const StepReport& report) {
        last_report_ = report;
        if (!options_.stats.empty() && report.ok()) stats_.record(world_, report);
    }

    const RenderOptions& options_;
    const LoadedPreset& preset_;
    World& world_;
    PictureSize size_;
    std::unique_ptr<OffscreenContext> context_;  // outlives the renderer
    Renderer renderer_;
    StatsRecorder stats_;
    FrameSource source_;
    StepReport last_report_;
    std::vector<std::unique_ptr<PictureSink>> sinks_;
};

int run_render(const RenderOptions& options) {
    LoadedPreset preset = load_run(options.run, assignments(options));
    if (const CameraView* view = find_camera_view(options.camera))
        look_from(preset.render.camera, *view);
    const std::vector<PlannedPicture> pictures = plan(options, preset.render.shot);
    static_cast<void>(parse_size(options.size));
    for (const std::string& output : options.outputs)
        static_cast<void>(output_kind(output));
    World world = build_world(preset, options.run.threads);
    watch_for_interrupts();
    return Shot(options, preset, world, pictures.size() > 1).draw(pictures);
}

void add_picture_options(CLI::App& command, RenderOptions& options) {
    command.add_option("--size", options.size, "size of the pictures")
        ->type_name("WIDTHxHEIGHT")
        ->capture_default_str();
    command
        .add_option("--camera", options.camera,
                    "where to look from: " + camera_view_names() + ", or [deg, deg, m]")
        ->type_name("NAME|AZIMUTH,ELEVATION,DISTANCE");
    command.add_option("--turntable", options.turntable, "turn the camera by so much in the shot")
        ->type_name("DEG");
    command
        .add_option("--view", options.view,
                    "beauty, lattice, temperature, mass, state, stress or "
                    "stiffness")
        ->type_name("MODE");
    command.add_flag("--transparent", options.transparent,
                     "no backdrop and no ground, but alpha, for compositing");
    command.add_flag("--no-flames", options.no_flames, "draw the sheet only");
    command.add_option("--msaa", options.msaa, "samples per pixel")
        ->check(CLI::IsMember({1, 2, 4, 8}))
        ->capture_default_str();
    command
        .add_option("--shaders", options.shaders,
                    "take shaders and textures from here rather than from the program")
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR");
    command.add_option("--gl", options.gl, "how to draw without a window: auto, osmesa or egl")
        ->transform(CLI::CheckedTransformer(std::map<std::string, GlBackend>{
            {"auto", GlBackend::Auto}, {"osmesa", GlBackend::OsMesa}, {"egl", GlBackend::Egl}}))
        ->type_name("NAME");
}

}  // namespace

void add_render_command(CLI::App& app, Task& task) {
    CLI::App* command = app.add_subcommand("render", "draw pictures or a film, without a window");
    const auto options = std::make_shared<RenderOptions>();
    add_run_options(*command, options->run);
    command
        ->add_option("-o,--output", options->outputs,
                     "frame_####.png or .exr, or shot.mp4; may be given several times")
        ->required()
        ->allow_extra_args(false)
        ->take_all()
        ->type_name("FILE");
    auto* frames = command
                       ->add_option("--frames", options->frames,
                                    "0..240, 0..240+5 or 1,40,80..90; default: the whole shot")
                       ->type_name("LIST");
    command->add_option("--at", options->at, "times instead of frames: 0.5,1,2")
        ->excludes(frames)
        ->type_name("SECONDS");
    command->add_option("--fps", options->fps, "frame f is at f/fps seconds")->type_name("N");
    add_picture_options(*command, *options);
    command->add_option("--stats", options->stats, "write statistics of every tick as JSON")
        ->type_name("FILE");
    command->callback([options, &task] { task = [options] { return run_render(*options); }; });
}

}  // namespace ember
