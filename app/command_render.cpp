#include "app/command_render.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>

#include "app/atomic_file.h"
#include "app/diverged.h"
#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_list.h"
#include "app/frame_source.h"
#include "app/interrupt.h"
#include "app/progress.h"
#include "app/run_options.h"
#include "app/stats_json.h"
#include "app/version.h"
#include "app/video_encoder.h"
#include "render/offscreen_context.h"

namespace ember {
namespace {

constexpr double kDegree = 0.017453292519943295;

struct RenderOptions {
    RunOptions run;
    std::string output, frames, at, size = "960x540", camera, view, stats, gl = "auto";
    std::optional<double> fps, turntable;
    bool no_flames = false;
    int msaa = 4;
};

// One picture of the shot.
struct Shot {
    long number;
    double time;  // [s]
};

std::vector<Shot> list_shots(const RenderOptions& options, const ShotParams& shot) {
    std::vector<Shot> shots;
    if (!options.at.empty()) {
        for (const double time : parse_times(options.at)) {
            shots.push_back({static_cast<long>(shots.size()), time});
        }
        return shots;
    }
    const auto last = static_cast<long>(std::floor(shot.duration * shot.fps + 1e-9));
    const std::vector<long> frames =
        parse_frames(options.frames.empty() ? "0.." + std::to_string(last) : options.frames);
    for (const long frame : frames) {
        shots.push_back({frame, static_cast<double>(frame) / shot.fps});
    }
    return shots;
}

// Puts what the command line says about the view into the parameters.
void apply_view(const RenderOptions& options, RenderParams& render) {
    const ParamBinding bindings[] = {bind(render)};
    std::string problems;
    const auto set = [&](const std::string& assignment) {
        for (const Diagnostic& d : apply_override(assignment, bindings)) {
            problems += (problems.empty() ? "" : "\n") + d.text();
        }
    };
    if (!options.view.empty()) set("view.mode=" + options.view);
    if (options.fps) set("shot.fps=" + std::to_string(*options.fps));
    if (options.no_flames) render.view.flames = false;
    if (!options.camera.empty()) {
        double azimuth = 0, elevation = 0, distance = 0;
        char rest = 0;
        if (std::sscanf(options.camera.c_str(), "%lf,%lf,%lf%c", &azimuth, &elevation, &distance,
                        &rest) != 3) {
            throw InputError(
                "--camera: expected AZIMUTH,ELEVATION,DISTANCE in degrees and metres, "
                "got \"" +
                options.camera + '"');
        }
        set("camera.azimuth=" + std::to_string(azimuth));
        set("camera.elevation=" + std::to_string(elevation));
        set("camera.distance=" + std::to_string(distance));
    }
    if (!problems.empty()) throw InputError(problems);
}

// Where pictures go: numbered PNGs or a film.
class Output {
  public:
    Output(const std::string& path, PictureSize size, double fps, bool single) : path_(path) {
        const std::string extension = std::filesystem::path(path).extension().string();
        if (extension == ".mp4") {
            film_ = std::make_unique<VideoEncoder>(path, size.width, size.height, fps);
        } else if (extension == ".png") {
            const bool place =
                path.find('#') != std::string::npos || path.find('%') != std::string::npos;
            if (place || !single) pattern_ = std::make_unique<FilePattern>(path);
            make_folder_of(path);
        }
    }
    static void check(const std::string& path) {
        const std::string extension = std::filesystem::path(path).extension().string();
        if (extension != ".png" && extension != ".mp4") {
            throw InputError("-o: expected a name ending in .png or .mp4, got \"" + path + '"');
        }
        if (extension == ".png") (void)FilePattern(path);
    }
    void add(const Shot& shot, const Image& image, const ImageText& text) {
        if (film_) {
            film_->add(image);
        } else {
            write_png(pattern_ ? pattern_->name(shot.number) : path_, image, text);
        }
    }
    void finish() {
        if (film_) film_->finish();
    }

  private:
    std::string path_;
    std::unique_ptr<VideoEncoder> film_;
    std::unique_ptr<FilePattern> pattern_;
};

ImageText picture_text(LoadedPreset& preset, const std::string& renderer, const Shot& shot) {
    char time[32];
    std::snprintf(time, sizeof time, "%.6f", shot.time);
    return {{"Software", "emberleaf"},
            {"Version", kVersion},
            {"Preset", preset.text()},
            {"Seed", std::to_string(preset.params.numerics.seed)},
            {"Frame", std::to_string(shot.number)},
            {"Time", time},
            {"Renderer", renderer}};
}

GlBackend backend(const std::string& name) {
    return name == "osmesa" ? GlBackend::OsMesa : name == "egl" ? GlBackend::Egl : GlBackend::Auto;
}

int render(const RenderOptions& options) {
    LoadedPreset preset = load(options.run);
    apply_view(options, preset.render);
    const PictureSize size = parse_size(options.size);
    const std::vector<Shot> shots = list_shots(options, preset.render.shot);
    Output::check(options.output);
    World world = make_world(preset.params, options.run.thread_count());

    const auto context = OffscreenContext::create(backend(options.gl));
    Renderer renderer(context->loader(), options.msaa);
    if (options.run.verbose) {
        std::fprintf(stderr, "%s: %s\n", std::string(context->name()).c_str(),
                     renderer.description().c_str());
    }
    StageClock clock;
    RunStats stats(options.run.preset, world);
    StepReport last;
    FrameSource source(world, &clock, [&](const StepReport& report) {
        last = report;
        if (report.ok()) stats.record(world, report, clock);
    });
    Output output(options.output, size, preset.render.shot.fps, shots.size() == 1);
    Progress progress("frames", static_cast<long>(shots.size()), options.run.quiet);
    const double azimuth = preset.render.camera.azimuth;
    FrameView frame;
    long done = 0;
    for (const Shot& shot : shots) {
        if (!source.show(shot.time, frame)) {
            progress.finish();
            throw RunError(diverged_text(last));
        }
        if (options.turntable) {
            preset.render.camera.azimuth = azimuth + *options.turntable * kDegree *
                                                         static_cast<double>(done) /
                                                         static_cast<double>(shots.size());
        }
        const Image image = renderer.draw_image({&frame.view, frame.springs}, preset.render,
                                                size.width, size.height);
        output.add(shot, image, picture_text(preset, renderer.description(), shot));
        progress.update(++done);
        if (interrupt_signal() != 0) break;
    }
    progress.finish();
    output.finish();
    if (!options.stats.empty()) write_file(options.stats, stats.text(world));
    if (!options.run.quiet) {
        std::fprintf(stderr, "%ld frames at %s, state hash: %s\n", done, options.output.c_str(),
                     hash_text(world.hash()).c_str());
    }
    return interrupt_signal() != 0 ? 128 + interrupt_signal() : kOk;
}

}  // namespace

void declare_render(CLI::App& program, Command& command) {
    CLI::App* sub = program.add_subcommand("render", "Render pictures or a film without a window");
    const auto options = std::make_shared<RenderOptions>();
    RenderOptions& o = *options;
    o.run.declare(*sub);
    sub->add_option("-o,--output", o.output, "frame_####.png, or shot.mp4 (needs ffmpeg)")
        ->required();
    CLI::Option* frames =
        sub->add_option("--frames", o.frames, "0..240, 0..240+5 or 1,40,80; default: the shot");
    sub->add_option("--at", o.at, "Times instead of frames [s]: 0.5,1,2")->excludes(frames);
    sub->add_option("--fps", o.fps, "Frames per simulated second")->check(CLI::Range(0.1, 1000.0));
    sub->add_option("--size", o.size, "Picture size")->capture_default_str();
    sub->add_option("--camera", o.camera, "AZIMUTH,ELEVATION,DISTANCE in degrees and metres");
    sub->add_option("--turntable", o.turntable, "Turn the camera by this many degrees in all");
    sub->add_option("--view", o.view, "beauty, lattice, temperature, mass or state");
    sub->add_flag("--no-flames", o.no_flames, "Leave out the fire");
    sub->add_option("--msaa", o.msaa, "Samples per pixel")
        ->check(CLI::IsMember(std::vector<int>{1, 2, 4}))
        ->capture_default_str();
    sub->add_option("--gl", o.gl, "Where OpenGL comes from")
        ->check(CLI::IsMember({"auto", "osmesa", "egl"}))
        ->capture_default_str();
    sub->add_option("--stats", o.stats, "Write statistics of every tick as JSON");
    sub->callback([&command, options] { command = [options] { return render(*options); }; });
}

}  // namespace ember
