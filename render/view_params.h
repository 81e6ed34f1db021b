// How a frame is looked at and drawn: camera, light, view mode. Rows as in the simulation's table.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/preset_io/picture_file.h"
#include "sim/param_info.h"

namespace ember {

/// Orbit camera around a target.
struct CameraParams {
    double target_x = 0.0, target_y = 0.31, target_z = 0.0;  // [m]
    double azimuth = 0.35;                                   // [rad] around y; 0 looks along -z
    double elevation = 0.10;                                 // [rad] above the horizon
    double distance = 0.78;                                  // [m]
    double field_of_view = 0.61;                             // [rad] vertical
};

enum class ViewMode : std::uint8_t { Beauty, Lattice, Temperature, Mass, State, Stress, Stiffness };

/// Whether a mode shows what only the springs know.
[[nodiscard]] constexpr bool needs_springs(ViewMode mode) {
    return mode == ViewMode::Lattice || mode == ViewMode::Stress || mode == ViewMode::Stiffness;
}

/// What is drawn.
struct ViewParams {
    ViewMode mode = ViewMode::Beauty;
    bool flames = true;
    bool ground = true;
    bool transparent = false;  // no backdrop, no ground; alpha says what is covered
    bool wireframe = false;
    bool legend = true;
    double stress_range = 200.0;  // [Pa] at both ends of the scale
};

/// What is printed on the paper: names of PNG files beside the preset; empty: nothing.
struct PrintParams {
    std::string front, back;
};

/// The files of PrintParams; null: nothing is printed. Each face shows its whole picture upright.
struct PrintedFaces {
    std::shared_ptr<const PictureFile> front, back;
};

/// The set: how it is lit without the fire.
enum class LightingPreset : std::uint8_t { Studio, Night };

/// How much work a picture is: Preview has fewer samples and softer fire and shadows.
enum class Quality : std::uint8_t { Full, Preview };

/// Light and film.
struct LookParams {
    LightingPreset lighting = LightingPreset::Studio;
    double exposure = 1.0;          // [1]
    double key_light = 1.0;         // [1]
    double light_azimuth = 0;       // [rad] from where the set has the lamp, to the right
    double flame_light = 1.0;       // [1] light that the flames throw on the sheet and ground
    double flame_size = 0.026;      // [m] width of a tongue of flame
    double flame_share = 0.055;     // [1] of the fire particles are drawn as tongues
    double flame_brightness = 1.0;  // [1]
    double smoke = 1.0;             // [1]
    double sparks = 1.0;            // [1]
    double haze = 0;                // [1] how far hot gas bends what is behind it
    double bloom = 0.4;             // [1] share of light beyond the film's range that is spread
    Quality quality = Quality::Full;
};

/// Length of the shot that `render` draws when no frames are given.
struct ShotParams {
    double duration = 10.0;  // [s]
    double fps = 30.0;       // [1/s]
};

struct RenderParams {
    CameraParams camera;
    ViewParams view;
    LookParams look;
    ShotParams shot;
    PrintParams print;
    PrintedFaces printed;  // what read_prints found
};

[[nodiscard]] std::span<const ParamInfo> render_param_rows();
[[nodiscard]] ParamBinding bind(RenderParams& params);

/// Reads the files of params.print into params.printed; returns what is wrong (see read_picture).
[[nodiscard]] std::vector<Diagnostic> read_prints(RenderParams& params, const PresetInfo& info);

}  // namespace ember
