// The one table of keys.
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <tuple>

#include "ui/bindings.h"

namespace ember {
namespace {

constexpr int kEscape = 256, kSpace = 32, kRight = 262;  // GLFW_KEY_*

TEST(Bindings, NoKeyHasTwoMeanings) {
    std::set<std::tuple<int, bool, bool>> keys;
    for (const KeyBinding& b : key_bindings()) {
        EXPECT_STRNE(b.text, "");
        if (b.key == 0) {
            EXPECT_STRNE(b.menu, "") << b.text << " can be reached";
            continue;
        }
        EXPECT_TRUE(keys.insert({b.key, b.control, b.shift}).second) << b.name;
        EXPECT_EQ(find_binding(b.key, b.control, b.shift), &b) << b.name;
    }
    EXPECT_GE(keys.size(), 50u);
}

TEST(Bindings, EveryActionHasARowAndRowsOfOneActionStandTogether) {
    std::set<Action> seen;
    Action last = Action::Cancel;
    for (const KeyBinding& b : key_bindings()) {
        if (b.action == last) continue;
        EXPECT_TRUE(seen.insert(b.action).second) << b.text;
        last = b.action;
    }
    EXPECT_EQ(seen.size(), static_cast<std::size_t>(Action::Cancel) + 1);
    EXPECT_EQ(binding_of(Action::Quit).key, 'Q');
}

TEST(Bindings, OnlyControlQQuitsAndEscapeNeverDoes) {
    for (const KeyBinding& b : key_bindings()) {
        if (b.action != Action::Quit) continue;
        EXPECT_EQ(b.key, 'Q');
        EXPECT_TRUE(b.control);
    }
    ASSERT_NE(find_binding('Q', true, false), nullptr);
    EXPECT_EQ(find_binding('Q', false, false), nullptr);
    ASSERT_NE(find_binding(kEscape, false, false), nullptr);
    EXPECT_EQ(find_binding(kEscape, false, false)->action, Action::Cancel);
}

TEST(Bindings, AHeldKeyRepeatsStepsButNeverToggles) {
    EXPECT_NE(find_binding(kRight, false, false, true), nullptr);
    EXPECT_NE(find_binding(kSpace, false, false, false), nullptr);
    EXPECT_EQ(find_binding(kSpace, false, false, true), nullptr);
}

TEST(Bindings, NoDragHasTwoMeaningsAndEverySchemeTurnsTheCamera) {
    for (const CameraScheme scheme :
         {CameraScheme::Viewer, CameraScheme::Blender, CameraScheme::Maya}) {
        std::set<Drag> drags;
        for (const DragBinding& b : drag_bindings()) {
            if (!in_scheme(b, scheme)) continue;
            drags.insert(b.drag);
            EXPECT_EQ(find_drag(scheme, b.button, b.shift, b.control, b.alt), b.drag) << b.name;
        }
        for (const Drag drag :
             {Drag::Orbit, Drag::Pan, Drag::PlaceLighter, Drag::Ignite, Drag::Touch, Drag::Blow})
            EXPECT_TRUE(drags.contains(drag));
    }
    EXPECT_FALSE(find_drag(CameraScheme::Viewer, 1, true, true, true).has_value());
}

TEST(Bindings, TheManualIsFresh) {
    std::ifstream in(EMBERLEAF_SOURCE "/docs/WINDOW.md");
    std::ostringstream text;
    text << in.rdbuf();
    EXPECT_EQ(text.str(), bindings_markdown())
        << "update it: ./run --list-bindings > docs/WINDOW.md";
}

}  // namespace
}  // namespace ember
