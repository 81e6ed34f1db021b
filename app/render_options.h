// What the commands that draw are asked for.
#pragma once

#include <string>
#include <vector>

#include "app/frame_list.h"
#include "app/keyframes.h"
#include "app/progress.h"
#include "app/run_options.h"
#include "render/offscreen_context.h"

namespace ember {

struct RenderOptions {
    RunOptions run;
    std::vector<std::string> outputs;
    std::string frames, at, fps, size = "960x540", camera, view, lighting, stats, shaders;
    std::vector<std::string> animate;
    std::string progress = "auto", grid, resume;
    double start = 0;         // [s]
    double turntable = 0;     // [deg] over the whole shot
    double focal_length = 0;  // [mm]; 0: the preset's angle of view
    double shutter = 180;     // [deg] of the time between two frames that a picture is exposed
    int blur_samples = 1;
    int msaa = 4;
    bool no_flames = false, transparent = false, skip_existing = false, serial = false;
    GlBackend gl = GlBackend::Auto;
};

/// Which frames, and what changes during them.
void add_time_options(CLI::App& command, RenderOptions& options);
/// Single times and motion blur, for what draws.
void add_exposure_options(CLI::App& command, RenderOptions& options);
/// Where the camera stands, and what turns it.
void add_view_options(CLI::App& command, RenderOptions& options);
void add_turntable_option(CLI::App& command, RenderOptions& options);
/// Everything else about pictures.
void add_picture_options(CLI::App& command, RenderOptions& options);

/// A preset as the options look at it.
struct RenderJob {
    LoadedPreset preset;
    Keyframes keys;
    PictureSize size;
};
/// Reads the preset and applies the flags that are short for parameters. Throws InputError.
[[nodiscard]] RenderJob load_render_job(const RenderOptions& options);

/// The world at t = 0, or as --resume has it. Throws InputError when that is after `first` [s].
[[nodiscard]] World start_world(const RenderOptions& options, const RenderJob& job, double first);

/// One picture of a shot.
struct PlannedPicture {
    long number;      ///< as in the file's name
    double time;      ///< [s] simulated when its exposure begins
    double clock;     ///< [s] since the shot began: what the camera and keys of the look go by
    double exposure;  ///< [s] of simulated time; 0: an instant
    friend bool operator==(const PlannedPicture&, const PlannedPicture&) = default;
};

/// All pictures, by time: --frames or the whole shot, or --at. With --turntable and one --at, the
/// burn stands still at that time while the camera goes around. Throws InputError.
[[nodiscard]] std::vector<PlannedPicture> plan_pictures(const RenderOptions& options,
                                                        const ShotParams& shot);

/// The options that change what a picture of a number shows, beyond the preset: one line.
[[nodiscard]] std::string settings_text(const RenderOptions& options, const RenderJob& job);

}  // namespace ember
