#include "app/render_options.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "app/checkpoint.h"
#include "app/exit_code.h"
#include "app/preset_io/parameter_value.h"
#include "render/camera.h"
#include "sim/param_table.h"
#include "sim/units.h"

namespace ember {
namespace {

constexpr double kFilmWidth = 36;  // [mm] that focal lengths are told for

// Vertical angle of view [deg] of a lens, for pictures that are as wide as the film.
double angle_of_view(double focal_length, const PictureSize& size) {
    const double high = kFilmWidth * size.height / size.width;
    return unit::degree.from_si(2 * std::atan(high / (2 * focal_length)));
}

// The flags that are short for parameters.
std::vector<Assignment> assignments(const RenderOptions& options, const PictureSize& size) {
    std::vector<Assignment> list;
    if (!options.fps.empty()) list.push_back({"--fps", "shot.fps=" + rate_text(options.fps)});
    if (!options.view.empty()) list.push_back({"--view", "view.mode=" + options.view});
    if (!options.lighting.empty())
        list.push_back({"--lighting", "look.lighting=" + options.lighting});
    if (options.no_flames) list.push_back({"--no-flames", "view.flames=false"});
    if (options.transparent) list.push_back({"--transparent", "view.transparent=true"});
    if (options.focal_length > 0) {
        list.push_back(
            {"--focal-length",
             "camera.field_of_view=" + number_text(angle_of_view(options.focal_length, size))});
    }
    if (options.camera.empty()) return list;
    if (find_camera_view(options.camera) != nullptr) return list;  // applied to the preset's camera
    const std::vector<std::string> parts = CLI::detail::split(options.camera, ',');
    if (parts.size() != 3) {
        throw InputError("--camera: error: expected " + camera_view_names() +
                         ", a preset file, or AZIMUTH,ELEVATION,DISTANCE in degrees, degrees and "
                         "metres, got \"" +
                         options.camera + '"');
    }
    list.push_back({"--camera", "camera.azimuth=" + parts[0]});
    list.push_back({"--camera", "camera.elevation=" + parts[1]});
    list.push_back({"--camera", "camera.distance=" + parts[2]});
    return list;
}

bool names_a_file(const std::string& camera) {
    return camera.ends_with(".toml") || camera.ends_with(".png");
}

// The camera of another preset or picture.
CameraParams camera_in(const std::string& file) {
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    const PresetResult result = load_preset(resolve_preset(file), bindings);
    if (!result.ok()) throw InputError(diagnostics_text(result.diagnostics));
    return render.camera;
}

}  // namespace

RenderJob load_render_job(const RenderOptions& options) {
    RenderJob job;
    job.size = parse_size(options.size);
    RenderOptions flags = options;
    const bool file = names_a_file(options.camera);
    if (file) flags.camera.clear();
    job.preset = load_run(options.run, assignments(flags, job.size));
    CameraParams& camera = job.preset.render.camera;
    if (file) {
        const double angle = camera.field_of_view;
        camera = camera_in(options.camera);
        if (options.focal_length > 0) camera.field_of_view = angle;
    }
    if (const CameraView* view = find_camera_view(options.camera)) look_from(camera, *view);
    for (const std::string& text : options.animate)
        job.keys.add(text);
    return job;
}

World start_world(const RenderOptions& options, const RenderJob& job, double first) {
    World world = build_world(job.preset, options.run.threads);
    if (options.resume.empty()) return world;
    load_checkpoint(options.resume, world, job.preset);
    if (world.state().time > first + 1e-9) {
        throw InputError("--resume: error: " + options.resume + " is at " +
                         number_text(world.state().time) + " s, after the first picture");
    }
    return world;
}

std::vector<PlannedPicture> plan_pictures(const RenderOptions& options, const ShotParams& shot) {
    std::vector<PlannedPicture> pictures;
    const std::vector<double> times =
        options.at.empty() ? std::vector<double>{} : parse_times(options.at);
    const bool frozen = options.turntable != 0 && times.size() == 1;
    if (!options.frames.empty() && !times.empty() && !frozen) {
        throw InputError(
            "--at: error: excludes --frames, unless a --turntable goes around one time");
    }
    const double exposure =
        options.blur_samples > 1 && !frozen ? options.shutter / 360 / shot.fps : 0;
    if (!times.empty() && !frozen) {
        for (const double time : times) {
            pictures.push_back({static_cast<long>(pictures.size()), time,
                                std::max(0.0, time - options.start), exposure});
        }
        return pictures;
    }
    std::vector<long> frames;
    const long count = std::max(1l, std::lround(shot.duration * shot.fps));
    for (long frame = 0; options.frames.empty() && frame < count; ++frame)
        frames.push_back(frame);
    if (!options.frames.empty()) frames = parse_frames(options.frames);
    for (const long frame : frames) {
        const double clock = static_cast<double>(frame) / shot.fps;
        pictures.push_back({frame, frozen ? times[0] : options.start + clock, clock, exposure});
    }
    return pictures;
}

std::string settings_text(const RenderOptions& options, const RenderJob& job) {
    std::string text = std::to_string(job.size.width) + 'x' + std::to_string(job.size.height) +
                       " msaa " + std::to_string(options.msaa);
    const auto add = [&text](const std::string& more) { text += ", " + more; };
    if (options.turntable != 0) {
        add("turntable " + number_text(options.turntable) + " deg in " +
            number_text(job.preset.render.shot.duration) + " s");
    }
    if (options.turntable != 0 && !options.at.empty()) add("at " + options.at + " s");
    if (options.start != 0) add("start " + number_text(options.start) + " s");
    if (options.blur_samples > 1) {
        add("motion blur " + std::to_string(options.blur_samples) + " in " +
            number_text(options.shutter) + " deg");
    }
    for (const std::string& track : job.keys.texts())
        add("animate " + track);
    return text;
}

void add_time_options(CLI::App& command, RenderOptions& options) {
    const char* group = "Time";
    command
        .add_option("--frames", options.frames,
                    "0..240, 0..240+5, or 1,40..80,+5; default: the whole shot")
        ->type_name("LIST")
        ->group(group);
    command.add_option("--fps", options.fps, "frames per second: 24, 23.976, 30000/1001")
        ->type_name("N")
        ->group(group);
    command.add_option("--start", options.start, "what burns before is not in the shot")
        ->check(CLI::Range(0.0, 86400.0))
        ->type_name("SECONDS")
        ->group(group);
    command.add_option("--resume", options.resume, "begin with what simulate --save has saved")
        ->type_name("FILE")
        ->group(group);
    command
        .add_option("--animate", options.animate, "a parameter over time: camera.azimuth=0:0,4:90")
        ->type_name("KEY=KEYS")
        ->allow_extra_args(false)
        ->take_all()
        ->group(group);
}

void add_exposure_options(CLI::App& command, RenderOptions& options) {
    const char* group = "Time";
    command.add_option("--at", options.at, "times instead of frames: 0.5,1,2; see --turntable")
        ->type_name("SECONDS")
        ->group(group);
    command.add_option("--motion-blur", options.blur_samples, "moments to average in each picture")
        ->check(CLI::Range(1, 256))
        ->type_name("N")
        ->group(group);
    command.add_option("--shutter", options.shutter, "share of 360 of a frame's time, for blur")
        ->check(CLI::Range(1.0, 360.0))
        ->type_name("DEG")
        ->capture_default_str()
        ->group(group);
}

void add_view_options(CLI::App& command, RenderOptions& options) {
    const char* group = "Camera";
    command.add_option("--size", options.size, "of the pictures")
        ->type_name("WIDTHxHEIGHT")
        ->capture_default_str()
        ->group(group);
    command
        .add_option("--camera", options.camera,
                    camera_view_names() + "; azimuth, elevation [deg], distance [m]; that of FILE")
        ->type_name("NAME|A,E,D|FILE")
        ->group(group);
    command.add_option("--focal-length", options.focal_length, "of the lens, for film 36 mm wide")
        ->check(CLI::Range(5.0, 1000.0))
        ->type_name("MM")
        ->group(group);
}

void add_turntable_option(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--turntable", options.turntable,
                    "turn the camera by so much in the shot; with one --at the burn stands still")
        ->check(CLI::Range(-36000.0, 36000.0))
        ->type_name("DEG")
        ->group("Camera");
}

void add_picture_options(CLI::App& command, RenderOptions& options) {
    const char* group = "Look";
    command.add_option("--view", options.view, "what is shown")
        ->type_name("beauty|lattice|temperature|mass|state|stress|stiffness")
        ->group(group);
    command.add_option("--lighting", options.lighting, "the set")
        ->type_name("studio|night")
        ->group(group);
    command.add_flag("--transparent", options.transparent, "alpha instead of backdrop and ground")
        ->group(group);
    command.add_flag("--no-flames", options.no_flames, "draw the sheet only")->group(group);
    command.add_option("--msaa", options.msaa, "samples per pixel")
        ->check(CLI::IsMember({1, 2, 4, 8}))
        ->type_name("1|2|4|8")
        ->capture_default_str()
        ->group(group);
    command.add_option("--shaders", options.shaders, "take shaders and textures from here")
        ->check(CLI::ExistingDirectory)
        ->type_name("DIR")
        ->group(group);
    command.add_option("--gl", options.gl, "how to draw without a window")
        ->transform(CLI::CheckedTransformer(std::map<std::string, GlBackend>{
            {"auto", GlBackend::Auto}, {"osmesa", GlBackend::OsMesa}, {"egl", GlBackend::Egl}}))
        ->type_name("auto|osmesa|egl")
        ->group(group);
}

}  // namespace ember
