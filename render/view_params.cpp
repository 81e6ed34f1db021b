#include "render/view_params.h"

#include <string_view>
#include <utility>

#include "sim/param_rows.h"

namespace ember {
namespace {

using enum ParamScale;
using enum ParamApplies;
using detail::Access;
using R = RenderParams;

constexpr std::string_view kLightings[] = {"studio", "night"};
constexpr std::string_view kQualities[] = {"full", "preview"};
constexpr std::string_view kModes[] = {"beauty", "lattice", "temperature", "mass",
                                       "state",  "stress",  "stiffness"};

template <auto Group, auto Field>
constexpr ParamInfo real(std::string_view key, Unit unit, ParamRange hard, ParamRange tested,
                         ParamScale scale, std::string_view help) {
    return {key,
            "",
            unit,
            ParamKind::Real,
            hard,
            tested,
            scale,
            Live,
            help,
            "Our choice",
            {},
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo toggle(std::string_view key, std::string_view help) {
    return {key,
            "",
            unit::one,
            ParamKind::Toggle,
            {0, 1},
            {0, 1},
            Linear,
            Live,
            help,
            "Our choice",
            {},
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo choice(std::string_view key, std::span<const std::string_view> names,
                           std::string_view help) {
    const ParamRange all{0, static_cast<double>(names.size() - 1)};
    return {key,
            "",
            unit::one,
            ParamKind::Choice,
            all,
            all,
            Linear,
            Live,
            help,
            "Our choice",
            names,
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo file(std::string_view key, std::string_view help) {
    return param_rows::text<Group, Field>(key, Live, {help, "Our choice"});
}

constexpr ParamInfo kRows[] = {
    choice<&R::view, &ViewParams::mode>("view.mode", kModes,
                                        "What is drawn: the picture, the springs by kind or "
                                        "stiffness, or a colour-mapped quantity."),
    toggle<&R::view, &ViewParams::flames>("view.flames", "Whether fire is drawn."),
    toggle<&R::view, &ViewParams::ground>("view.ground", "Whether the ground is drawn."),
    toggle<&R::view, &ViewParams::transparent>("view.transparent",
                                               "Neither backdrop nor ground; the picture's alpha "
                                               "says how much it covers."),
    toggle<&R::view, &ViewParams::wireframe>("view.wireframe",
                                             "Whether the edges of the lattice's cells are drawn."),
    toggle<&R::view, &ViewParams::legend>("view.legend",
                                          "Whether views explain their colours in the picture."),
    real<&R::view, &ViewParams::stress_range>("view.stress_range", unit::kilopascal, {1e-3, 1e6},
                                              {0.05, 1000}, Logarithmic,
                                              "Stress at both ends of the scale of that view."),
    file<&R::print, &PrintParams::front>("print.front",
                                         "PNG file beside the preset: what is printed on the face "
                                         "with the first row on its left, over the whole sheet."),
    file<&R::print, &PrintParams::back>("print.back",
                                        "PNG file beside the preset: what is printed on the other "
                                        "face."),
    real<&R::camera, &CameraParams::azimuth>("camera.azimuth", unit::degree, {-360, 360},
                                             {-180, 180}, Linear,
                                             "Where the camera stands around the paper."),
    real<&R::camera, &CameraParams::elevation>("camera.elevation", unit::degree, {-89, 89},
                                               {-30, 60}, Linear, "How far it looks down."),
    real<&R::camera, &CameraParams::distance>("camera.distance", unit::metre, {0.02, 20}, {0.05, 3},
                                              Logarithmic, "From the target."),
    real<&R::camera, &CameraParams::field_of_view>("camera.field_of_view", unit::degree, {1, 150},
                                                   {15, 70}, Linear, "Vertical angle of view."),
    real<&R::camera, &CameraParams::target_x>("camera.target_x", unit::millimetre, {-5000, 5000},
                                              {-300, 300}, Linear, "What it looks at, right."),
    real<&R::camera, &CameraParams::target_y>("camera.target_y", unit::millimetre, {-5000, 5000},
                                              {0, 600}, Linear, "What it looks at, height."),
    real<&R::camera, &CameraParams::target_z>("camera.target_z", unit::millimetre, {-5000, 5000},
                                              {-300, 300}, Linear,
                                              "What it looks at, towards the viewer."),
    choice<&R::look, &LookParams::lighting>("look.lighting", kLightings,
                                            "The set: a soft studio lamp before a dark backdrop, "
                                            "or night, lit by the fire."),
    real<&R::look, &LookParams::exposure>("look.exposure", unit::one, {0.01, 100}, {0.25, 4},
                                          Logarithmic, "Brightness of the picture."),
    real<&R::look, &LookParams::key_light>("look.key_light", unit::one, {0, 100}, {0, 3}, Linear,
                                           "Brightness of the studio light."),
    real<&R::look, &LookParams::light_azimuth>("look.light_azimuth", unit::degree, {-360, 360},
                                               {-180, 180}, Linear,
                                               "The lamp, turned around the paper to the right "
                                               "from where the set has it."),
    real<&R::look, &LookParams::flame_light>("look.flame_light", unit::one, {0, 100}, {0, 4},
                                             Linear,
                                             "Light that flames throw on paper and ground."),
    real<&R::look, &LookParams::flame_size>("look.flame_size", unit::millimetre, {0.5, 500},
                                            {5, 60}, Linear, "Width of a tongue of flame."),
    real<&R::look, &LookParams::flame_share>("look.flame_share", unit::percent, {0, 100}, {1, 40},
                                             Linear,
                                             "Share of the fire particles that are drawn as "
                                             "tongues; more make the fire denser."),
    real<&R::look, &LookParams::flame_brightness>("look.flame_brightness", unit::one, {0, 100},
                                                  {0.2, 4}, Linear, "Brightness of flames."),
    real<&R::look, &LookParams::smoke>("look.smoke", unit::one, {0, 10}, {0, 3}, Linear,
                                       "How dense the smoke above the flames is."),
    real<&R::look, &LookParams::sparks>("look.sparks", unit::one, {0, 100}, {0, 5}, Linear,
                                        "How many sparks fly."),
    real<&R::look, &LookParams::haze>("look.haze", unit::one, {0, 10}, {0, 3}, Linear,
                                      "How far hot gas bends what is seen through it. In life it "
                                      "shows on what is metres away, hardly on the paper."),
    real<&R::look, &LookParams::bloom>("look.bloom", unit::one, {0, 1}, {0, 0.8}, Linear,
                                       "Share of the light beyond the film's range that spreads "
                                       "around what glows."),
    choice<&R::look, &LookParams::quality>("look.quality", kQualities,
                                           "Preview draws with fewer samples, and fire and shadows "
                                           "with fewer pixels."),
    real<&R::shot, &ShotParams::duration>("shot.duration", unit::second, {0, 3600}, {1, 60}, Linear,
                                          "Length of the shot that render draws."),
    real<&R::shot, &ShotParams::fps>("shot.fps", unit::hertz, {0.1, 1000}, {24, 60}, Linear,
                                     "Pictures per second of the shot."),
};

static_assert(row_count(kRows, "camera") == field_count<CameraParams>, "every field needs a row");
static_assert(row_count(kRows, "view") == field_count<ViewParams>, "every field needs a row");
static_assert(row_count(kRows, "look") == field_count<LookParams>, "every field needs a row");
static_assert(row_count(kRows, "shot") == field_count<ShotParams>, "every field needs a row");
static_assert(row_count(kRows, "print") == field_count<PrintParams>, "every field needs a row");
static_assert(field_count<RenderParams> == 6, "every group needs rows and an assertion above");

}  // namespace

std::span<const ParamInfo> render_param_rows() {
    return kRows;
}

ParamBinding bind(RenderParams& params) {
    return {kRows, &params};
}

std::vector<Diagnostic> read_prints(RenderParams& params, const PresetInfo& info) {
    std::vector<Diagnostic> problems;
    const auto read = [&](const std::string& key, const std::string& name) {
        if (name.empty()) return std::shared_ptr<const PictureFile>();
        auto picture = std::make_shared<PictureFile>();
        const Diagnostic problem = read_picture(key, name, info, *picture);
        if (!problem.message.empty()) problems.push_back(problem);
        return std::shared_ptr<const PictureFile>(std::move(picture));
    };
    params.printed = {read("print.front", params.print.front),
                      read("print.back", params.print.back)};
    return problems;
}

}  // namespace ember
