// The state hash of every tick, written and compared.
#include <gtest/gtest.h>

#include <algorithm>

#include "child.h"
#include "temporary_folder.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

class Hashes : public testing::Test {
  protected:
    [[nodiscard]] ChildResult simulate(Words words) const {
        const Words all = {"simulate", "paper/corner",    "-q", "--set", "sheet.rows=12",
                           "--set",    "sheet.columns=18"};
        words.insert(words.begin(), all.begin(), all.end());
        return run_emberleaf(words, {folder_.path(), {}, {}, 0});
    }
    void SetUp() override {
        ASSERT_EQ(simulate({"--seconds", "0.5", "--hashes", "h.txt"}).code, 0);
        text_ = folder_.read("h.txt");
    }

    TemporaryFolder folder_;
    std::string text_;
};

TEST_F(Hashes, AreOneALineFromTheStartToTheEnd) {
    EXPECT_EQ(std::count(text_.begin(), text_.end(), '\n'), 1 + 31);
    EXPECT_EQ(text_.substr(0, text_.find('\n')), "tick state_hash");
    const ChildResult again = simulate({"--seconds", "0.5"});
    const std::string last = text_.substr(text_.size() - 17);
    EXPECT_EQ(again.out, "state hash: " + last) << "the last one is that of the end";
}

TEST_F(Hashes, OfTheSameBurnAreEqualOnAnyThreadsAndFromASavedState) {
    for (const char* threads : {"1", "2", "3"}) {
        const ChildResult same = simulate({"--verify", "h.txt", "--threads", threads});
        EXPECT_EQ(same.code, 0) << same.err;
        EXPECT_EQ(same.err, "");
    }
    ASSERT_EQ(simulate({"--seconds", "0.3", "--save", "s.state"}).code, 0);
    const ChildResult on = simulate({"--resume", "s.state", "--verify", "h.txt"});
    EXPECT_EQ(on.code, 0) << on.err;
}

TEST_F(Hashes, NameTheFirstTickThatDiffers) {
    std::string changed = text_;  // line 12 is tick 10
    std::size_t line = 0;
    for (int i = 0; i < 11; ++i)
        line = changed.find('\n', line) + 1;
    char& digit = changed[line + 3];
    digit = digit == '0' ? '1' : '0';
    folder_.write("changed.txt", changed);
    const ChildResult differs = simulate({"--verify", "changed.txt"});
    EXPECT_EQ(differs.code, 3);
    EXPECT_EQ(differs.err.find("changed.txt:12: tick 10 is the first that differs"), 0u)
        << differs.err;
    const ChildResult seed = simulate({"--seed", "7", "--verify", "h.txt"});
    EXPECT_EQ(seed.code, 3);
    EXPECT_NE(seed.err.find("h.txt:2: tick 0 is the first"), std::string::npos) << seed.err;
    const ChildResult longer = simulate({"--seconds", "0.6", "--verify", "h.txt"});
    EXPECT_EQ(longer.code, 3);
    EXPECT_NE(longer.err.find("h.txt: tick 31 is not in it"), std::string::npos) << longer.err;
}

TEST_F(Hashes, OfFastArithmeticAreNotComparedWithExactOnes) {
    const ChildResult fast =
        simulate({"--set", "numerics.arithmetic=fast", "--verify", "h.txt", "--seconds", "0.5"});
    EXPECT_EQ(fast.code, 3);
    EXPECT_NE(fast.err.find("of another arithmetic"), std::string::npos) << fast.err;
}

TEST_F(Hashes, ThatCannotBeReadAreRefusedWithTheirLine) {
    const auto refused = [&](const std::string& text, const std::string& why) {
        folder_.write("bad.txt", text);
        const ChildResult result = simulate({"--verify", "bad.txt"});
        EXPECT_EQ(result.code, 2);
        EXPECT_EQ(result.err.find("bad.txt:" + why), 0u) << result.err;
    };
    refused("", "1: error: not a file of state hashes");
    refused("tick state_hash\n", "1: error: no hash follows");
    refused("tick state_hash\n0 0123456789abcde\n", "2: error: expected a tick and a hash");
    refused("tick state_hash\n0 0123456789abcdex\n", "2: error: expected a tick and a hash");
    refused("tick state_hash\n0 0123456789abcdef\n2 0123456789abcdef\n",
            "3: error: expected tick 1");
    EXPECT_EQ(simulate({"--verify", "missing.txt"}).code, 2);
}

}  // namespace
}  // namespace ember
