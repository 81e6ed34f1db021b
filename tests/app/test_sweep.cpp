// Sweeps: what is varied, and results that do not depend on how the work was divided.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/contact_sheet.h"
#include "app/exit_code.h"
#include "app/sweep_plan.h"
#include "child.h"
#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;
using Values = std::vector<std::string>;

TEST(SweepPlan, ListsAndRangesBecomeValues) {
    EXPECT_EQ(parse_axis("paper.grammage=60,80").values, (Values{"60", "80"}));
    EXPECT_EQ(parse_axis("a.b=1..2:5").values, (Values{"1", "1.25", "1.5", "1.75", "2"}));
    EXPECT_EQ(parse_axis("a.b=1e-4..1e-2:log:3").values, (Values{"0.0001", "0.001", "0.01"}));
    EXPECT_EQ(parse_axis("a.b=2..-2:3").values, (Values{"2", "0", "-2"}));
    EXPECT_EQ(parse_axis("a.b=\"5 %\",x").values, (Values{"\"5 %\"", "x"}));
    for (const char* bad : {"", "a", "a=", "=1", "a=1..2", "a=1..2:1", "a=0..2:log:3", "a=1..2:x",
                            "a=1,,2", "a=..2:3", "a=1..2:log"}) {
        EXPECT_THROW(static_cast<void>(parse_axis(bad)), InputError) << bad;
    }
}

TEST(SweepPlan, TheLastAxisChangesFastest) {
    const auto cases = sweep_cases({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
    ASSERT_EQ(cases.size(), 6u);
    EXPECT_EQ(cases[1], (SweepCase{{"a", "1"}, {"b", "y"}}));
    EXPECT_EQ(cases[3], (SweepCase{{"a", "2"}, {"b", "x"}}));
    EXPECT_THROW(static_cast<void>(sweep_cases({{"a", {"1"}}, {"a", {"2"}}})), InputError);
}

TEST(SweepPlan, SharesAreDisjointAndComplete) {
    for (long i = 0; i < 20; ++i) {
        int owners = 0;
        for (int k = 1; k <= 3; ++k)
            owners += parse_share(std::to_string(k) + "/3").has(i) ? 1 : 0;
        EXPECT_EQ(owners, 1);
    }
    for (const char* bad : {"", "1", "0/2", "3/2", "1/0", "-1/2", "a/b", "1/2/3"})
        EXPECT_THROW(static_cast<void>(parse_share(bad)), InputError) << bad;
}

TEST(ContactSheet, HasACellAndALabelForEachPicture) {
    Image red{40, 20, {}};
    for (int i = 0; i < 40 * 20; ++i)
        red.rgba.insert(red.rgba.end(), {255, 0, 0, 255});
    const std::vector<LabelledPicture> pictures(3, {red, "a 1"});
    const Image sheet = contact_sheet(pictures, 2);
    const auto count = [&](auto matches) {
        long n = 0;
        for (std::size_t p = 0; p < sheet.rgba.size(); p += 4)
            n += matches(&sheet.rgba[p]) ? 1 : 0;
        return n;
    };
    EXPECT_GE(sheet.width, 80);
    EXPECT_EQ(count([](const auto* p) { return p[0] == 255 && p[1] == 0; }), 3 * 40 * 20);
    EXPECT_GT(count([](const auto* p) { return p[0] == 225 && p[1] == 225; }), 3 * 2 * 10)
        << "letters";
    EXPECT_EQ(count([](const auto* p) { return p[3] != 255; }), 0);
}

const Words kSweep = {"sweep",  "paper/corner",
                      "--set",  "sheet.rows=12",
                      "--set",  "sheet.columns=18",
                      "--size", "64x48",
                      "--at",   "1.5",
                      "--vary", "burning.burn_speed=1,2",
                      "--vary", "numerics.seed=1..3:3",
                      "-o",     "s.png"};

ChildResult sweep(const TemporaryFolder& folder, const Words& more) {
    Words words = kSweep;
    words.insert(words.end(), more.begin(), more.end());
    return run_emberleaf(words, {folder.path(), {}, {}, 0});
}

TEST(Sweep, WritesASheetATableAndAPicturePerCase) {
    const TemporaryFolder folder;
    const ChildResult result = sweep(folder, {});
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(folder.files().size(), 3u + 6u) << "sheet, table, folder and six cases";
    std::istringstream table(folder.read("s.csv"));
    std::string line;
    std::getline(table, line);
    EXPECT_EQ(line.find("case,picture,burning.burn_speed,numerics.seed,time_s,outcome,unburnt"), 0u)
        << line;
    std::set<std::string> hashes;
    int rows = 0;
    for (; std::getline(table, line); ++rows) {
        EXPECT_NE(line.find(",1.5,ok,"), std::string::npos) << line;
        hashes.insert(line.substr(line.rfind(',')));
    }
    EXPECT_EQ(rows, 6);
    EXPECT_EQ(hashes.size(), 6u) << "no two cases are the same";
    const Image sheet = read_image(folder / "s.png");
    EXPECT_GT(sheet.width, 3 * 64);
    EXPECT_GT(sheet.height, 2 * 48);
}

// GNU parallel runs the shares, as docs/FARM.md has it.
TEST(Sweep, SharesMakeTheSameSheetAsOneRun) {
    const TemporaryFolder whole, shares;
    ASSERT_EQ(sweep(whole, {"-q"}).code, 0);
    std::string command =
        "cd '" + shares.path().string() + "' && parallel --will-cite -j 2 '" + EMBERLEAF_BINARY;
    for (const std::string& word : kSweep)
        command += ' ' + word;
    const ToolResult result = run_tool(command + " --jobs 1 -q --array {}/4' ::: 1 2 3 4");
    ASSERT_EQ(result.status, 0) << result.out;
    EXPECT_EQ(shares.files(), whole.files());
    for (const std::string& name : whole.files()) {
        if (std::filesystem::is_regular_file(whole / name)) {
            EXPECT_EQ(shares.read(name), whole.read(name)) << name;
        }
    }
}

TEST(Sweep, GoesOnWithWhatIsMissingAndMakesAnewWhatHasChanged) {
    const TemporaryFolder folder;
    ASSERT_EQ(sweep(folder, {"-q"}).code, 0);
    const std::string table = folder.read("s.csv");
    const auto kept = std::filesystem::last_write_time(folder / "s_cases/case_0001.png");
    std::filesystem::remove(folder / "s_cases/case_0003.png");
    const std::string half = folder.read("s_cases/case_0005.png");
    folder.write("s_cases/case_0005.png", half.substr(0, half.size() / 2));
    ASSERT_EQ(sweep(folder, {"-q"}).code, 0);
    EXPECT_EQ(folder.read("s.csv"), table);
    EXPECT_EQ(folder.read("s_cases/case_0005.png"), half);
    EXPECT_EQ(std::filesystem::last_write_time(folder / "s_cases/case_0001.png"), kept);
    ASSERT_EQ(sweep(folder, {"-q", "--set", "paper.grammage=70"}).code, 0);
    EXPECT_NE(folder.read("s.csv"), table);
}

}  // namespace
}  // namespace ember
