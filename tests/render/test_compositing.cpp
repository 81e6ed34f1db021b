// Pictures without a background, and what they are when something is laid behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "render/exr_file.h"
#include "render/image_difference.h"
#include "support/gl_rig.h"

namespace ember {
namespace {

using test::GlRig;
using test::StagedWorld;

// `image` over a grey of encoded value `level`, as programs that show PNG files do it.
Image over(const Image& image, double level) {
    Image out = image;
    for (std::size_t i = 0; i < out.rgba.size(); i += 4) {
        const double alpha = image.rgba[i + 3] / 255.0;
        for (std::size_t c = 0; c < 3; ++c) {
            out.rgba[i + c] = static_cast<std::uint8_t>(
                std::lround(alpha * image.rgba[i + c] + (1.0 - alpha) * level));
        }
        out.rgba[i + 3] = 255;
    }
    return out;
}

// At night without its moon the set is black, so the opaque picture has a black background.
RenderParams before_black() {
    RenderParams params;
    params.view.ground = false;
    params.look.lighting = LightingPreset::Night;
    params.look.key_light = 0;
    return params;
}

int largest_difference(const Image& a, const Image& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
    return most;
}

TEST(Transparent, OverBlackItIsTheOpaquePicture) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(16, 24, 400);
    RenderParams params = before_black();
    const Image opaque = rig.draw(staged.view(), params);
    params.view.transparent = true;
    const Image clear = rig.draw(staged.view(), params);
    // one step of dither and one of rounding; dark colours with a small alpha lose no more
    EXPECT_LE(largest_difference(over(clear, 0), opaque), 2);
    Image forgotten = clear;  // premultiplied colours taken for straight ones
    for (std::size_t i = 0; i < forgotten.rgba.size(); i += 4) {
        for (std::size_t c = 0; c < 3; ++c) {
            forgotten.rgba[i + c] =
                static_cast<std::uint8_t>(clear.rgba[i + c] * clear.rgba[i + 3] / 255);
        }
    }
    EXPECT_GT(largest_difference(over(forgotten, 0), opaque), 10);
}

TEST(Transparent, OverWhitePaperStaysWhatItIsAndNoEdgeIsDark) {
    GlRig rig;
    RenderParams params;
    params.view.transparent = true;
    const StagedWorld staged = test::hanging_sheet(16, 24);
    const Image clear = rig.draw(staged.view(), params);
    const Image white = over(clear, 255);
    const auto at = [](const Image& image, int x, int y) {
        return image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
    };
    const int paper = at(white, 160, 90);
    EXPECT_EQ(at(clear, 160, 90), paper);
    EXPECT_EQ(clear.rgba[3], 0) << "the corner is empty";
    EXPECT_EQ(at(white, 0, 0), 255);
    for (std::size_t i = 0; i < white.rgba.size(); i += 4)
        ASSERT_GE(white.rgba[i], paper - 40) << "pixel " << i / 4;
}

TEST(Transparent, FlamesAreLightThatIsSeenOverBlackAndOverWhite) {
    GlRig rig;
    StagedWorld staged = test::hanging_sheet(4, 6);
    for (int i = 0; i < 2000; ++i)
        staged.add_particle({0.16 + 0.00001 * i, 0.30, 0.02}, test::kFlame);
    RenderParams params = before_black();
    params.view.transparent = true;
    const Image with = rig.draw(staged.view(), params);
    int bright = 0, orange = 0;
    const Image white = over(with, 255);
    for (std::size_t i = 0; i < with.rgba.size(); i += 4) {
        if (with.rgba[i + 3] < 128) continue;
        bright += over({1,
                        1,
                        {with.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                         with.rgba.begin() + static_cast<std::ptrdiff_t>(i) + 4}},
                       0)
                      .rgba[0] > 100;
        orange += white.rgba[i] > white.rgba[i + 2] + 30;
    }
    EXPECT_GT(bright, 100);
    EXPECT_GT(orange, 100);
}

const std::vector<float>& channel(const FloatImage& image, const std::string& name) {
    for (const auto& [known, values] : image.channels) {
        if (known == name) return values;
    }
    throw std::runtime_error("no channel " + name);
}

// Light over light: the picture without a background, laid over what is behind it, is the picture
// with that background, flames and torn edges included.
TEST(Layers, OverTheBackgroundTheyAreTheOpaqueLight) {
    GlRig rig;
    const StagedWorld staged = test::burning_sheet(16, 24, 400);
    StagedWorld nothing = test::hanging_sheet(4, 6);
    nothing.quads.clear();
    RenderParams params;
    params.view.ground = false;
    const auto light = [&](const StagedWorld& s, bool transparent) {
        params.view.transparent = transparent;
        const WorldView world = s.view();
        return rig.renderer.draw_layers({&world, {}}, params, 320, 180);
    };
    const FloatImage opaque = light(staged, false), clear = light(staged, true);
    const FloatImage behind = light(nothing, false);
    const std::vector<float>& alpha = channel(clear, "A");
    double worst = 0, forgotten = 0;
    int partly = 0;
    for (const char* name : {"R", "G", "B"}) {
        for (std::size_t i = 0; i < alpha.size(); ++i) {
            const float o = channel(opaque, name)[i], c = channel(clear, name)[i];
            const float b = channel(behind, name)[i];
            const auto off = static_cast<double>(std::abs(c + (1 - alpha[i]) * b - o) / (1 + o));
            worst = std::max(worst, off);
            forgotten = std::max(forgotten, static_cast<double>(std::abs(c - o)));
            partly += alpha[i] > 0.02f && alpha[i] < 0.98f ? 1 : 0;
        }
    }
    EXPECT_LT(worst, 2e-3) << "half floats";
    EXPECT_GT(forgotten, 0.02) << "there is a background";
    EXPECT_GT(partly, 300) << "flames and edges cover in part";
}

TEST(Layers, AreWhatThePaperIs) {
    GlRig rig;
    const StagedWorld staged = test::hanging_sheet(16, 24);
    RenderParams params;
    params.view.transparent = true;
    params.camera.azimuth = params.camera.elevation = 0;
    const WorldView world = staged.view();
    const FloatImage image = rig.renderer.draw_layers({&world, {}}, params, 160, 90);
    EXPECT_EQ(image.channels.size(), 16u);
    const std::size_t middle = 45 * 160 + 80, corner = 0;
    EXPECT_NEAR(channel(image, "A")[middle], 1.0f, 1e-3f);
    EXPECT_EQ(channel(image, "A")[corner], 0.0f);
    EXPECT_NEAR(channel(image, "depth.Z")[middle], 0.78f, 0.01f);
    EXPECT_GT(channel(image, "depth.Z")[corner], 1e9f);
    EXPECT_NEAR(channel(image, "normal.Z")[middle], 1.0f, 0.2f);
    EXPECT_NEAR(channel(image, "temperature.T")[middle], test::kAmbient - 273.15, 0.1);
    EXPECT_EQ(channel(image, "phase.id")[middle], 0.0f);
    EXPECT_EQ(channel(image, "phase.id")[corner], -1.0f);
    EXPECT_GT(channel(image, "albedo.G")[middle], 0.5f);
    EXPECT_EQ(channel(image, "emission.R")[middle], 0.0f);
    // and a picture drawn afterwards is a picture
    EXPECT_GT(rig.draw(world, params).rgba[4 * (90 * 320 + 160)], 50);
}

TEST(Layers, SurviveAnExrFile) {
    if (!exr_available()) GTEST_SKIP() << "built without OpenEXR";
    FloatImage image{3, 2, {}};
    image.channels.emplace_back("R", std::vector<float>{0, 0.5f, 1, 2, 4, 8});
    image.channels.emplace_back("depth.Z", std::vector<float>{0.7801f, 1, 2, 3, 1e10f, 5});
    const auto path = std::filesystem::temp_directory_path() / "emberleaf_layers.exr";
    write_exr(path, image, {{"Software", "emberleaf"}});
    const FloatImage read = read_exr(path);
    std::filesystem::remove(path);
    EXPECT_EQ(read.width, 3);
    EXPECT_EQ(read.height, 2);
    EXPECT_EQ(channel(read, "R"), image.channels[0].second);
    EXPECT_EQ(channel(read, "depth.Z"), image.channels[1].second);
    EXPECT_THROW(write_exr("/no/such/folder/x.exr", image, {}), std::runtime_error);
}

}  // namespace
}  // namespace ember
