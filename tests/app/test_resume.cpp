// What a picture says about itself, and what that is good for: shots that go on where they ended.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "child.h"
#include "render/exr_file.h"
#include "render/image.h"
#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

ChildResult draw(const TemporaryFolder& folder, Words more) {
    Words words = {"render", "paper/corner",     "--set",  "sheet.rows=12",
                   "--set",  "sheet.columns=18", "--size", "64x48",
                   "--set",  "shot.duration=1",  "--fps",  "12"};
    words.insert(words.end(), more.begin(), more.end());
    return run_emberleaf(words, {folder.path(), {}, {}, 0});
}

std::string text_of(const TemporaryFolder& folder, const std::string& name, const char* keyword) {
    const ImageText text = read_png_text(folder / name);
    const std::string* found = find_text(text, keyword);
    return found == nullptr ? "(missing)" : *found;
}

TEST(Metadata, ShowTellsHowAPictureWasMadeAndThePictureIsAPreset) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "f.png", "--frames", "6", "--seed", "9", "-q"}).code, 0);
    const ChildResult shown = run_emberleaf({"show", "f.png"}, {folder.path(), {}, {}, 0});
    EXPECT_EQ(shown.code, 0) << shown.err;
    for (const char* line : {"Seed       9\n", "Frame      6\n", "Time       0.5 s\n",
                             "Settings   64x48 msaa 4\n", "[paper]\n"}) {
        EXPECT_NE(shown.out.find(line), std::string::npos) << line << shown.out;
    }
    const ChildResult again = run_emberleaf(
        {"render", "f.png", "-o", "g.png", "--frames", "6", "--size", "64x48", "--fps", "12", "-q"},
        {folder.path(), {}, {}, 0});
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_EQ(read_image(folder / "g.png").rgba, read_image(folder / "f.png").rgba);
    EXPECT_EQ(text_of(folder, "g.png", "Hash"), text_of(folder, "f.png", "Hash"));
    EXPECT_EQ(run_emberleaf({"check", (folder / "g.png").string()}).code, 0);
    // one without a preset is refused, with a reason
    write_png(folder / "bare.png", Image{1, 1, {0, 0, 0, 0}});
    for (const Words& words : {Words{"check", "bare.png"}, {"show", "bare.png"}}) {
        const ChildResult refused = run_emberleaf(words, {folder.path(), {}, {}, 0});
        EXPECT_EQ(refused.code, 2);
        EXPECT_NE(refused.err.find("bare.png"), std::string::npos) << refused.err;
    }
}

TEST(SkipExisting, KeepsWhatIsWholeAndDrawsWhatIsNot) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "f_##.png", "-q"}).code, 0);
    const std::string whole = folder.read("f_05.png"), first = folder.read("f_00.png");
    std::filesystem::remove(folder / "f_03.png");
    folder.write("f_05.png", whole.substr(0, whole.size() - 20));
    const auto untouched = std::filesystem::last_write_time(folder / "f_00.png");
    const ChildResult result = draw(folder, {"-o", "f_##.png", "-o", "f.mkv", "--skip-existing"});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_NE(result.err.find("10 pictures are there already"), std::string::npos) << result.err;
    EXPECT_EQ(folder.read("f_05.png"), whole);
    EXPECT_EQ(folder.read("f_00.png"), first);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "f_00.png"), untouched);
    EXPECT_EQ(folder.files().count("f_03.png"), 1u);
    const ToolResult frames = run_tool(
        "ffprobe -v error -count_frames -show_entries "
        "stream=nb_read_frames -of csv=p=0 '" +
        (folder / "f.mkv").string() + '\'');
    EXPECT_EQ(frames.out, "12\n") << "the film has those that were there";
}

TEST(SkipExisting, TrustsLayersToo) {
    if (!exr_available()) GTEST_SKIP() << "built without OpenEXR";
    const TemporaryFolder folder;
    const Words words = {"-o", "f_##.exr", "--frames", "0..2", "--skip-existing"};
    ASSERT_EQ(draw(folder, words).code, 0);
    const std::string whole = folder.read("f_01.exr");
    folder.write("f_01.exr", whole.substr(0, whole.size() / 2));
    const ChildResult again = draw(folder, words);
    ASSERT_EQ(again.code, 0) << again.err;
    EXPECT_NE(again.err.find("2 pictures are there already"), std::string::npos) << again.err;
    EXPECT_EQ(folder.read("f_01.exr"), whole);
    Words other = words;
    other.insert(other.end(), {"--seed", "3"});
    EXPECT_EQ(draw(folder, other).code, 2);
}

TEST(SkipExisting, RefusesToMixSettings) {
    const TemporaryFolder folder;
    ASSERT_EQ(draw(folder, {"-o", "f_##.png", "-q", "--frames", "0..3"}).code, 0);
    const auto before = folder.files();
    for (const Words& other : {Words{"--seed", "5"},
                               {"--start", "0.1"},
                               {"--set", "paper.grammage=70"},
                               {"--msaa", "2"}}) {
        Words words = {"-o", "f_##.png", "--skip-existing", "--frames", "0..5"};
        words.insert(words.end(), other.begin(), other.end());
        const ChildResult result = draw(folder, words);
        EXPECT_EQ(result.code, 2) << result.err;
        EXPECT_NE(result.err.find("f_0"), std::string::npos) << result.err;
        EXPECT_NE(result.err.find("other settings"), std::string::npos) << result.err;
        EXPECT_EQ(folder.files(), before);
    }
}

TEST(Progress, IsALineOfJsonForOtherPrograms) {
    const TemporaryFolder folder;
    const ChildResult result =
        draw(folder, {"-o", "f_##.png", "-q", "--progress", "json", "--frames", "0..3"});
    ASSERT_EQ(result.code, 0) << result.err;
    std::istringstream lines(result.err);
    nlohmann::json last;
    for (std::string line; std::getline(lines, line);)
        last = nlohmann::json::parse(line);
    EXPECT_EQ(last.at("event"), "end");
    EXPECT_EQ(last.at("unit"), "pictures");
    EXPECT_EQ(last.at("done"), 4);
    EXPECT_EQ(last.at("total"), 4);
}

TEST(Progress, IsRedrawnOnATerminalAndSparseElsewhere) {
    const TemporaryFolder folder;
    const std::string command = std::string(EMBERLEAF_BINARY) + " render paper/corner -o " +
                                (folder / "f_##.png").string() + " --frames 0..3 --size 32x32";
    const ToolResult terminal = run_tool("script -qec '" + command + "' /dev/null");
    EXPECT_NE(terminal.out.find("\r[####################] 4/4 pictures  100 %"), std::string::npos)
        << terminal.out;
    const ChildResult lines = draw(folder, {"-o", "f_##.png", "--frames", "0..3"});
    EXPECT_EQ(lines.err.find('\r'), std::string::npos);
    EXPECT_NE(lines.err.find("4/4 pictures  100 %"), std::string::npos) << lines.err;
    EXPECT_NE(lines.err.find("simulating"), std::string::npos) << "a summary";
}

TEST(Interrupt, SaysHowToGoOn) {
    const TemporaryFolder folder;
    Words words = {"render", "paper/corner", "-o", "f_####.png", "--size", "160x120"};
    const ChildResult result =
        run_emberleaf(words, {folder.path(), {}, folder / "f_0002.png", SIGINT});
    EXPECT_EQ(result.code, 130);
    EXPECT_NE(result.err.find("--skip-existing"), std::string::npos) << result.err;
}

// By hand: tests/app/kill_and_resume build/release/emberleaf 50
TEST(Kill, AShotKilledAtAnyMomentGoesOnToTheSameFrames) {
    const ToolResult result =
        run_tool(EMBERLEAF_SOURCE "/tests/app/kill_and_resume '" EMBERLEAF_BINARY "' 4 16 64x48");
    EXPECT_EQ(result.status, 0) << result.out;
    EXPECT_NE(result.out.find("identical"), std::string::npos) << result.out;
}

}  // namespace
}  // namespace ember
