// One test per row of scenes.txt, named as it is. docs/GOLDEN.md says how to use it.
//
// golden [--gtest_filter=SUITE.NAME] [--as-it-is | --graphics-card] [--approved FOLDER]
//        [--report FILE]
//
// golden --update REASON [--gtest_filter=SUITE.NAME]
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>

#include "golden/runner.h"

namespace ember::golden {
namespace {

constexpr const char* kSource = EMBERLEAF_SOURCE;

struct Arguments {
    RunnerOptions runner{std::filesystem::path(kSource) / "presets",
                         std::filesystem::path(kSource) / "tests/golden/approved",
                         "golden_failures.html", Rasteriser::Pinned};
    bool update = false;
    std::string reason, commit;
};

Arguments read(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto value = [&] {
            if (i + 1 == count) throw std::runtime_error(word + ": expected a value");
            return std::string(words[++i]);
        };
        if (word == "--update") {
            arguments.update = true;
            arguments.reason = value();
        } else if (word == "--as-it-is") {
            arguments.runner.rasteriser = Rasteriser::AsItIs;
        } else if (word == "--graphics-card") {
            arguments.runner.rasteriser = Rasteriser::GraphicsCard;
        } else if (word == "--approved") {
            arguments.runner.approved = std::filesystem::absolute(value());
        } else if (word == "--report") {
            arguments.runner.report = value();
        } else {
            throw std::runtime_error(word + ": unknown");
        }
    }
    return arguments;
}

class SceneTest : public testing::Test {
  public:
    SceneTest(Runner& runner, const Arguments& arguments, Scene scene)
        : runner_(runner), arguments_(arguments), scene_(std::move(scene)) {}

    void TestBody() override {
        if (arguments_.update) {
            if (runner_.update(scene_, arguments_.reason, arguments_.commit))
                std::cout << "approved: " << scene_.full_name() << '\n';
            return;
        }
        const Verdict verdict = runner_.check(scene_);
        RecordProperty("verdict", verdict.text);
        const std::string where =
            "\nsee " + std::filesystem::absolute(runner_.options().report).string();
        if (!verdict.looks_right()) ADD_FAILURE() << verdict.text << where;
        for (const std::string& line : verdict.more_work)
            ADD_FAILURE() << "MORE WORK: " << line << where;
        // never as if it were exact: CTest and JUnit tell it apart
        if (verdict.outcome == Outcome::Close && verdict.more_work.empty())
            GTEST_SKIP() << verdict.text;
    }

  private:
    Runner& runner_;
    const Arguments& arguments_;
    Scene scene_;
};

int run(int count, char** words) {
    Arguments arguments = read(count, words);
    if (arguments.update) {
        const std::string refusal =
            update_refusal(kSource, arguments.runner.approved, std::getenv("CI"), arguments.reason);
        if (!refusal.empty()) throw std::runtime_error(refusal);
        arguments.commit = present_commit(kSource);
    }
    Runner runner(arguments.runner);
    for (const Scene& scene :
         read_scenes(std::filesystem::path(kSource) / "tests/golden/scenes.txt")) {
        testing::RegisterTest(
            scene.suite.c_str(), scene.name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
            [&, scene]() -> testing::Test* { return new SceneTest(runner, arguments, scene); });
    }
    return RUN_ALL_TESTS();
}

}  // namespace
}  // namespace ember::golden

int main(int count, char** words) {
    testing::InitGoogleTest(&count, words);
    try {
        return ember::golden::run(count, words);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "golden: error: %s\n", e.what());
        return 2;
    }
}
