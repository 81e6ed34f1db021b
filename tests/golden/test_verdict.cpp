// How pictures are judged and approved, with pictures of a few pixels.
#include <gtest/gtest.h>

#include <cstdlib>

#include "../app/temporary_folder.h"
#include "../app/tool.h"
#include "golden/runner.h"

namespace ember::golden {
namespace {

const Environment kHere{"rasteriser 1", "sse4.1"}, kElsewhere{"rasteriser 2", "sse4.1"};

Image grey(std::uint8_t level) {
    Image image{32, 32, std::vector<std::uint8_t>(32 * 32 * 4, level)};
    return image;
}

// One pixel is off by so many levels.
Image spotted(std::uint8_t levels) {
    Image image = grey(100);
    image.rgba[4] = static_cast<std::uint8_t>(100 + levels);
    return image;
}

struct Case {
    Scene scene{"suite", "name", "paper/corner", 60, 32, 32, 0, 0, {}};
    Drawn drawn{1, 2, grey(100), kHere, {{"substeps", 10}, {"render.fragments", 50}}};
    Golden golden = approve(drawn, Verdict{}, nullptr, "first", "c0ffee");
    Image expected = grey(100);
    [[nodiscard]] Verdict verdict() const { return judge(scene, drawn, &golden, &expected); }
};

TEST(Verdict, AnApprovedPictureIsExact) {
    const Case same;
    EXPECT_EQ(same.verdict().outcome, Outcome::Exact);
    EXPECT_TRUE(same.verdict().good());
}

TEST(Verdict, OneLevelInOnePixelIsTheRenderersFaultWhereThePictureIsApproved) {
    Case off;
    off.drawn.image = spotted(1);
    const Verdict verdict = off.verdict();
    EXPECT_EQ(verdict.outcome, Outcome::Renderer);
    EXPECT_NE(verdict.text.find("RENDERER"), std::string::npos);
    EXPECT_NE(verdict.text.find("1 of 1024 pixels"), std::string::npos) << verdict.text;
}

TEST(Verdict, TierTwoCountsOnlyInAnotherEnvironmentAndSaysSo) {
    Case off;
    off.drawn.image = spotted(1);
    off.drawn.environment = kElsewhere;
    EXPECT_EQ(off.verdict().outcome, Outcome::Close);
    EXPECT_NE(off.verdict().text.find("TIER 2 ONLY"), std::string::npos);
    off.drawn.image = spotted(3);
    EXPECT_EQ(off.verdict().outcome, Outcome::Renderer) << "more pixels than 0.01 % by more than 2";
    off.drawn.image = grey(101);
    EXPECT_EQ(off.verdict().outcome, Outcome::Renderer) << "every block is off by a level";
    off.drawn.image = grey(100);
    EXPECT_EQ(off.verdict().outcome, Outcome::Exact);
}

TEST(Verdict, AnotherStateIsTheSolversFaultWhateverThePicture) {
    Case off;
    off.drawn.state = 3;
    EXPECT_EQ(off.verdict().outcome, Outcome::Solver);
    EXPECT_NE(off.verdict().text.find("from the same parameters"), std::string::npos);
    off.drawn.image = grey(7);
    EXPECT_EQ(off.verdict().outcome, Outcome::Solver);
    off.drawn.environment = kElsewhere;
    EXPECT_EQ(off.verdict().outcome, Outcome::Solver);
    off.drawn.parameters = 9;
    EXPECT_NE(off.verdict().text.find("look at the preset first"), std::string::npos);
}

TEST(Verdict, AMissingGoldenIsAFailure) {
    const Case none;
    EXPECT_EQ(judge(none.scene, none.drawn, nullptr, &none.expected).outcome, Outcome::Missing);
    EXPECT_EQ(judge(none.scene, none.drawn, &none.golden, nullptr).outcome, Outcome::Missing);
    EXPECT_FALSE(judge(none.scene, none.drawn, nullptr, nullptr).good());
}

TEST(Verdict, MoreWorkIsAFailureAndLessIsNot) {
    Case more;
    more.drawn.work[0].second = 11;
    EXPECT_EQ(more.verdict().outcome, Outcome::Exact);
    EXPECT_FALSE(more.verdict().good());
    ASSERT_EQ(more.verdict().more_work.size(), 1u);
    EXPECT_EQ(more.verdict().more_work[0], "substeps: 11, recorded 10 (+10 %)");
    more.drawn.work[0].second = 9;
    EXPECT_TRUE(more.verdict().good());
    more.drawn.work.emplace_back("new_counter", 1);
    EXPECT_FALSE(more.verdict().good());
    more.drawn.work.back() = {"rows_asleep", 100};
    EXPECT_TRUE(more.verdict().good()) << "sleep is no work";
    more.drawn.work[1].second = 60;
    EXPECT_FALSE(more.verdict().good());
    more.drawn.environment = kElsewhere;
    EXPECT_TRUE(more.verdict().good()) << "another rasteriser shades otherwise";
}

TEST(Approve, KeepsOtherEnvironmentsOnlyOfTheSameDrawing) {
    Case close;
    close.drawn.image = spotted(1);
    close.drawn.environment = kElsewhere;
    const Golden both = approve(close.drawn, close.verdict(), &close.golden, "another Mesa", "c1");
    ASSERT_EQ(both.approved.size(), 2u);
    EXPECT_EQ(both.approved[0].environment, kHere);
    EXPECT_EQ(judge(close.scene, close.drawn, &both, &close.expected).outcome, Outcome::Exact);
    EXPECT_EQ(approve(close.drawn, judge(close.scene, close.drawn, &both, &close.expected), &both,
                      "again", "c2")
                  .approved.size(),
              2u);
    close.drawn.image = grey(50);
    const Golden fresh = approve(close.drawn, close.verdict(), &both, "darker", "c3");
    ASSERT_EQ(fresh.approved.size(), 1u) << "what was approved elsewhere is of the old drawing";
    EXPECT_EQ(fresh.approved[0].reason, "darker");
}

TEST(Approved, AreReadAsTheyWereWrittenAndDamageIsSaid) {
    const TemporaryFolder folder;
    const ApprovedFolder approved(folder.path());
    EXPECT_TRUE(approved.read("suite").empty());
    const Case some;
    approved.write("suite", {{"name", some.golden}});
    const Golden back = approved.read("suite").at("name");
    EXPECT_EQ(back.state, some.golden.state);
    EXPECT_EQ(back.work, some.golden.work);
    EXPECT_EQ(back.approved.at(0).environment, kHere);
    EXPECT_EQ(back.approved.at(0).pixels, some.golden.approved.at(0).pixels);
    folder.write("suite.json", "{\"schema\": 1");
    EXPECT_THROW(static_cast<void>(approved.read("suite")), std::runtime_error);
}

TEST(Update, IsRefusedInCiWithoutAReasonAndOnADirtyTree) {
    const TemporaryFolder folder;
    const auto approved = folder / "goldens";
    const auto refusal = [&](const char* ci, const char* reason) {
        return update_refusal(folder.path(), approved, ci, reason);
    };
    EXPECT_NE(refusal(nullptr, "why"), "") << "no repository";
    const std::string git = "git -C '" + folder.path().string() + "' ";
    ASSERT_EQ(run_tool(git + "init -q && " + git +
                       "-c user.name=a -c user.email=a@b commit -q "
                       "--allow-empty -m first")
                  .status,
              0);
    EXPECT_EQ(refusal(nullptr, "why"), "");
    EXPECT_EQ(refusal("false", "why"), "");
    EXPECT_NE(refusal("true", "why"), "");
    EXPECT_NE(refusal(nullptr, " "), "");
    folder.write("goldens/a.png", "changed");
    EXPECT_EQ(refusal(nullptr, "why"), "") << "goldens themselves may be dirty";
    folder.write("shader.frag", "changed");
    EXPECT_NE(refusal(nullptr, "why").find("shader.frag"), std::string::npos);
    EXPECT_EQ(present_commit(folder.path()).size(), 9u);
}

TEST(Scenes, SayWhereARowIsWrong) {
    const TemporaryFolder folder;
    const auto problem = [&](const std::string& rows) -> std::string {
        try {
            return std::to_string(read_scenes(folder.write("s.txt", "# rows\n" + rows)).size());
        } catch (const std::runtime_error& e) {
            return std::string(e.what()).substr((folder / "s.txt").string().size());
        }
    };
    EXPECT_EQ(problem("a.1 p/q 1 20x10 view.mode=mass\na.2 p/q 2 20x10\n"), "2");
    EXPECT_EQ(problem("a.1 p/q\n"), ":2: expected SUITE.NAME PRESET TICK SIZE [WORDS]");
    EXPECT_EQ(problem("a p/q 1 20x10\n"), ":2: a: expected SUITE.NAME of letters, digits and _");
    EXPECT_NE(problem("a.1 p/q 1 481x10\n").find("at most 480x270"), std::string::npos);
    EXPECT_NE(problem("a.1 p/q 1 20x10\na.1 p/q 1 20x10\n").find(":3: a.1 comes twice"),
              std::string::npos);
    EXPECT_NE(problem("a.1 p/q 1 20x10\na.2 p/r 2 20x10\n").find("two presets"), std::string::npos);
    EXPECT_NE(problem("a.1 p/q 2 20x10\na.2 p/q 1 20x10\n").find("ascend"), std::string::npos);
    EXPECT_NE(problem("panels.a p/q 2 20x10\n").find("+LEFT+TOP"), std::string::npos);
}

}  // namespace
}  // namespace ember::golden
