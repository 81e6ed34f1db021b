// Films and pictures of every kind, opened by programs that are not ours.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "child.h"
#include "render/exr_file.h"
#include "render/image.h"
#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

constexpr int kFrames = 5, kWide = 48, kHigh = 32;

ChildResult draw(const TemporaryFolder& folder, Words more, const std::string& command = "render") {
    Words words = {command,    "paper/corner",
                   "--set",    "sheet.rows=12",
                   "--set",    "sheet.columns=18",
                   "--frames", "30..34",
                   "--fps",    "24",
                   "--size",   std::to_string(kWide) + 'x' + std::to_string(kHigh),
                   "-q"};
    words.insert(words.end(), more.begin(), more.end());
    return run_emberleaf(words, {folder.path(), {}, {}, 0});
}

nlohmann::json probe(const std::filesystem::path& film) {
    const ToolResult result =
        run_tool("ffprobe -v error -count_frames -select_streams v:0 -show_streams -of json '" +
                 film.string() + '\'');
    return nlohmann::json::parse(result.out).at("streams").at(0);
}

struct Film {
    const char *extension, *codec, *pixels;
};

TEST(Films, OpenElsewhereWithTheirSizeFramesAndAlpha) {
    const TemporaryFolder folder;
    const Film films[] = {{"mp4", "h264", "yuv420p"}, {"mov", "prores", "yuva444p12le"},
                          {"webm", "vp9", "yuv420p"},  // its alpha is beside it
                          {"gif", "gif", "bgra"},     {"apng", "apng", "rgba"},
                          {"mkv", "ffv1", "bgra"}};
    Words words = {"--transparent"};
    for (const Film& film : films)
        words.insert(words.end(), {"-o", std::string("f.") + film.extension});
    const ChildResult result = draw(folder, words);
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "") << "-q is quiet";
    for (const Film& film : films) {
        SCOPED_TRACE(film.extension);
        const nlohmann::json stream = probe(folder / (std::string("f.") + film.extension));
        EXPECT_EQ(stream.at("codec_name"), film.codec);
        EXPECT_EQ(stream.at("pix_fmt"), film.pixels);
        EXPECT_EQ(stream.at("width"), kWide);
        EXPECT_EQ(stream.at("height"), kHigh);
        EXPECT_EQ(stream.at("nb_read_frames"), std::to_string(kFrames));
    }
    EXPECT_EQ(probe(folder / "f.webm").at("tags").at("alpha_mode"), "1");
    EXPECT_EQ(probe(folder / "f.mp4").at("r_frame_rate"), "24/1");
}

TEST(Films, AnAnimatedWebpHasItsFramesAndAlpha) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"--transparent", "-o", "f.webp"}).code, 0);
    const ToolResult result =
        run_tool("identify -format '%w %h %A\\n' '" + (folder / "f.webp").string() + '\'');
    std::string expected;
    for (int f = 0; f < kFrames; ++f)
        expected += "48 32 Blend\n";
    EXPECT_EQ(result.out.substr(0, expected.size()).find("48 32"), 0u) << result.out;
    EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), kFrames) << result.out;
    EXPECT_EQ(result.out.find("Undefined"), std::string::npos) << result.out;
}

TEST(Films, ALosslessFilmHoldsThePixelsOfThePictures) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "f.mkv", "-o", "f_##.png"}).code, 0);
    ASSERT_EQ(run_tool("ffmpeg -v error -i '" + (folder / "f.mkv").string() +
                       "' -start_number 30 '" + (folder / "back_%02d.png").string() + '\'')
                  .status,
              0);
    for (int f = 30; f < 30 + kFrames; ++f) {
        const std::string number = std::to_string(f);
        EXPECT_EQ(read_image(folder / ("f_" + number + ".png")).rgba,
                  read_image(folder / ("back_" + number + ".png")).rgba);
    }
}

TEST(Films, StandardOutputIsTheSamePixels) {
    const TemporaryFolder folder;
    const ChildResult result = draw(folder, {"-o", "-", "-o", "f_##.png"});
    ASSERT_EQ(result.code, 0) << result.err;
    ASSERT_EQ(result.out.size(), std::size_t{kFrames * kWide * kHigh * 4});
    const Image second = read_image(folder / "f_31.png");
    const std::string bytes = result.out.substr(second.rgba.size(), second.rgba.size());
    EXPECT_TRUE(
        std::equal(bytes.begin(), bytes.end(), second.rgba.begin(),
                   [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; }));
}

TEST(Pictures, OpenElsewhere) {
    const TemporaryFolder folder;
    Words words = {"-o", "f_####.png", "--transparent"};
    if (exr_available()) words.insert(words.end(), {"-o", "f_####.exr"});
    ASSERT_EQ(draw(folder, words).code, 0);
    EXPECT_EQ(run_tool("identify -format '%m %w %h %[channels] %[colorspace]' '" +
                       (folder / "f_0030.png").string() + '\'')
                  .out,
              "PNG 48 32 srgba sRGB");
    if (!exr_available()) return;
    const ToolResult header = run_tool("exrheader '" + (folder / "f_0030.exr").string() + '\'');
    EXPECT_EQ(header.status, 0) << header.out;
    EXPECT_NE(header.out.find("displayWindow (type box2i): (0 0) - (47 31)"), std::string::npos)
        << header.out;
    for (const char* channel : {"A, 16-bit", "depth.Z, 32-bit", "temperature.T, 32-bit"})
        EXPECT_NE(header.out.find(channel), std::string::npos) << header.out;
}

TEST(Sheet, HoldsEveryFrameWhereItsJsonSays) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "fire.png", "--grid", "3x2"}, "sheet").code, 0);
    ASSERT_EQ(draw(folder, {"-o", "f_##.png"}).code, 0);
    const Image sheet = read_image(folder / "fire.png");
    EXPECT_EQ(sheet.width, 3 * kWide);
    EXPECT_EQ(sheet.height, 2 * kHigh);
    const auto json = nlohmann::json::parse(folder.read("fire.json"));
    EXPECT_EQ(json.at("image"), "fire.png");
    ASSERT_EQ(json.at("frames").size(), std::size_t{kFrames});
    for (const auto& frame : json.at("frames")) {
        const Image alone = read_image(folder / ("f_" + frame.at("number").dump() + ".png"));
        const int x = frame.at("x"), y = frame.at("y");
        for (int line = 0; line < kHigh; ++line) {
            const auto from = sheet.rgba.begin() + 4 * ((y + line) * sheet.width + x);
            ASSERT_TRUE(std::equal(from, from + 4 * kWide, alone.rgba.begin() + 4 * line * kWide));
        }
    }
    EXPECT_EQ(draw(folder, {"-o", "fire.png", "--grid", "2x2"}, "sheet").code, 2) << "no room";
}

TEST(Pipeline, DrawsTheSameWithAndWithoutOverlap) {
    const TemporaryFolder folder;
    for (const char* name : {"a", "b"}) {
        Words words = {"-o",
                       std::string(name) + "_##.png",
                       "--motion-blur",
                       "3",
                       "--animate",
                       "camera.azimuth=0:0,2:90",
                       "--animate",
                       "burning.burn_speed=0:1,2:3"};
        if (*name == 'b') words.emplace_back("--serial");
        const ChildResult result = draw(folder, words);
        ASSERT_EQ(result.code, 0) << result.err;
    }
    for (int f = 30; f < 30 + kFrames; ++f) {
        const std::string number = std::to_string(f);
        EXPECT_EQ(folder.read("a_" + number + ".png"), folder.read("b_" + number + ".png"));
    }
    EXPECT_NE(folder.read("a_30.png"), folder.read("a_34.png"));
}

TEST(Turntable, GoesAroundABurnThatStandsStill) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "f_##.png", "--turntable", "360", "--at", "1", "--set",
                            "shot.duration=2"})
                  .code,
              0);
    const Image half = read_image(folder / "f_30.png");
    EXPECT_EQ(*find_text(read_png_text(folder / "f_30.png"), "Time"), "1 s");
    EXPECT_EQ(*find_text(read_png_text(folder / "f_34.png"), "Time"), "1 s");
    EXPECT_NE(half.rgba, read_image(folder / "f_34.png").rgba) << "the camera has moved";
}

}  // namespace
}  // namespace ember
