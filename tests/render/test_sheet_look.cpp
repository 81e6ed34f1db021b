// Burning paper in the picture: bands of so many millimetres on every lattice and at every size,
// and what was printed.
#include <gtest/gtest.h>

#include <cmath>

#include "render/image_difference.h"
#include "support/gl_rig.h"
#include "support/node_pixels.h"

namespace ember {
namespace {

using test::GlRig;
using test::StagedWorld;

// The staged sheet, flat, seen at right angles without its flames.
StagedWorld flat_sheet(int rows, int columns) {
    StagedWorld staged = test::burning_sheet(rows, columns, 0);
    staged.z.assign(staged.z.size(), 0.0);
    return staged;
}

RenderParams head_on() {
    RenderParams params;
    params.camera.azimuth = params.camera.elevation = 0;
    params.view.flames = false;
    return params;
}

struct Picture {
    Image image;
    Camera camera;

    // Luminance at a distance and direction from the burning corner [m, rad].
    [[nodiscard]] float at(const StagedWorld& staged, double r, double angle) const {
        const Eigen::Vector3f place(static_cast<float>(-0.5 * staged.width + r * std::cos(angle)),
                                    static_cast<float>(0.45 - staged.height + r * std::sin(angle)),
                                    0.0f);
        const Eigen::Vector3f p = project(camera, place, image.width, image.height);
        return test::luminance(
            test::linear_colour(image, static_cast<int>(p.x()), static_cast<int>(p.y())));
    }
};

Picture take(GlRig& rig, const StagedWorld& staged, const RenderParams& params, int height) {
    const int width = height * 16 / 9;
    return {rig.draw(staged.view(), params, width, height),
            make_camera(params.camera, width, height)};
}

// Mean widths along radii from 138 mm to where char ends, and of what is neither char nor white
// [mm].
struct Bands {
    double black = 0, scorched = 0;
};

Bands bands(const Picture& picture, const StagedWorld& staged) {
    constexpr double kStep = 0.25e-3;
    Bands sum;
    int radii = 0;
    for (double angle = 0.15; angle < 1.4; angle += 0.01, ++radii) {
        const float white = picture.at(staged, 0.205, angle);
        double char_end = 0.138;
        for (double r = 0.138; r < 0.2; r += kStep) {
            const float l = picture.at(staged, r, angle);
            if (l < 0.06f * white) char_end = r;
            if (l >= 0.06f * white && l < 0.7f * white && r > 0.154) sum.scorched += 1e3 * kStep;
        }
        sum.black += 1e3 * (char_end - 0.138);
    }
    return {sum.black / radii, sum.scorched / radii};
}

TEST(BurningPaper, BandsAreAsWideOnEveryLatticeAndAtEverySize) {
    GlRig rig;
    const StagedWorld coarse = flat_sheet(33, 49), fine = flat_sheet(65, 97);
    const Bands reference = bands(take(rig, fine, head_on(), 1080), fine);
    EXPECT_GT(reference.black, 15) << "mm of char";
    EXPECT_GT(reference.scorched, 2) << "mm of scorch";
    EXPECT_LT(reference.scorched, 9);
    for (const int height : {540, 1080}) {
        for (const StagedWorld* staged : {&coarse, &fine}) {
            const Bands b = bands(take(rig, *staged, head_on(), height), *staged);
            EXPECT_NEAR(b.black, reference.black, 1.0) << height << ' ' << staged->rows;
            EXPECT_NEAR(b.scorched, reference.scorched, 0.6) << height << ' ' << staged->rows;
        }
    }
}

std::shared_ptr<const PictureFile> page(const std::string& name) {
    Image image = read_image(EMBERLEAF_SOURCE "/presets/paper/" + name);
    return std::make_shared<const PictureFile>(
        PictureFile{name, image.width, image.height, std::move(image.rgba)});
}

// How much the print changes the picture between two radii, relative to what it is without.
double contrast(GlRig& rig, const StagedWorld& staged, double from, double to) {
    RenderParams params = head_on();
    const Picture plain = take(rig, staged, params, 1080);
    params.printed.front = page("letter.png");
    const Picture printed = take(rig, staged, params, 1080);
    double sum = 0, ink = 0;
    for (double angle = 0.1; angle < 1.45; angle += 0.003) {
        for (double r = from; r < to; r += 0.5e-3) {
            const double a = static_cast<double>(plain.at(staged, r, angle));
            const double b = static_cast<double>(printed.at(staged, r, angle));
            const double difference = std::abs(a - b) / (a + b + 0.002);
            if (difference < 0.05) continue;  // no ink here
            sum += difference;
            ink += 1;
        }
    }
    return ink > 100 ? sum / ink : 0;
}

// Luminance of the film's output, 0 .. 1.
TEST(BurningPaper, HoweverManyFlamesPaperIsNoBrighterThanThemAndCharStaysBlack) {
    GlRig rig;
    RenderParams params = head_on();
    params.look.lighting = LightingPreset::Night;
    params.look.key_light = 0;
    params.view.flames = true;  // felt, but not in the way
    params.look.flame_share = params.look.flame_brightness = params.look.smoke = 0;
    float last = 0;
    for (const int particles : {3000, 60000, 240000}) {
        StagedWorld staged = test::burning_sheet(24, 34, particles);
        staged.z.assign(staged.z.size(), 0.0);
        const Picture picture = take(rig, staged, params, 360);
        const float paper = picture.at(staged, 0.19, 0.8);
        EXPECT_GT(paper, last) << particles;
        EXPECT_LT(paper, 0.45f) << particles;
        EXPECT_LT(picture.at(staged, 0.141, 0.8), 0.010f) << particles;
        last = paper;
    }
    EXPECT_GT(last, 0.3f);
}

TEST(BurningPaper, PrintStaysLegibleOnCharButFainterThanOnPaper) {
    GlRig rig;
    const StagedWorld staged = flat_sheet(33, 49);
    const double on_char = contrast(rig, staged, 0.02, 0.11);
    const double on_paper = contrast(rig, staged, 0.185, 0.205);
    EXPECT_GT(on_char, 0.12);
    EXPECT_LT(on_char, 0.8 * on_paper);
}

TEST(BurningPaper, TheBackIsPrintedOnItsOwn) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(8, 12);
    RenderParams params = head_on();
    const Image plain = rig.draw(staged.view(), params);
    params.printed.back = page("music.png");
    EXPECT_TRUE(compare(rig.draw(staged.view(), params), plain).identical());
    params.printed.front = params.printed.back;
    EXPECT_GT(compare(rig.draw(staged.view(), params), plain).pixels, 500);
}

TEST(BurningPaper, ATornEdgeIsFibrousAndTheSheetsOwnBorderIsNot) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(9, 13);
    RenderParams params = head_on();
    params.view.ground = false;  // its shadow has the hole, too
    const Image whole = rig.draw(staged.view(), params, 960, 540);
    staged.quads.erase(staged.quads.begin() + 40);  // inside
    staged.topology_version = 2;
    const Image torn = rig.draw(staged.view(), params, 960, 540);
    // a hole of 26 mm × 25 mm, whose corners wander by up to 6 mm, at 1.1 pixels/mm, and up to
    // 1.5 mm of fibres around it
    EXPECT_GT(compare(whole, torn).pixels, 500);
    EXPECT_LT(compare(whole, torn).pixels, 1460);
}

// Pixels that a sheet of some thickness [m] covers when the camera sees it nearly from its side.
double covered_from_the_side(GlRig& rig, const StagedWorld& staged, double caliper) {
    RenderParams params = head_on();
    params.camera.azimuth = 1.4;
    params.camera.distance = 4;  // and a long lens: hardly any perspective
    params.camera.field_of_view = 0.1;
    params.view.transparent = true;
    WorldView view = staged.view();
    view.caliper = caliper;
    const Image image = rig.draw(view, params, 960, 540);
    double covered = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        covered += image.rgba[i] / 255.0;
    return covered;
}

TEST(BurningPaper, EdgesAreAsThickAsThePaperWhereTheCameraIsNear) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(8, 12);
    const double thin = covered_from_the_side(rig, staged, 0);
    const double pixels = 540 / (2 * 4 * std::tan(0.05));  // in a metre
    EXPECT_NEAR(thin, 0.210 * std::cos(1.4) * 0.297 * pixels * pixels, 0.02 * thin);
    for (const double caliper : {0.003, 0.006}) {
        const double wall = caliper * std::sin(1.4) * 0.297 * pixels * pixels;
        EXPECT_NEAR(covered_from_the_side(rig, staged, caliper) - thin, wall, 0.1 * wall);
    }
    EXPECT_EQ(covered_from_the_side(rig, staged, 0.0008), thin) << "too thin to be seen";
}

TEST(ColourMappedViews, AWireframeDarkensTheEdgesOfTheCellsOnly) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(5, 7);
    RenderParams params = head_on();
    params.view.mode = ViewMode::Mass;
    params.view.legend = false;
    const Image plain = rig.draw(staged.view(), params, 960, 540);
    params.view.wireframe = true;
    const Image wires = rig.draw(staged.view(), params, 960, 540);
    const auto changed = compare(plain, wires).pixels;
    const double length = 1.1e3 * (5 * 0.297 + 7 * 0.210);  // [pixels] of all edges
    EXPECT_GT(static_cast<double>(changed), 0.8 * length);
    EXPECT_LT(static_cast<double>(changed), 4 * length);
}

}  // namespace
}  // namespace ember
