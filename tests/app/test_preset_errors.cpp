// Bad presets: what is wrong, where it stands, and what was probably meant.
#include "preset_rig.h"

namespace ember {
namespace {

TEST(PresetErrors, AGoodPresetHasNone) {
    EXPECT_EQ(problems("schema = 1\n[paper]\ngrammage = 80\n"), "");
}

TEST(PresetErrors, AnUnknownKeyIsNamedWithItsPlaceAndTheNearestKey) {
    EXPECT_EQ(problems("schema = 1\n[paper]\ngramage = 80\n"),
              "p.toml:3:1: error: paper.gramage: unknown key; did you mean paper.grammage?\n");
    EXPECT_EQ(problems("schema = 1\n[papre]\ngrammage = 80\n"),
              "p.toml:3:1: error: papre.grammage: unknown key; did you mean paper.grammage?\n");
    EXPECT_EQ(problems("schema = 1\n[sheet]\n  grammage = 80\n"),
              "p.toml:3:3: error: sheet.grammage: unknown key; did you mean paper.grammage?\n");
    EXPECT_EQ(problems("schema = 1\n[paper]\nxylophone_quartet = 1\n"),
              "p.toml:3:1: error: paper.xylophone_quartet: unknown key\n");
    EXPECT_EQ(problems("schema = 1\ngrammage = 80\n"),
              "p.toml:2:1: error: grammage: unknown key; did you mean paper.grammage?\n");
    EXPECT_EQ(problems("schema = 1\n[nothing_like_it]\n"),
              "p.toml:2:2: error: nothing_like_it: unknown key\n");
}

TEST(PresetErrors, LettersBeyondAsciiStandInStringsAndCommentsOnly) {
    const auto refused = [](const std::string& preset, const std::string& place,
                            const std::string& letter) {
        EXPECT_EQ(problems("schema = 1\n" + preset),
                  "p.toml:" + place + ": error: \"" + letter +
                      "\" can stand in strings and comments only\n");
    };
    refused("[paper]\ngrammage =\u00a080\n", "3:11", "\u00a0");
    refused("[wind]\nx\u00e9 = 2\n", "3:2", "\u00e9");
    refused("title = \"\u00e9\" \u00e9\n", "2:13", "\u00e9");
    refused("title = '''\n\u00e9\n''''' \u20ac\n", "4:7", "\u20ac");
    refused("title = \"\\\"\u00e9\" # \u00e9\n\u20ac\n", "3:1", "\u20ac");
    refused("title = \"\n\u00e9\n", "3:1", "\u00e9");
    EXPECT_EQ(problems("schema = 1\ntitle = 0\"\u00e9\"\n"),
              "p.toml:2:10: error: a string cannot begin here\n");
    EXPECT_EQ(problems("schema = 1\ntitle = \"a\" 'b' # \u00e9\n"),
              "p.toml:2:13: error: a string cannot begin here\n");
    EXPECT_EQ(problems("\xEF\xBB\xBFschema = 1 # \u00e9\ntitle = \"\u00e9\\\"\u00e9\"\n"
                       "description = \"\"\"\n\u00e9 \"\u00e9\" \\\"\"\"\u00e9\"\"\"\n[paper]\n"),
              "");
}

TEST(PresetErrors, AWrongTypeSaysWhatWasExpectedAndWhatWasFound) {
    EXPECT_EQ(problems("schema = 1\n[paper]\ngrammage = true\n"),
              "p.toml:3:12: error: paper.grammage: expected a number from 5 to 5000 g/m^2, got "
              "true\n");
    EXPECT_EQ(problems("schema = 1\n[lighter]\non = 1\n"),
              "p.toml:3:6: error: lighter.on: expected true or false, got 1\n");
    EXPECT_EQ(problems("schema = 1\n[sheet]\nborder = \"uniforn\"\n"),
              "p.toml:3:10: error: sheet.border: expected one of tributary, uniform, got "
              "\"uniforn\"\n");
    EXPECT_EQ(problems("schema = 1\n[sheet]\nborder = 1\n"),
              "p.toml:3:10: error: sheet.border: expected one of tributary, uniform, got 1\n");
    EXPECT_EQ(problems("schema = 1\n[paper]\ngrammage = [80]\n"),
              "p.toml:3:12: error: paper.grammage: expected a number from 5 to 5000 g/m^2, got "
              "array\n");
    EXPECT_EQ(problems("schema = 1\ntitle = 3\n"), "p.toml:2:9: error: title: expected a string\n");
}

TEST(PresetErrors, AnUnknownPlaceIsNamedWithTheNearestOne) {
    const std::string names =
        "expected one or a list of none, main_start, main_end, cross_start, cross_end, "
        "both_main_ends, both_cross_ends, corner_main_start_cross_start, "
        "corner_main_start_cross_end, corner_main_end_cross_start, corner_main_end_cross_end, got ";
    EXPECT_EQ(
        problems("schema = 1\n[sheet]\nheld = \"main_strat\"\n"),
        "p.toml:3:8: error: sheet.held: " + names + "\"main_strat\"; did you mean main_start?\n");
    EXPECT_EQ(problems("schema = 1\n[sheet]\nheld = [\"main_start\", \"everywhere_at_once\"]\n"),
              "p.toml:3:8: error: sheet.held: " + names + "\"everywhere_at_once\"\n");
    EXPECT_EQ(problems("schema = 1\n[sheet]\nheld = [3]\n"),
              "p.toml:3:8: error: sheet.held: " + names + "3\n");
}

TEST(PresetErrors, AnIntegerMustBeWhole) {
    EXPECT_NE(problems("schema = 1\n[sheet]\nrows = 32.5\n")
                  .find("p.toml:3:8: error: sheet.rows: expected a whole number from "),
              std::string::npos);
    EXPECT_EQ(problems("schema = 1\n[sheet]\nrows = 32.0\n"), "");
}

TEST(PresetErrors, OutsideTheHardRangeIsAnErrorOutsideTheTestedOneAWarning) {
    EXPECT_EQ(problems("schema = 1\n[paper]\ngrammage = 5001\n"),
              "p.toml:3:12: error: paper.grammage: expected a number from 5 to 5000 g/m^2, got "
              "5001\n");
    const std::string warning = problems("schema = 1\n[paper]\ngrammage = 5000\n");
    EXPECT_EQ(warning.find("p.toml:3:12: warning: paper.grammage: outside what has been tried"),
              0u);
}

TEST(PresetErrors, NanIsRefusedAndInfinityOnlyWhereTheRangeReachesIt) {
    EXPECT_NE(problems("schema = 1\n[paper]\ngrammage = nan\n").find(", got nan\n"),
              std::string::npos);
    EXPECT_NE(problems("schema = 1\n[paper]\ngrammage = inf\n").find(", got inf\n"),
              std::string::npos);
    EXPECT_EQ(problems("schema = 1\n[fracture]\nthreshold = inf\n").find("error"),
              std::string::npos);
    EXPECT_NE(problems("schema = 1\n[fracture]\nthreshold = nan\n").find("error"),
              std::string::npos);
}

TEST(PresetErrors, TheSchemaIsRequiredAndMustBeKnown) {
    EXPECT_EQ(problems("[paper]\ngrammage = 80\n"),
              "p.toml:1:1: error: schema: missing; write 'schema = 1' at the top\n");
    EXPECT_EQ(problems("schema = 2\n"),
              "p.toml:1:10: error: schema: this preset is newer than this program, which reads "
              "schema 1\n");
    EXPECT_EQ(problems("schema = \"1\"\n"), "p.toml:1:10: error: schema: expected 1\n");
    EXPECT_EQ(problems("schema = 0\n"), "p.toml:1:10: error: schema: expected 1\n");
}

TEST(PresetErrors, SyntaxErrorsAndDuplicatesHaveAPlaceToo) {
    EXPECT_EQ(problems("schema = 1\n[paper]\ngrammage 80\n").find("p.toml:3:10: error: "), 0u);
    EXPECT_EQ(problems("schema = 1\n[|paper]\n").find("p.toml:2:2: error: "), 0u);
    const std::string twice = problems("schema = 1\n[paper]\ngrammage = 80\ngrammage = 81\n");
    EXPECT_EQ(twice.find("p.toml:4:"), 0u) << twice;
}

TEST(PresetErrors, AllAreReportedAtOnceFromTopToBottom) {
    const std::string text = problems(
        "title = 1\n"
        "[springs]\n"
        "diagonal = \"much\"\n"
        "[paper]\n"
        "zzz = 1\n"
        "density = -1\n"
        "grammage = nan\n");
    std::istringstream lines(text);
    std::string line;
    std::vector<std::string> starts;
    while (std::getline(lines, line))
        starts.push_back(line.substr(0, line.find(": error")));
    EXPECT_EQ(starts, (std::vector<std::string>{"p.toml:1:1", "p.toml:1:9", "p.toml:3:12",
                                                "p.toml:5:1", "p.toml:6:11", "p.toml:7:12"}))
        << text;
}

TEST(PresetErrors, FilesThatAreNoPresetsAreRefused) {
    const TemporaryFolder folder;
    EXPECT_EQ(problems(folder, "missing.toml"), "missing.toml: error: No such file or directory\n");
    std::filesystem::create_directory(folder / "folder.toml");
    EXPECT_NE(problems(folder, "folder.toml").find("folder.toml: error: "), std::string::npos);
    folder.write("large.toml", "schema = 1\n#" + std::string(1 << 20, 'x'));
    EXPECT_EQ(problems(folder, "large.toml"),
              "large.toml: error: larger than 1 MiB, which no preset is\n");
}

TEST(PresetErrors, TheExcerptPointsAtTheProblem) {
    const TemporaryFolder folder;
    const auto path = folder.write("p.toml", "schema = 1\n[paper]\n\tgrammage = true # ü\n");
    const PresetResult result = load(path).result;
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].excerpt(), "    \tgrammage = true # ü\n    \t           ^");
}

}  // namespace
}  // namespace ember
