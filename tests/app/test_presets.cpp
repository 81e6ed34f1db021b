// Good presets: units, inheritance, overrides, round trips, and those that we ship.
#include <algorithm>
#include <cmath>
#include <random>

#include "app/preset_io/parameter_value.h"
#include "preset_rig.h"

namespace ember {
namespace {

double grammage_of(const std::string& value) {
    const TemporaryFolder folder;
    const Loaded loaded =
        load(folder.write("p.toml", "schema = 1\n[paper]\ngrammage = " + value + '\n'));
    EXPECT_TRUE(loaded.result.ok()) << value;
    return loaded.values.params.paper.grammage;
}

// The field values of both tables, in SI.
std::vector<ParamValue> values(Everything& everything) {
    std::vector<ParamValue> list;
    for (const ParamBinding& binding : everything.bindings()) {
        for (const ParamInfo& row : binding.rows)
            list.push_back(row.value(binding.object));
    }
    return list;
}

void expect_round_trip(Everything& everything) {
    const TemporaryFolder folder;
    const auto path =
        folder.write("again.toml", preset_text(everything.bindings(), {"A \"title\"", "", {}, {}}));
    Loaded again = load(path);
    ASSERT_TRUE(again.result.ok()) << again.result.diagnostics.front().text();
    EXPECT_EQ(again.result.info.title, "A \"title\"");
    const std::vector<ParamValue> before = values(everything), after = values(again.values);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_TRUE(before[i] == after[i]) << "value " << i << ", to the last bit";
    EXPECT_TRUE(everything.params.sheets == again.values.params.sheets);
    EXPECT_TRUE(everything.params.lighters == again.values.params.lighters);
}

TEST(Presets, ABareNumberIsInTheShownUnitAndAStringCarriesItsOwn) {
    EXPECT_EQ(grammage_of("80"), 0.080);
    EXPECT_EQ(grammage_of("80.0"), 0.080);
    EXPECT_EQ(grammage_of("\"80 g/m^2\""), 0.080);
    EXPECT_EQ(grammage_of("\"0.08 kg/m^2\""), 0.080);
    EXPECT_EQ(grammage_of("\"0.08kg/m^2\""), 0.080);
    EXPECT_EQ(grammage_of("\"5 kg/m^2\""), 5.0) << "the end of the range, through a conversion";
}

TEST(Presets, TemperaturesHaveAnOffset) {
    Everything e;
    EXPECT_TRUE(apply_override("heat.ambient=20", e.bindings()).empty());
    EXPECT_DOUBLE_EQ(e.params.heat.ambient, 293.15);
    EXPECT_TRUE(apply_override("heat.ambient=\"300 K\"", e.bindings()).empty());
    EXPECT_DOUBLE_EQ(e.params.heat.ambient, 300.0);
    EXPECT_TRUE(apply_override("paper.density=1.5 g/cm^3", e.bindings()).empty());
    EXPECT_DOUBLE_EQ(e.params.paper.density, 1500.0);
}

TEST(Presets, AUnitOfAnotherKindIsRefusedAndThoseThatFitAreListed) {
    Everything e;
    for (const std::string value : {"80 mm", "80 g", "g/m^2", "80 g/m^2 x", "80 kg/m^3"}) {
        const auto problems = apply_override("paper.grammage=" + value, e.bindings());
        ASSERT_EQ(problems.size(), 1u) << value;
        EXPECT_EQ(problems[0].severity, Diagnostic::Severity::Error);
        EXPECT_EQ(problems[0].text().find("--set: error: paper.grammage: expected a number"), 0u);
    }
    const auto problems = apply_override("paper.grammage=80 mm", e.bindings());
    EXPECT_NE(problems[0].message.find("units that fit: g/m^2, kg/m^2"), std::string::npos);
    EXPECT_EQ(e.params.paper.grammage, Params().paper.grammage) << "unchanged";
}

TEST(Presets, EveryRowAcceptsItsRangeAndNothingBeyond) {
    Everything e;
    for (const ParamBinding& binding : e.bindings()) {
        for (const ParamInfo& row : binding.rows) {
            if (row.kind != ParamKind::Real && row.kind != ParamKind::Integer) continue;
            SCOPED_TRACE(std::string(row.key));
            for (const double end : {row.hard.min, row.hard.max}) {
                EXPECT_EQ(parse_value(row, PresetValue(end)).error, "");
            }
            const double span = std::isfinite(row.hard.max) ? row.hard.max - row.hard.min : 1;
            EXPECT_NE(parse_value(row, PresetValue(row.hard.min - span)).error, "");
            if (std::isfinite(row.hard.max)) {
                EXPECT_NE(parse_value(row, PresetValue(row.hard.max + span)).error, "");
            }
            EXPECT_NE(parse_value(row, PresetValue(std::nan(""))).error, "");
            EXPECT_TRUE(row.hard.contains(row.shown(binding.object))) << "the default";
        }
    }
}

TEST(Presets, OverridesTakeBareWordsAndTomlValues) {
    Everything e;
    EXPECT_TRUE(apply_override("sheet.border=uniform", e.bindings()).empty());
    EXPECT_EQ(e.params.sheet.border, Border::Uniform);
    EXPECT_TRUE(apply_override("sheet.border=\"tributary\"", e.bindings()).empty());
    EXPECT_EQ(e.params.sheet.border, Border::Tributary);
    EXPECT_TRUE(apply_override("lighter.on=false", e.bindings()).empty());
    EXPECT_FALSE(e.params.lighter.on);
    EXPECT_TRUE(apply_override("view.mode=lattice", e.bindings()).empty());
    EXPECT_EQ(e.render.view.mode, ViewMode::Lattice);
    EXPECT_EQ(apply_override("lighter.on", e.bindings()).at(0).text(),
              "--set: error: lighter.on: expected key=value");
    EXPECT_EQ(apply_override("lighter.om=true", e.bindings(), "--flag").at(0).text(),
              "--flag: error: lighter.om: unknown key; did you mean lighter.on?");
    EXPECT_FALSE(apply_override("lighter.on=yes\nx=1", e.bindings()).empty());
}

TEST(Presets, PlacesAreOneNameOrAList) {
    const auto held = [](const std::string& value) {
        const TemporaryFolder folder;
        const auto path = folder.write("p.toml", "schema = 1\n[sheet]\nheld = " + value + "\n");
        return load(path).values.params.sheet.held;
    };
    EXPECT_EQ(held("\"main_end\""), HeldEdge::MainEnd);
    EXPECT_EQ(held("\"none\""), HeldEdge::None);
    EXPECT_EQ(held("[]"), HeldEdge::None);
    EXPECT_EQ(held("[\"main_start\", \"main_end\"]"), HeldEdge::BothMainEnds);
    EXPECT_EQ(held("[\"both_cross_ends\", \"corner_main_end_cross_start\", \"cross_start\"]"),
              HeldEdge::BothCrossEnds | HeldEdge::CornerMainEndCrossStart);
    Everything e;
    EXPECT_TRUE(apply_override("sheet.held=both_cross_ends", e.bindings()).empty());
    EXPECT_TRUE(apply_override("sheet.held=[\"main_start\", \"cross_end\"]", e.bindings()).empty());
    EXPECT_EQ(e.params.sheet.held, HeldEdge::MainStart | HeldEdge::CrossEnd);
    const ParamInfo& row = *find_param(sim_param_rows(), "sheet.held");
    EXPECT_EQ(value_text(row, &e.params), "[\"main_start\", \"cross_end\"]");
    e.params.sheet.held = HeldEdge::CrossStart | HeldEdge::CrossEnd;
    EXPECT_EQ(value_text(row, &e.params), "\"both_cross_ends\"");
}

TEST(Presets, AChildOverridesWhatItInherits) {
    const TemporaryFolder folder;
    folder.write("base.toml",
                 "schema = 1\ntitle = \"Base\"\n[paper]\ngrammage = 100\nc_s = 3e-4\n");
    folder.write("sub/child.toml", "schema = 1\ninherits = \"../base\"\n[paper]\ngrammage = 120\n");
    folder.write("sub/with.toml", "schema = 1\ninherits = \"../base.toml\"\n");
    folder.write("third.toml", "schema = 1\ntitle = \"Third\"\ninherits = \"sub/child\"\n");
    const Loaded third = load(folder / "third.toml");
    EXPECT_EQ(problems(folder, "third.toml"), "");
    EXPECT_EQ(third.values.params.paper.grammage, 0.120);
    EXPECT_EQ(third.values.params.paper.c_s, 3e-4);
    EXPECT_EQ(third.result.info.title, "Third");
    EXPECT_EQ(third.result.info.chain.size(), 3u);
    EXPECT_EQ(load(folder / "sub/with.toml").values.params.paper.grammage, 0.100);
    folder.write("built_in.toml", "schema = 1\ninherits = \"bench/swing\"\n");
    EXPECT_EQ(load(folder / "built_in.toml").values.params.sheet.rows, 31);
}

TEST(Presets, InheritanceThatCannotBeFollowedIsAnError) {
    const TemporaryFolder folder;
    folder.write("self.toml", "schema = 1\ninherits = \"self\"\n");
    EXPECT_EQ(problems(folder, "self.toml"),
              "self.toml:2:12: error: inherits: \"self\" leads back to itself\n");
    folder.write("a.toml", "schema = 1\ninherits = \"b\"\n");
    folder.write("b.toml", "schema = 1\ninherits = \"a.toml\"\n");
    EXPECT_EQ(problems(folder, "a.toml"),
              "b.toml:2:12: error: inherits: \"a.toml\" leads back to itself\n");
    folder.write("orphan.toml", "schema = 1\ninherits = \"nobody\"\n");
    EXPECT_EQ(problems(folder, "orphan.toml"),
              "orphan.toml:2:12: error: inherits: no preset \"nobody\"\n");
    folder.write("typed.toml", "schema = 1\ninherits = 3\n");
    EXPECT_NE(problems(folder, "typed.toml").find("typed.toml:2:12: error: inherits: "),
              std::string::npos);
    folder.write("bad.toml", "schema = 1\n[paper]\nzzzzzzzz = 1\n");
    folder.write("heir.toml", "schema = 1\ninherits = \"bad\"\n");
    EXPECT_EQ(problems(folder, "heir.toml"), "bad.toml:3:1: error: paper.zzzzzzzz: unknown key\n");
}

TEST(Presets, TheTextOfAPresetReadsBackToTheSameBits) {
    Everything defaults;
    expect_round_trip(defaults);
    std::mt19937_64 random(7);  // raw bits only: those are the same everywhere
    for (int trial = 0; trial < 40; ++trial) {
        Everything e;
        for (const ParamBinding& binding : e.bindings()) {
            for (const ParamInfo& row : binding.rows) {
                const double share = static_cast<double>(random() >> 11) * 0x1p-53;
                if (!row.is_number()) continue;
                const double max = std::min(row.hard.max, row.hard.min + 1e6);
                double shown = row.hard.min + share * (max - row.hard.min);
                if (row.kind != ParamKind::Real) shown = std::floor(shown);
                row.set_shown(binding.object, shown);
            }
        }
        expect_round_trip(e);
    }
}

TEST(ShippedPresets, PassTheCheckAndReadBack) {
    int count = 0;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(EMBERLEAF_SOURCE "/presets")) {
        if (entry.path().extension() != ".toml") continue;
        SCOPED_TRACE(entry.path().string());
        Loaded loaded = load(entry.path());
        for (const Diagnostic& d : loaded.result.diagnostics) {
            EXPECT_EQ(d.severity, Diagnostic::Severity::Warning) << d.text();
        }
        EXPECT_FALSE(loaded.result.info.title.empty());
        EXPECT_FALSE(loaded.result.info.description.empty());
        expect_round_trip(loaded.values);
        ++count;
    }
    EXPECT_GE(count, 2);
}

TEST(ShippedPresets, SwingIsTheSharedBenchmark) {
    const Loaded loaded = load(EMBERLEAF_SOURCE "/presets/bench/swing.toml");
    const Params& p = loaded.values.params;
    EXPECT_EQ(p.sheet.rows, 31);
    EXPECT_EQ(p.sheet.columns, 47);
    EXPECT_EQ(p.sheet.width, 0.2034375);
    EXPECT_EQ(p.sheet.height, 0.2908125);
    EXPECT_EQ(p.sheet.border, Border::Uniform);
    EXPECT_EQ(p.sheet.pose, SheetPose::Horizontal);
    EXPECT_EQ(p.sheet.imperfection, 0.0);
    EXPECT_EQ(p.paper.grammage, 0.080);
    EXPECT_EQ(p.springs.stiffness_scale, 1.0);
    EXPECT_EQ(p.springs.stiffness_law, StiffnessLaw::PerNodeMass);
    EXPECT_EQ(p.springs.variation, 0.0);
    EXPECT_EQ(p.springs.damping, 5.0);
    EXPECT_EQ(p.world.gravity * p.world.held_gravity, 9.81);
    EXPECT_EQ(p.world.air_drag, 0.0);
    EXPECT_FALSE(p.lighter.on);
}

TEST(Documents, ParametersMdIsFresh) {
    Everything e;
    std::istringstream fresh(parameters_markdown(e.bindings()));
    std::ifstream file(EMBERLEAF_SOURCE "/docs/PARAMETERS.md");
    ASSERT_TRUE(file);
    std::string expected, found;
    while (std::getline(fresh, expected)) {
        std::getline(file, found);
        ASSERT_EQ(found, expected) << "update it: ./run params --markdown > docs/PARAMETERS.md";
    }
    EXPECT_FALSE(std::getline(file, found)) << "more than there should be";
}

}  // namespace
}  // namespace ember
