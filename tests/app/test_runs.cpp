// Whole runs of the program: files, hashes, films, interrupts.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "child.h"
#include "ply_reader.h"
#include "render/exr_file.h"
#include "render/image.h"
#include "temporary_folder.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

const Words kSmall = {"--set", "sheet.rows=12", "--set", "sheet.columns=18"};

ChildResult run_in(const TemporaryFolder& folder, Words words, ChildOptions options = {}) {
    words.insert(words.end(), kSmall.begin(), kSmall.end());
    options.folder = folder.path();
    return run_emberleaf(words, options);
}

nlohmann::json stats_in(const TemporaryFolder& folder, const std::string& name) {
    return nlohmann::json::parse(folder.read(name));
}

std::string text_of(const ImageText& text, const std::string& keyword) {
    for (const auto& [key, value] : text) {
        if (key == keyword) return value;
    }
    return "(missing)";
}

TEST(Simulate, WritesStatisticsAndStatesAndPrintsTheHash) {
    const TemporaryFolder folder;
    const ChildResult result =
        run_in(folder, {"simulate", "paper/corner", "--seconds", "1", "--stats", "out/s.json",
                        "--state", "out/state_##.ply", "--at", "0,0.251,1", "-q"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(folder.files(), (std::set<std::string>{"out", "out/s.json", "out/state_00.ply",
                                                     "out/state_01.ply", "out/state_02.ply"}));
    const auto stats = stats_in(folder, "out/s.json");
    EXPECT_EQ(stats.at("frames").size(), 60u);
    EXPECT_NE(result.out.find("state hash: " + stats.at("state_hash").get<std::string>() + '\n'),
              std::string::npos);
    EXPECT_EQ(read_ply(folder.read("out/state_02.ply")).faces.size(), 12u * 18u);
    EXPECT_EQ(result.err, "") << "-q is quiet";
}

TEST(Simulate, OneStateKeepsItsName) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        run_in(folder, {"simulate", "paper/corner", "--seconds", "0.1", "--state", "end.ply", "-q"})
            .code,
        0);
    EXPECT_EQ(folder.files(), (std::set<std::string>{"end.ply"}));
}

TEST(Simulate, TheHashDependsOnTheSeedButNotOnThreadsOrOutputs) {
    const TemporaryFolder folder;
    const auto hash = [&](Words more) {
        Words words = {"simulate", "paper/corner", "--seconds", "0.5", "-q"};
        words.insert(words.end(), more.begin(), more.end());
        const std::string out = run_in(folder, words).out;
        return out.substr(out.find("state hash: "));
    };
    const std::string one = hash({"--threads", "1"});
    EXPECT_EQ(one.size(), std::string("state hash: 0123456789abcdef\n").size());
    EXPECT_EQ(hash({"--threads", "1"}), one) << "twice in a row";
    EXPECT_EQ(hash({"--threads", "2"}), one);
    EXPECT_EQ(hash({"--state", "x.ply", "--at", "0.111,0.3"}), one);
    EXPECT_NE(hash({"--seed", "2"}), one);
}

TEST(Render, TheFrameRateNeverChangesTheBurn) {
    const TemporaryFolder folder;
    std::set<std::string> hashes;
    for (const std::string fps : {"24", "25", "30", "60"}) {
        const ChildResult result = run_in(
            folder, {"render", "paper/corner", "-o", "f" + fps + "_##.png", "--fps", fps, "--size",
                     "32x32", "--set", "shot.duration=0.5", "--stats", fps + ".json", "-q"});
        ASSERT_EQ(result.code, 0) << result.err;
        hashes.insert(stats_in(folder, fps + ".json").at("state_hash").get<std::string>());
    }
    EXPECT_EQ(hashes.size(), 1u);
    EXPECT_TRUE(std::filesystem::exists(folder / "f24_11.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "f24_12.png")) << "12 frames in half a second";
    EXPECT_TRUE(std::filesystem::exists(folder / "f60_29.png"));
}

TEST(Render, PicturesCarryPresetSeedFrameTimeAndVersion) {
    const TemporaryFolder folder;
    const ChildResult result =
        run_in(folder, {"render", "paper/corner", "-o", "new/folder/f_####.png", "--frames",
                        "0..10+5", "--fps", "20", "--seed", "7", "--size", "64x48"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("new/folder/f_0000.png"), std::string::npos) << "says where";
    EXPECT_EQ(folder.files().count("new/folder/f_0010.png"), 1u);
    EXPECT_EQ(folder.files().size(), 5u) << "two folders and three pictures, nothing else";
    const ImageText text = read_png_text(folder / "new/folder/f_0005.png");
    EXPECT_EQ(text_of(text, "Software"), "emberleaf");
    EXPECT_EQ(text_of(text, "Version").find("0."), 0u);
    EXPECT_EQ(text_of(text, "Seed"), "7");
    EXPECT_EQ(text_of(text, "Frame"), "5");
    EXPECT_EQ(text_of(text, "Time"), "0.25 s");
    EXPECT_NE(text_of(text, "Renderer"), "(missing)");
    // the picture's own preset draws the same picture again
    folder.write("again.toml", text_of(text, "Preset"));
    ASSERT_EQ(
        run_in(folder, {"render", "again", "-o", "again.png", "--frames", "5", "--size", "64x48"})
            .code,
        0);
    EXPECT_EQ(read_image(folder / "again.png").rgba,
              read_image(folder / "new/folder/f_0005.png").rgba);
}

TEST(Render, WritesPicturesAndAFilmInOneRun) {
    const TemporaryFolder folder;
    const ChildResult result =
        run_in(folder, {"render", "paper/corner", "-o", "f_#.png", "-o", "film/f.mp4", "--frames",
                        "0..4", "--size", "33x31"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(folder.files(), (std::set<std::string>{"f_0.png", "f_1.png", "f_2.png", "f_3.png",
                                                     "f_4.png", "film", "film/f.mp4"}));
    EXPECT_EQ(folder.read("film/f.mp4").substr(4, 4), "ftyp");
    EXPECT_LT(folder.read("film/f.mp4").find("moov"), folder.read("film/f.mp4").find("mdat"));
}

TEST(Render, WritesLayersAndTransparentPicturesFromANamedPlace) {
    const TemporaryFolder folder;
    const bool exr = exr_available();
    Words words = {"render", "paper/corner", "-o", "f.png",  "--transparent", "--camera",
                   "close",  "--frames",     "0",  "--size", "64x48"};
    if (exr) words.insert(words.end(), {"-o", "f.exr"});
    const ChildResult result = run_in(folder, words);
    ASSERT_EQ(result.code, 0) << result.err;
    const Image image = read_image(folder / "f.png");
    EXPECT_EQ(image.rgba[3], 0) << "nothing in the corner";
    EXPECT_EQ(image.rgba[4 * (24 * 64 + 32) + 3], 255) << "paper in the middle";
    if (exr) {
        EXPECT_EQ(read_exr(folder / "f.exr").channels.size(), 16u);
    } else {
        const ChildResult refused = run_in(folder, {"render", "paper/corner", "-o", "f.exr"});
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("libopenexr-dev"), std::string::npos) << refused.err;
    }
    EXPECT_EQ(folder.files().size(), exr ? 2u : 1u);
}

TEST(Render, AFilmWithoutFfmpegFailsAndSaysWhatToInstall) {
    const TemporaryFolder folder;
    const ChildResult result = run_in(
        folder, {"render", "paper/corner", "-o", "f.mp4", "--frames", "0", "--size", "32x32"},
        {".", {"PATH=/nowhere"}, {}, 0});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("apt install ffmpeg"), std::string::npos) << result.err;
    EXPECT_EQ(folder.files(), std::set<std::string>());
}

TEST(Render, AnEncoderThatFailsIsReportedInItsOwnWords) {
    const TemporaryFolder folder;
    folder.write("bin/ffmpeg", "#!/bin/sh\necho no such codec today >&2\nexit 1\n");
    std::filesystem::permissions(folder / "bin/ffmpeg", std::filesystem::perms::owner_all);
    const ChildResult result = run_in(
        folder, {"render", "paper/corner", "-o", "f.mp4", "--frames", "0..3", "--size", "320x320"},
        {".", {"PATH=" + (folder / "bin").string()}, {}, 0});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("f.mp4: ffmpeg failed: no such codec today"), std::string::npos)
        << result.err;
    EXPECT_EQ(folder.files(), (std::set<std::string>{"bin", "bin/ffmpeg"}));
}

TEST(Render, AnOutputThatCannotBeWrittenIsAFailedRun) {
    const TemporaryFolder folder;
    folder.write("file", "in the way");
    const ChildResult result = run_in(
        folder, {"render", "paper/corner", "-o", "file/f.png", "--frames", "0", "--size", "32x32"});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("file"), std::string::npos);
    EXPECT_EQ(
        run_in(folder, {"simulate", "paper/corner", "--seconds", "0.1", "--stats", "file/s.json"})
            .code,
        1);
    EXPECT_EQ(folder.files(), (std::set<std::string>{"file"}));
}

TEST(Interrupt, FinishesTheFrameKeepsWhatIsThereAndTellsTheShell) {
    for (const auto& [signal, code] : {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}}) {
        const TemporaryFolder folder;
        const ChildResult result = run_in(
            folder,
            {"render", "paper/corner", "-o", "f_####.png", "-o", "f.mp4", "--size", "160x120"},
            {".", {}, folder / "f_0002.png", signal});
        EXPECT_EQ(result.code, code) << result.err;
        const auto files = folder.files();
        EXPECT_LT(files.size(), 300u) << "it has not gone on to the end";
        EXPECT_EQ(files.count("f.mp4"), 1u) << "the film up to here";
        for (const std::string& name : files) {
            EXPECT_EQ(name.find("tmp"), std::string::npos) << name;
            if (name.ends_with(".png")) {
                EXPECT_EQ(read_image(folder / name).width, 160) << name;
            }
        }
    }
}

TEST(Interrupt, ASimulationStillWritesItsStatistics) {
    const TemporaryFolder folder;
    const ChildResult result = run_in(folder,
                                      {"simulate", "paper/corner", "--seconds", "3600", "--stats",
                                       "s.json", "--state", "s_#.ply", "--at", "0,3600"},
                                      {".", {}, folder / "s_0.ply", SIGINT});
    EXPECT_EQ(result.code, 130) << result.err;
    EXPECT_EQ(folder.files(), (std::set<std::string>{"s.json", "s_0.ply"}));
    EXPECT_TRUE(stats_in(folder, "s.json").contains("state_hash"));
}

}  // namespace
}  // namespace ember
