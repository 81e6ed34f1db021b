// Scenes as presets say them: several sheets and lighters, outlines, and scenes that cannot be.
#include <algorithm>
#include <chrono>

#include "app/preset_io/mask_file.h"
#include "app/preset_io/parameter_value.h"
#include "child.h"
#include "preset_rig.h"
#include "render/image.h"
#include "sim/lighter.h"

namespace ember {
namespace {

const std::string kTwo =
    "schema = 1\n[sheet]\nrows = 20\ncolumns = 30\n"
    "[[sheets]]\nname = \"left\"\nx = -200\n"
    "[[sheets]]\nrows = 21\nx = 0.2\nheld = [\"cross_start\", \"main_end\"]\n"
    "held_points = [[10, 20, 5], [\"3 cm\", 0, 0]]\n"
    "[[lighters]]\n[[lighters]]\nstart = 2\npath = [[0, 1, 2, 3], [1.5, -4, 5.5, 6]]\n";

TEST(Scenes, ListsOfTablesAreSheetsAndLighters) {
    const TemporaryFolder folder;
    Loaded loaded = load(folder.write("p.toml", kTwo));
    EXPECT_EQ(problems(folder, "p.toml"), "");
    const std::vector<SheetParams> sheets = sheets_of(loaded.values.params);
    ASSERT_EQ(sheets.size(), 2u);
    EXPECT_EQ(sheets[0].rows, 20);
    EXPECT_EQ(sheets[0].name, "left");
    EXPECT_EQ(sheets[1].rows, 21);
    EXPECT_EQ(sheets[1].columns, 30);
    EXPECT_EQ(sheets[1].held, HeldEdge::CrossStart | HeldEdge::MainEnd);
    ASSERT_EQ(sheets[1].held_points.size(), 2u);
    EXPECT_EQ(sheets[1].held_points[0], (std::array<double, 3>{0.010, 0.020, 0.005}));
    EXPECT_EQ(sheets[1].held_points[1][0], 0.030);
    const std::vector<LighterParams> lighters = lighters_of(loaded.values.params);
    ASSERT_EQ(lighters.size(), 2u);
    EXPECT_EQ(lighters[1].start, 2.0);
    ASSERT_EQ(lighters[1].path.size(), 2u);
    EXPECT_EQ(lighters[1].path[1], (std::array<double, 4>{1.5, -0.004, 0.0055, 0.006}));
}

TEST(Scenes, ReadBackToTheSameBits) {
    const TemporaryFolder folder;
    Loaded first = load(folder.write("p.toml", kTwo));
    const std::string text = preset_text(first.values.bindings(), {});
    Loaded again = load(folder.write("again.toml", text));
    ASSERT_TRUE(again.result.ok()) << again.result.diagnostics.front().text();
    EXPECT_TRUE(again.values.params.sheets == first.values.params.sheets);
    EXPECT_TRUE(again.values.params.lighters == first.values.params.lighters);
    EXPECT_EQ(preset_text(again.values.bindings(), {}), text);
}

TEST(Scenes, OverridesCountFromOne) {
    const TemporaryFolder folder;
    Loaded loaded = load(folder.write("p.toml", kTwo));
    const std::vector<ParamBinding> bindings = loaded.values.bindings();
    EXPECT_TRUE(apply_override("sheets.2.width=100", bindings).empty());
    EXPECT_TRUE(apply_override("lighters.1.path=[[0, 1, 2, 3]]", bindings).empty());
    EXPECT_TRUE(apply_override("sheet.columns=40", bindings).empty());
    const std::vector<SheetParams> sheets = sheets_of(loaded.values.params);
    EXPECT_EQ(sheets[1].width, 0.1);
    EXPECT_EQ(sheets[0].width, 0.21);
    EXPECT_EQ(sheets[0].columns, 40) << "what all share reaches all";
    EXPECT_EQ(lighters_of(loaded.values.params)[0].path.size(), 1u);
    const auto refused = [&](const std::string& text) {
        return apply_override(text, bindings).at(0).text();
    };
    EXPECT_EQ(refused("sheets.3.width=1"),
              "--set: error: sheets.3.width: there are 2 tables [[sheets]]");
    EXPECT_EQ(refused("sheets.x.width=1"),
              "--set: error: sheets.x.width: expected sheets.NUMBER.KEY, such as sheets.1.x");
    EXPECT_EQ(refused("sheets.1.widht=1"),
              "--set: error: sheets.1.widht: unknown key; did you mean sheet.width?");
}

TEST(Scenes, AnHeirsListReplacesTheWholeList) {
    const TemporaryFolder folder;
    folder.write("p.toml", kTwo);
    folder.write("heir.toml", "schema = 1\ninherits = \"p\"\n[[sheets]]\nrows = 3\n");
    folder.write("none.toml", "schema = 1\ninherits = \"p\"\nsheets = []\n");
    Loaded heir = load(folder / "heir.toml");
    EXPECT_EQ(heir.values.params.sheets.size(), 1u);
    EXPECT_EQ(heir.values.params.lighters.size(), 2u);
    EXPECT_TRUE(load(folder / "none.toml").values.params.sheets.empty());
}

void write_mask(const std::filesystem::path& path, int width, int height, std::uint8_t grey) {
    Image image{width, height, {}};
    for (int i = 0; i < width * height; ++i)
        image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
    write_png(path, image);
}

// The first 29 bytes of a PNG that says to be large: all that may be looked at.
std::string huge_png() {
    return std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\x01\0\0\0\x01\0\0\x08\0\0\0\0", 29) +
           std::string("\0\0\0\0\0\0\0\0IEND\xae\x42\x60\x82", 16);
}

struct BadScene {
    std::string name, preset, error;
};

std::vector<BadScene> bad_scenes() {
    const std::string s = "schema = 1\n";
    return {
        {"one_pixel", s + "[sheet]\nmask = \"pixel.png\"\n",
         ":3:8: error: sheet.mask: FOLDER/pixel.png has 1 x 1 pixels, a picture needs 2 x 2"},
        {"black", s + "[sheet]\nmask = \"black.png\"\n",
         ":3:8: error: sheet.mask: FOLDER/black.png is black: there is no paper"},
        {"unreadable", s + "[sheet]\nmask = \"text.png\"\n",
         ":3:8: error: sheet.mask: FOLDER/text.png is no PNG"},
        {"missing", s + "[[sheets]]\nmask = \"gone.png\"\n",
         ":3:8: error: sheets.1.mask: there is no file FOLDER/gone.png"},
        {"absurd", s + "[sheet]\nmask = \"huge.png\"\n",
         ":3:8: error: sheet.mask: FOLDER/huge.png has 65536 x 65536 pixels, more than 8192 x "
         "8192"},
        {"outside", s + "[sheet]\nmask = \"../secret.png\"\n",
         ":3:8: error: sheet.mask: expected a file in the preset's own folder, got "
         "\"../secret.png\""},
        {"absolute", s + "[sheet]\nmask = \"/etc/secret.png\"\n",
         ":3:8: error: sheet.mask: expected a file in the preset's own folder"},
        {"print_missing", s + "[print]\nfront = \"gone.png\"\n",
         ":3:9: error: print.front: there is no file FOLDER/gone.png"},
        {"print_unreadable", s + "[print]\nback = \"text.png\"\n",
         ":3:8: error: print.back: FOLDER/text.png is no PNG"},
        {"print_outside", s + "[print]\nback = \"/etc/letter.png\"\n",
         ":3:8: error: print.back: expected a file in the preset's own folder"},
        {"no_area", s + "[sheet]\nwidth = 0\n",
         ":3:9: error: sheet.width: expected a number from 1 to 10000 mm, got 0"},
        {"lighter_at_nan", s + "[lighter]\nx = nan\n",
         ":3:5: error: lighter.x: expected a number from -5000 to 5000 mm, got nan"},
        {"lighter_at_inf", s + "[[lighters]]\npath = [[0, 1, 2, inf]]\n",
         ":3:8: error: lighters.1.path: z: expected a number from -10000 to 10000 mm, got inf"},
        {"backwards", s + "[lighter]\npath = [[1, 1, 2, 3], [1, 2, 3, 4]]\n",
         ":3:8: error: lighter.path: expected each time above the one before"},
        {"short_row", s + "[lighter]\npath = [[1, 1, 2]]\n",
         ":3:8: error: lighter.path: expected a list of [time, x, y, z] (s, mm, mm, mm), got array "
         "of 3 values"},
        {"a_billion_nodes", s + "[sheet]\ncount = 60\nrows = 4000\ncolumns = 4000\n",
         ":4:8: error: sheet.rows: more than 4096 x 4096 nodes in all, here 60 x 4001 x 4001"},
        {"in_each_other",
         s + "[sheet]\nrows = 4\ncolumns = 4\n[[sheets]]\nname = \"a\"\n[[sheets]]\n"
             "name = \"b\"\nturn_y = 30\n",
         ":7:1: error: sheets.2: \"a\" and \"b\" are in each other at the start"},
        {"unknown_edge", s + "[[sheets]]\nheld = [\"main_start\", \"main_edn\"]\n",
         "\"main_edn\"; did you mean main_end?"},
        {"tube", s + "[sheet]\nshape = \"cylinder\"\nheld = \"cross_end\"\n",
         ":4:8: error: sheet.held: a cylinder has no edges or corners but main_start and main_end"},
        {"point", s + "[sheet]\nheld_points = [[300, 0, 0]]\n",
         ":3:15: error: sheet.held_points: a point lies beyond the sheet"},
        {"no_list", s + "[sheets]\nx = 1\n",
         ":2:1: error: sheets: expected tables [[sheets]], one for each"},
    };
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(Scenes, EachBadSceneGivesOneClearLineAndExitsWithTwo) {
    const TemporaryFolder folder;
    write_mask(folder / "pixel.png", 1, 1, 255);
    write_mask(folder / "black.png", 9, 9, 0);
    folder.write("text.png", "no picture at all");
    folder.write("huge.png", huge_png());
    for (const BadScene& bad : bad_scenes()) {
        SCOPED_TRACE(bad.name);
        const auto path = folder.write(bad.name + ".toml", bad.preset);
        const ChildResult result =
            run_emberleaf({"simulate", path.string(), "--seconds", "1", "--stats", "s.json"},
                          {folder.path(), {}, {}, 0});
        EXPECT_EQ(result.code, 2);
        const std::string first = result.err.substr(0, result.err.find('\n'));
        EXPECT_EQ(first.find(path.string() + ':'), 0u) << result.err;
        const std::string expected = replaced(bad.error, "FOLDER", folder.path().string());
        EXPECT_NE(first.find(expected), std::string::npos) << first << "\nis not\n" << expected;
        std::size_t errors = 0;
        for (std::size_t at = result.err.find(": error: "); at != std::string::npos;
             at = result.err.find(": error: ", at + 1))
            ++errors;
        EXPECT_EQ(errors, 1u) << result.err;
        EXPECT_EQ(run_emberleaf({"check", path.string()}).code, 2);
    }
    EXPECT_EQ(folder.files().count("s.json"), 0u);
}

TEST(Scenes, AMaskIsFoundBesideThePresetThatSaysItAndBurns) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "sub");
    Image image{4, 4, std::vector<std::uint8_t>(64, 255)};
    std::fill_n(image.rgba.begin(), 12, std::uint8_t{0});  // three black pixels of the first line
    write_png(folder / "sub/m.png", image);
    folder.write("sub/base.toml", "schema = 1\n[sheet]\nrows = 4\ncolumns = 4\nmask = \"m.png\"\n");
    const auto heir = folder.write("heir.toml", "schema = 1\ninherits = \"sub/base\"\n");
    Loaded loaded = load(heir);
    ASSERT_TRUE(read_masks(loaded.values.params, loaded.result.info).empty());
    const Scene scene = make_scene(loaded.values.params);
    EXPECT_EQ(std::count(scene.sheets[0].paper.begin(), scene.sheets[0].paper.end(), 1), 13);
    const ChildResult run =
        run_emberleaf({"simulate", heir.string(), "--seconds", "0.1", "-q", "--state", "s.ply"},
                      {folder.path(), {}, {}, 0});
    EXPECT_EQ(run.code, 0) << run.err;
    const std::string ply = folder.read("s.ply");
    EXPECT_NE(ply.find("element face 13\n"), std::string::npos);
    EXPECT_NE(ply.find("element vertex 22\n"), std::string::npos) << "25 sites, 3 without paper";
}

}  // namespace
}  // namespace ember
