// Edits in mid-burn: [[events]] of a preset, and back.
#include "app/preset_io/steering.h"

#include "preset_rig.h"
#include "sim/lighter.h"

namespace ember {
namespace {

TEST(Steering, EventsOfAPresetBecomeAScriptInOrder) {
    const TemporaryFolder folder;
    const Loaded loaded = load(folder.write("p.toml",
                                            "schema = 1\n[[events]]\ntick = 90\n"
                                            "set = [\"paper.c_s=0.01\"]\n[[events]]\n"
                                            "tick = 40\nset = [\"wind.x=0.5\", "
                                            "\"paper.grammage=0.1 kg/m^2\"]\n"));
    ASSERT_TRUE(loaded.result.ok());
    std::vector<Diagnostic> problems;
    const Params base = loaded.values.params;
    const auto script = script_of(base, loaded.result.info, problems);
    EXPECT_TRUE(problems.empty());
    ASSERT_EQ(script.size(), 2u);
    EXPECT_EQ(script[0].tick, 40u);
    EXPECT_DOUBLE_EQ(script[0].params.paper.grammage, 0.1);
    EXPECT_EQ(script[0].params.paper.c_s, base.paper.c_s);
    EXPECT_EQ(script[1].params.wind.x, 0.5) << "what was set stays set";
    EXPECT_EQ(script[1].params.paper.c_s, 0.01);
}

TEST(Steering, AScriptSurvivesBeingWrittenAndRead) {
    Params base;
    std::vector<TimedParams> script{{3, base}, {17, base}, {90, base}};
    script[0].params.paper.grammage = 0.0923;
    script[1].params = script[0].params;
    script[1].params.lighters = {{}, {}};  // a second lighter
    LighterParams second;
    second.x = 0.0123;
    set_lighter(script[1].params, 1, second);
    script[2].params = script[1].params;
    set_lighter(script[2].params, 1, LighterParams());
    script[2].params.hand.on = true;
    const TemporaryFolder folder;
    Everything everything{base, {}};
    const PresetInfo info{"steered", "", {}, {}, {}, events_of(base, script)};
    const Loaded loaded = load(folder.write("shot.take", preset_text(everything.bindings(), info)));
    std::vector<Diagnostic> problems;
    const auto again = script_of(loaded.values.params, loaded.result.info, problems);
    EXPECT_TRUE(problems.empty());
    ASSERT_EQ(again.size(), script.size());
    for (std::size_t i = 0; i < script.size(); ++i) {
        EXPECT_EQ(again[i].tick, script[i].tick);
        EXPECT_EQ(again[i].params.paper.grammage, script[i].params.paper.grammage);
        EXPECT_EQ(again[i].params.hand.on, script[i].params.hand.on);
        const auto lighters = lighters_of(again[i].params);
        ASSERT_EQ(lighters.size(), lighters_of(script[i].params).size());
        EXPECT_EQ(lighters.back().x, lighters_of(script[i].params).back().x);
    }
}

TEST(Steering, ProblemsAreReportedWhereTheyStand) {
    EXPECT_EQ(problems("schema = 1\nevents = 3\n"),
              "p.toml:2:10: error: events: expected tables [[events]], one for each\n");
    const std::string incomplete = problems("schema = 1\n[[events]]\ntick = -1\nset = []\n");
    EXPECT_EQ(incomplete.find("p.toml:2:1: error: events: expected tick = 120 and set = ["), 0u)
        << incomplete;
    const TemporaryFolder folder;
    const Loaded loaded = load(folder.write("p.toml",
                                            "schema = 1\n[[events]]\ntick = 5\n"
                                            "set = [\"sheet.rows=20\", \"wind.q=1\"]\n"));
    ASSERT_TRUE(loaded.result.ok());
    std::vector<Diagnostic> found;
    const auto script = script_of(loaded.values.params, loaded.result.info, found);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].key, "wind.q");
    EXPECT_EQ(found[0].line, 2);
    EXPECT_EQ(found[1].message, "changes a parameter that restarts the scene");
    ASSERT_EQ(script.size(), 1u);
    EXPECT_EQ(script[0].params.sheet.rows, loaded.values.params.sheet.rows);
}

}  // namespace
}  // namespace ember
