// Presets that are changed where they stand.
#include "app/preset_io/preset_edit.h"

#include <fstream>
#include <random>
#include <sstream>

#include "preset_rig.h"

namespace ember {
namespace {

TEST(PresetEdit, OnlyTheBytesOfTheValueChange) {
    const std::string text =
        "# mine \u00e4\nschema = 1\n\n[paper]\n  grammage = 80.0   # g/m2, keep me\n"
        "density=1500\n\n[lighter]\npath = [[0, 1, 2, 3],\n  [1, 2, 3, 4]]  # two\nx = 3\n";
    EXPECT_EQ(edited_preset(text, {{"paper.grammage", "400"}}),
              "# mine \u00e4\nschema = 1\n\n[paper]\n  grammage = 400   # g/m2, keep me\n"
              "density=1500\n\n[lighter]\npath = [[0, 1, 2, 3],\n  [1, 2, 3, 4]]  # two\nx = 3\n");
    EXPECT_EQ(edited_preset(text, {{"lighter.path", "[]"}, {"lighter.x", "-7"}}),
              "# mine \u00e4\nschema = 1\n\n[paper]\n  grammage = 80.0   # g/m2, keep me\n"
              "density=1500\n\n[lighter]\npath = []  # two\nx = -7\n");
}

TEST(PresetEdit, NewKeysGoToTheEndOfTheirTable) {
    EXPECT_EQ(edited_preset("schema = 1\n[paper]\n# why\nc_s = 1e-3\n\n# next\n[wind]\nx = 1",
                            {{"paper.grammage", "90"}, {"wind.y", "2"}, {"heat.ambient", "3"}}),
              "schema = 1\n[paper]\n# why\nc_s = 1e-3\ngrammage = 90\n\n# next\n[wind]\nx = 1\n"
              "y = 2\n\n[heat]\nambient = 3\n");
}

TEST(PresetEdit, ElementsOfListsAreChangedAndAdded) {
    EXPECT_EQ(edited_preset("schema = 1\n[[lighters]]\nx = 1 # a\n[[lighters]]\ny = 2\n",
                            {{"lighters.1.x", "5"}, {"lighters.2.x", "6"}, {"lighters.3.z", "7"}}),
              "schema = 1\n[[lighters]]\nx = 5 # a\n[[lighters]]\ny = 2\nx = 6\n"
              "\n[[lighters]]\nz = 7\n");
    EXPECT_THROW(static_cast<void>(edited_preset("schema = 1\n", {{"lighters.2.x", "1"}})),
                 std::runtime_error);
    EXPECT_THROW(static_cast<void>(edited_preset("schema = \n", {{"paper.c_s", "1"}})),
                 std::runtime_error);
}

// Changes some values of every preset that we ship, writes them into its text and reads it again.
TEST(PresetEdit, EveryShippedPresetReadsBackAsItWasMeant) {
    std::mt19937 random(7);
    const TemporaryFolder folder;
    std::size_t seen = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(EMBERLEAF_SOURCE "/presets")) {
        if (entry.path().extension() != ".toml") continue;
        ++seen;
        Loaded saved = load(entry.path());
        Loaded now = load(entry.path());
        for (const ParamBinding& binding : now.values.bindings()) {
            for (const ParamInfo& row : binding.rows) {
                if (row.kind != ParamKind::Real || random() % 8 != 0) continue;
                const double share = 0.25 * static_cast<double>(random() % 4);
                row.set_shown(binding.object,
                              row.tested.min + share * (row.tested.max - row.tested.min));
            }
        }
        bool complete = false;
        const auto changes =
            changes_between(saved.values.bindings(), now.values.bindings(), complete);
        EXPECT_TRUE(complete);
        EXPECT_GT(changes.size(), 0u);
        std::ifstream in(entry.path());
        std::ostringstream text;
        text << in.rdbuf();
        std::string edited = edited_preset(text.str(), changes);
        const std::size_t parent = edited.find("inherits = \"");  // seen from another folder
        if (parent != std::string::npos) {
            const std::string family = entry.path().parent_path().filename().string();
            if (edited.compare(parent + 12, 3, "../") == 0)
                edited.erase(parent + 12, 3);
            else
                edited.insert(parent + 12, family + "/");
        }
        const Loaded again = load(folder.write("p.toml", edited));
        ASSERT_TRUE(again.result.ok()) << entry.path() << again.result.diagnostics[0].text();
        Loaded copy = again;
        const auto left = changes_between(copy.values.bindings(), now.values.bindings(), complete);
        EXPECT_TRUE(left.empty()) << entry.path() << ' ' << left[0].key << ' ' << left[0].value;
    }
    EXPECT_GT(seen, 10u);
}

}  // namespace
}  // namespace ember
