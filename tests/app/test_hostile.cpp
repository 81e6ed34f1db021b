// Outputs that cannot be: each gives one clear line and the right exit code, and harms nothing.
#include <gtest/gtest.h>

#include <algorithm>

#include "child.h"
#include "render/image.h"
#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

const Words kSmall = {"--set",    "sheet.rows=12", "--set", "sheet.columns=18", "--size", "64x48",
                      "--frames", "0..3",          "-q"};

// The message must be one line that has `because` in it.
void expect_refused(const TemporaryFolder& folder, Words words, int code,
                    const std::string& because) {
    SCOPED_TRACE(testing::PrintToString(words));
    words.insert(words.end(), kSmall.begin(), kSmall.end());
    const auto before = folder.files();
    const ChildResult result = run_emberleaf(words, {folder.path(), {}, {}, 0});
    EXPECT_EQ(result.code, code) << result.err;
    EXPECT_NE(result.err.find(because), std::string::npos) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(folder.files(), before) << "nothing new, nothing lost";
}

Words render(const std::string& output) {
    return {"render", "paper/corner", "-o", output};
}

TEST(HostileOutputs, AreRefusedWithPathAndReason) {
    const TemporaryFolder folder;
    folder.write("file", "in the way");
    for (const char* name :
         {"taken_0000.png/x", "film.mp4/x", "taken_0000.exr/x", "s.png/x", "burn.usda/x"}) {
        folder.write(name, "a folder of that name");
    }
    expect_refused(folder, render("file/f_####.png"), 1, "file: cannot create: ");
    expect_refused(folder, render("taken_####.png"), 1, "taken_0000.png: cannot write: ");
    expect_refused(folder, render("film.mp4"), 1, "film.mp4: is a folder");
    expect_refused(folder, render("file/film.mp4"), 1, "file: cannot create: ");
    expect_refused(folder, render("/proc/nowhere/f_####.png"), 1, "/proc/nowhere: cannot create: ");
    expect_refused(folder, render("/sys/f_####.png"), 1, "/sys/f_0000.png: cannot write: ");
    expect_refused(folder, render("f_%s.png"), 2, "f_%s.png: error: expected a name with ####");
    expect_refused(folder, render("f_{name}_####.png"), 2, "expected a name with ####");
    expect_refused(folder, render("####_####.png"), 2, "more than one place");
    expect_refused(folder, render("f_####.tga"), 2, "f_####.tga: error: expected");
    expect_refused(folder, render("folder/"), 2, "folder/: error: expected");
    expect_refused(folder, {"sheet", "paper/corner", "-o", "s.png"}, 1, "s.png: cannot write: ");
    expect_refused(folder, {"sheet", "paper/corner", "-o", "s.jpg"}, 2, ".png");
    expect_refused(folder, {"export", "paper/corner", "-o", "burn.usda"}, 1,
                   "burn.usda: cannot write: ");
    expect_refused(folder, {"export", "paper/corner", "-o", "file/b_##.ply"}, 1,
                   "file: cannot create: ");
    expect_refused(folder, {"export", "paper/corner", "-o", "burn.abc"}, 2, ".usda");
}

TEST(HostileOutputs, WithoutRoomTheFramesBeforeStay) {
    const TemporaryFolder folder;
    // no file may be larger than some kilobytes: a lone frame fits, the film does not
    const std::string command = "cd '" + folder.path().string() + "' && ulimit -f 100 && " +
                                EMBERLEAF_BINARY + " render paper/corner -o f_#.png -o film.mkv";
    const ToolResult result = run_tool(command + " --frames 0..30 --size 96x64 -q");
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.out.find("film.mkv"), std::string::npos) << result.out;
    EXPECT_EQ(folder.files().count("film.mkv"), 0u);
    EXPECT_EQ(folder.files().count("f_0.png"), 1u);
    for (const std::string& name : folder.files())
        EXPECT_EQ(read_image(folder / name).width, 96) << name << " is whole";
}

TEST(HostileOutputs, APictureThatDoesNotFitIsNotLeftInHalf) {
    const TemporaryFolder folder;
    const ToolResult result =
        run_tool("cd '" + folder.path().string() + "' && ulimit -f 20 && " + EMBERLEAF_BINARY +
                 " render paper/corner -o f_#.png --frames 0 --size 640x480 -q");
    EXPECT_EQ(result.status >> 8, 1) << result.out;
    EXPECT_NE(result.out.find("f_0.png: cannot write: File too large"), std::string::npos)
        << result.out;
    EXPECT_EQ(folder.files(), std::set<std::string>());
}

TEST(HostileOutputs, AReaderThatGoesAwayIsAFailedRun) {
    const ToolResult result = run_tool(
        "bash -c '" EMBERLEAF_BINARY
        " render paper/corner -o - --frames 0..300 --size 320x240 -q | head -c 10 >/dev/null;"
        " exit ${PIPESTATUS[0]}'");
    EXPECT_EQ(result.status >> 8, 1);
    EXPECT_EQ(result.out, "error: standard output: Broken pipe\n");
}

TEST(HostileOutputs, AFileThatIsThereIsReplacedOnlyByAWholeOne) {
    const TemporaryFolder folder;
    folder.write("film.mp4", "an older film");
    const ChildResult result =
        run_emberleaf({"render", "paper/corner", "-o", "film.mp4", "--frames", "0..9"},
                      {folder.path(), {"PATH=/nowhere"}, {}, 0});
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(folder.read("film.mp4"), "an older film");
}

TEST(HostileOutputs, WhatAKilledRunHasLeftIsRemovedByTheNext) {
    const TemporaryFolder folder;
    const std::string host = run_tool("uname -n").out;
    const std::string mark = ".tmp-" + host.substr(0, host.size() - 1) + '-';
    folder.write(".f_0000" + mark + "999999999.png", "half");  // no process has that number
    folder.write(".other" + mark + "1.png", "of one that runs");
    folder.write(".f_0000.tmp-elsewhere-999999999.png", "of another machine");
    Words words = render("f_####.png");
    words.insert(words.end(), kSmall.begin(), kSmall.end());
    ASSERT_EQ(run_emberleaf(words, {folder.path(), {}, {}, 0}).code, 0);
    const auto files = folder.files();
    EXPECT_EQ(files.count(".f_0000" + mark + "999999999.png"), 0u);
    EXPECT_EQ(files.count(".other" + mark + "1.png"), 1u);
    EXPECT_EQ(files.count(".f_0000.tmp-elsewhere-999999999.png"), 1u);
}

}  // namespace
}  // namespace ember
