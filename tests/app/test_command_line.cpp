// The command line as people use it and misuse it: exit codes, messages, and nothing written.
#include <gtest/gtest.h>

#include "child.h"
#include "temporary_folder.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

// Runs in an empty folder; a bad command line must leave it empty.
ChildResult refused(const Words& words) {
    const TemporaryFolder folder;
    folder.write("bad.toml", "schema = 1\n[paper]\ngramage = 80\ndensity = -1\n");
    const ChildResult result = run_emberleaf(words, {folder.path(), {}, {}, 0});
    EXPECT_EQ(result.code, 2) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.files(), (std::set<std::string>{"bad.toml"})) << "nothing is written";
    return result;
}

void expect_refused(const Words& words, const std::string& because) {
    SCOPED_TRACE(testing::PrintToString(words));
    const ChildResult result = refused(words);
    EXPECT_NE(result.err.find(because), std::string::npos) << result.err;
}

TEST(CommandLine, HelpAndVersionSucceed) {
    EXPECT_EQ(run_emberleaf({"--help"}).code, 0);
    EXPECT_EQ(run_emberleaf({"render", "--help"}).code, 0);
    const ChildResult version = run_emberleaf({"--version"});
    EXPECT_EQ(version.code, 0);
    EXPECT_EQ(version.out.find("emberleaf 0."), 0u);
}

TEST(CommandLine, FlagsThatDoNotExistAreRefusedNotIgnored) {
    for (const char* flag : {"--save", "--frame", "--nonsense"}) {
        expect_refused({"render", "paper/corner", "-o", "x.png", flag}, flag);
    }
    expect_refused({"export", "paper/corner", "-o", "x.usda", "--at", "1"}, "--at");
    expect_refused({"sheet", "paper/corner", "-o", "x.png", "--skip-existing"}, "--skip-existing");
}

TEST(CommandLine, SlipsOfTheFingersGetASuggestion) {
    expect_refused({"render", "paper/corner", "-o", "x.png", "--frmes", "1"},
                   "did you mean --frames?");
    expect_refused({"rendr", "paper/corner", "-o", "x.png"}, "did you mean render?");
    expect_refused({"render", "paper/cornr", "-o", "x.png"}, "did you mean paper/corner?");
    expect_refused({"simulate", "paper/corner", "--set", "paper.gramage=80"},
                   "did you mean paper.grammage?");
}

TEST(CommandLine, BadArgumentsAreRefusedBeforeAnythingIsWritten) {
    const Words render = {"render", "paper/corner", "-o", "out/x.png"};
    const auto with = [&render](std::initializer_list<std::string> more) {
        Words words = render;
        words.insert(words.end(), more);
        return words;
    };
    expect_refused({"render", "paper/corner"}, "--output");
    expect_refused({"render", "-o", "x.png"}, "PRESET");
    expect_refused({"render", "paper/corner", "-o", "x.avi"}, ".png, .exr, .mp4");
    expect_refused({"render", "paper/corner", "-o", "x_%s.png"}, "%0Nd");
    expect_refused(with({"--frames", "5..1"}), "--frames");
    expect_refused(with({"--at", "-1"}), "--at");
    expect_refused(with({"--frames", "1", "--at", "1"}), "--at");
    expect_refused(with({"--size", "960"}), "--size");
    expect_refused(with({"--fps", "0"}), "--fps: error: shot.fps");
    expect_refused(with({"--fps", "fast"}), "--fps: error: shot.fps");
    expect_refused(with({"--view", "pretty"}), "--view: error: view.mode: expected one of beauty");
    expect_refused(with({"--camera", "1,2"}), "--camera");
    expect_refused(with({"--camera", "1,2,0"}), "--camera: error: camera.distance");
    expect_refused(with({"--msaa", "3"}), "--msaa");
    expect_refused(with({"--motion-blur", "0"}), "--motion-blur");
    expect_refused(with({"--shutter", "400"}), "--shutter");
    expect_refused(with({"--start", "-1"}), "--start");
    expect_refused(with({"--focal-length", "1"}), "--focal-length");
    expect_refused(with({"--lighting", "noon"}), "look.lighting: expected one of studio");
    expect_refused(with({"--animate", "sheet.rows=0:8,1:9"}), "cannot change");
    expect_refused(with({"--camera", "nowhere.toml"}), "nowhere.toml: error: no such preset");
    expect_refused(with({"--progress", "loud"}), "--progress");
    expect_refused(with({"-o", "-", "-o", "-"}), "standard output");
    expect_refused({"sheet", "paper/corner", "-o", "x.png", "--frames", "0..3", "--grid", "1x1"},
                   "--grid: error: 1x1 has no room for 4");
    expect_refused({"export", "paper/corner", "-o", "x.pc2", "--topology", "varying"}, "topology");
    expect_refused({"sweep", "paper/corner", "-o", "x.png", "--vary", "paper.gramage=1,2"},
                   "did you mean paper.grammage?");
    expect_refused({"sweep", "paper/corner", "-o", "x.png"}, "--vary");
    expect_refused({"sweep", "paper/corner", "-o", "x.png", "--vary", "paper.grammage=60,80",
                    "--array", "3/2"},
                   "--array: error");
    expect_refused({"show", "missing.png"}, "missing.png: No such file");
    expect_refused({"completion", "tcsh"}, "SHELL");
    expect_refused(with({"--gl", "vulkan"}), "--gl");
    expect_refused(with({"--seed", "-1"}), "--seed: error: numerics.seed");
    expect_refused(with({"--threads", "0"}), "--threads");
    expect_refused(with({"-q", "-v"}), "--quiet");
    expect_refused(with({"--set", "sheet.shape=cylinder", "--set", "sheet.rows=2"}), "sheet.rows");
    expect_refused({"simulate", "paper/corner", "--seconds", "-1"}, "--seconds");
    expect_refused({"simulate", "paper/corner", "--at", "1"}, "--state");
    expect_refused({"simulate", "paper/corner", "--seconds", "1", "--at", "2", "--state", "x.ply"},
                   "--seconds");
    expect_refused({"check"}, "FILE");
}

TEST(CommandLine, ABadPresetIsRefusedWithAllItsProblems) {
    for (const Words& words :
         {Words{"render", "bad.toml", "-o", "x.png", "--set", "zzzzzzzz=1"},
          Words{"simulate", "bad", "--seconds", "1", "--stats", "s.json", "--set", "zzzzzzzz=1"}}) {
        const ChildResult result = refused(words);
        EXPECT_NE(result.err.find("bad.toml:3:1: error: paper.gramage: unknown key; did you mean "
                                  "paper.grammage?\n    gramage = 80\n    ^\n"),
                  std::string::npos)
            << result.err;
        EXPECT_NE(result.err.find("bad.toml:4:11: error: paper.density: "), std::string::npos);
        EXPECT_NE(result.err.find("--set: error: zzzzzzzz: unknown key"), std::string::npos);
    }
    expect_refused({"bad.toml"}, "bad.toml:3:1: error: ");
}

TEST(CommandLine, CheckSaysWhatIsWrongInEveryFile) {
    const TemporaryFolder folder;
    folder.write("bad.toml", "schema = 1\n[paper]\ngramage = 80\n");
    folder.write("odd.toml", "schema = 1\n[paper]\ngrammage = 4000\n");
    folder.write("tube.toml", "schema = 1\n[sheet]\nshape = \"cylinder\"\nrows = 2\n");
    const ChildResult mixed =
        run_emberleaf({"check", "bad.toml", "paper/corner", "missing", "odd.toml", "tube"},
                      {folder.path(), {}, {}, 0});
    EXPECT_EQ(mixed.code, 2);
    EXPECT_EQ(mixed.out, "paper/corner: ok\nodd.toml: ok\n");
    EXPECT_NE(mixed.err.find("bad.toml:3:1: error: paper.gramage"), std::string::npos);
    EXPECT_NE(mixed.err.find("missing: error: no such preset"), std::string::npos);
    EXPECT_NE(mixed.err.find("odd.toml:3:12: warning: paper.grammage"), std::string::npos);
    EXPECT_NE(mixed.err.find("tube.toml:4:8: error: sheet.rows"), std::string::npos);
    EXPECT_EQ(run_emberleaf({"check", EMBERLEAF_SOURCE "/presets/paper/corner.toml"}).code, 0);
}

TEST(CommandLine, PresetsAndParamsListWhatThereIs) {
    const ChildResult presets = run_emberleaf({"presets"});
    EXPECT_EQ(presets.code, 0);
    EXPECT_NE(presets.out.find("paper/corner "), std::string::npos);
    EXPECT_NE(presets.out.find("bench/swing "), std::string::npos);
    const ChildResult params = run_emberleaf({"params"});
    EXPECT_EQ(params.code, 0);
    EXPECT_NE(params.out.find("paper.grammage"), std::string::npos);
    EXPECT_NE(params.out.find("shot.fps"), std::string::npos);
    EXPECT_EQ(run_emberleaf({"params", "--markdown"}).out.find("# Parameters\n"), 0u);
}

TEST(CommandLine, TheWindowWithoutADisplayFailsWithAReason) {
    const ChildResult result =
        run_emberleaf({"paper/corner"}, {".", {"DISPLAY", "WAYLAND_DISPLAY"}, {}, 0});
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("display"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace ember
