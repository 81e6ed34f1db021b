// The one table of keys.
#include <gtest/gtest.h>

#include <set>

#include "ui/bindings.h"

namespace ember {
namespace {

constexpr int kEscape = 256, kSpace = 32, kRight = 262;  // GLFW_KEY_*

TEST(Bindings, NoKeyHasTwoMeanings) {
    std::set<std::pair<int, bool>> keys;
    for (const KeyBinding& binding : key_bindings()) {
        EXPECT_TRUE(keys.insert({binding.key, binding.control}).second) << binding.name;
        EXPECT_EQ(find_binding(binding.key, binding.control), &binding) << binding.name;
        EXPECT_STRNE(binding.text, "");
    }
    EXPECT_GE(keys.size(), 12u);
}

TEST(Bindings, OnlyControlQQuitsAndEscapeNeverDoes) {
    for (const KeyBinding& binding : key_bindings()) {
        if (binding.action != Action::Quit) continue;
        EXPECT_EQ(binding.key, 'Q');
        EXPECT_TRUE(binding.control);
    }
    ASSERT_NE(find_binding('Q', true), nullptr);
    EXPECT_EQ(find_binding('Q', false), nullptr);
    ASSERT_NE(find_binding(kEscape, false), nullptr);
    EXPECT_EQ(find_binding(kEscape, false)->action, Action::Cancel);
}

TEST(Bindings, AHeldKeyRepeatsStepsButNeverToggles) {
    EXPECT_NE(find_binding(kRight, false, true), nullptr);
    EXPECT_NE(find_binding(kSpace, false, false), nullptr);
    EXPECT_EQ(find_binding(kSpace, false, true), nullptr);
}

TEST(Bindings, NoDragHasTwoMeanings) {
    for (const DragBinding& binding : drag_bindings()) {
        EXPECT_EQ(find_drag(binding.button, binding.shift, binding.control), binding.drag)
            << binding.name;
    }
    EXPECT_FALSE(find_drag(1, true, true).has_value());
}

}  // namespace
}  // namespace ember
