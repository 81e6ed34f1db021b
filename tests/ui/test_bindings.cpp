// The one table of keys.
#include <gtest/gtest.h>

#include <set>

#include "ui/bindings.h"

namespace ember {
namespace {

constexpr int kEscape = 256;  // GLFW_KEY_ESCAPE

TEST(Bindings, NoKeyHasTwoMeaningsAndEscapeHasNone) {
    std::set<std::pair<int, bool>> keys;
    for (const Binding& binding : bindings()) {
        EXPECT_TRUE(keys.insert({binding.key, binding.control}).second) << binding.keys;
        EXPECT_EQ(action_of(binding.key, binding.control), binding.action) << binding.keys;
        EXPECT_STRNE(binding.text, "");
        EXPECT_NE(binding.key, kEscape);
    }
    EXPECT_FALSE(action_of(kEscape, false).has_value());
    EXPECT_FALSE(action_of('Q', false).has_value()) << "only Ctrl+Q quits";
}

}  // namespace
}  // namespace ember
