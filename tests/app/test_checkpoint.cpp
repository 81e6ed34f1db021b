// Simulations that are saved and gone on with.
#include <gtest/gtest.h>

#include "child.h"
#include "render/image.h"
#include "temporary_folder.h"

namespace ember {
namespace {

using Words = std::vector<std::string>;

ChildResult run(const TemporaryFolder& folder, Words words, const std::string& preset) {
    words.insert(words.begin() + 1, preset);
    words.insert(words.end(), {"--set", "sheet.rows=12", "--set", "sheet.columns=18", "-q"});
    return run_emberleaf(words, {folder.path(), {}, {}, 0});
}

std::string hash_in(const ChildResult& result) {
    EXPECT_EQ(result.code, 0) << result.err;
    const std::size_t at = result.out.find("state hash: ");
    return at == std::string::npos ? "no hash" : result.out.substr(at, 28);
}

TEST(Checkpoint, ASavedSimulationGoesOnToTheSameBits) {
    for (const std::string preset : {"paper/corner", "paper/stack", "scenes/leaf", "real/office"}) {
        SCOPED_TRACE(preset);
        const TemporaryFolder folder;
        const std::string whole = hash_in(run(folder, {"simulate", "--seconds", "1.5"}, preset));
        ASSERT_EQ(
            run(folder, {"simulate", "--seconds", "1", "--save", "s_#.state", "--at", "0.5,1"},
                preset)
                .code,
            0);
        for (const char* file : {"s_0.state", "s_1.state"}) {
            EXPECT_EQ(
                hash_in(run(folder,
                            {"simulate", "--seconds", "1.5", "--resume", file, "--threads", "3"},
                            preset)),
                whole);
        }
    }
}

// A share of a farm draws its frames from the state before them.
TEST(Checkpoint, FramesFromASavedStateAreTheSame) {
    const TemporaryFolder folder;
    const Words frames = {"--frames", "30..33", "--fps", "25", "--size", "64x48"};
    const auto draw = [&](Words more) {
        more.insert(more.begin(), "render");
        more.insert(more.end(), frames.begin(), frames.end());
        return run(folder, more, "paper/corner");
    };
    ASSERT_EQ(
        run(folder, {"simulate", "--seconds", "1", "--save", "one.state"}, "paper/corner").code, 0);
    ASSERT_EQ(draw({"-o", "a_##.png"}).code, 0);
    ASSERT_EQ(draw({"-o", "b_##.png", "--resume", "one.state", "--threads", "3"}).code, 0);
    for (const char* number : {"30", "31", "33"})
        EXPECT_EQ(folder.read(std::string("a_") + number + ".png"),
                  folder.read(std::string("b_") + number + ".png"));
}

TEST(Checkpoint, WhatCannotBeGoneOnWithIsRefused) {
    const TemporaryFolder folder;
    ASSERT_EQ(
        run(folder, {"simulate", "--seconds", "0.5", "--save", "s.state"}, "paper/corner").code, 0);
    const std::string bytes = folder.read("s.state");
    folder.write("half.state", bytes.substr(0, bytes.size() / 2));
    folder.write("text.state", "no state");
    std::string wrong = bytes;
    wrong[wrong.size() / 2] ^= 1;
    folder.write("wrong.state", wrong);
    const auto refused = [&](Words words, const std::string& because) {
        const ChildResult result = run(folder, words, "paper/corner");
        EXPECT_EQ(result.code, 2);
        EXPECT_NE(result.err.find(because), std::string::npos) << result.err;
    };
    refused({"simulate", "--resume", "missing.state"}, "missing.state: No such file");
    refused({"simulate", "--resume", "half.state"}, "half.state: the file is not whole");
    refused({"simulate", "--resume", "text.state"}, "text.state: not a saved simulation");
    refused({"simulate", "--resume", "wrong.state"}, "wrong.state: ");
    refused({"simulate", "--resume", "s.state", "--seed", "5"}, "other parameters");
    refused({"render", "-o", "f.png", "--frames", "0", "--resume", "s.state"},
            "after the first picture");
    EXPECT_EQ(run(folder,
                  {"render", "-o", "f.png", "--frames", "20", "--size", "32x32", "--resume",
                   "s.state", "--view", "temperature"},
                  "paper/corner")
                  .code,
              0)
        << "how it is looked at may be another";
}

}  // namespace
}  // namespace ember
