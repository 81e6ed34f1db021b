// The goldens themselves, without drawing anything: complete, small, worth looking at, and each
// told from every other.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "golden/verdict.h"

namespace ember::golden {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = EMBERLEAF_SOURCE;

std::vector<Scene> all_scenes() {
    return read_scenes(kSource / "tests/golden/scenes.txt");
}

ApprovedFolder approved() {
    return ApprovedFolder(kSource / "tests/golden/approved");
}

TEST(Goldens, EveryPresetHasThreeFramesAndEveryViewIsShown) {
    std::map<std::string, std::set<std::uint64_t>> frames;
    std::set<std::string> words;
    for (const Scene& scene : all_scenes()) {
        words.insert(scene.words.begin(), scene.words.end());
        if (!scene.panels() && scene.words.empty()) frames[scene.preset].insert(scene.tick);
    }
    for (const auto& entry : fs::recursive_directory_iterator(kSource / "presets")) {
        if (entry.path().extension() != ".toml") continue;
        const auto name = entry.path().lexically_relative(kSource / "presets").replace_extension();
        EXPECT_GE(frames[name.generic_string()].size(), 3u) << name;
    }
    for (const char* view : {"lattice", "temperature", "mass", "state", "stress", "stiffness"})
        EXPECT_EQ(words.count(std::string("view.mode=") + view), 1u) << view;
}

TEST(Goldens, NothingIsMissingAndNothingIsLeftOver) {
    std::set<std::string> wanted;
    std::map<std::string, std::set<std::string>> names;
    for (const Scene& scene : all_scenes()) {
        wanted.insert({scene.full_name() + ".png", scene.suite + ".json"});
        names[scene.suite].insert(scene.name);
    }
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(approved().path()))
        found.insert(entry.path().filename().string());
    EXPECT_EQ(found, wanted) << "remove what has no row in scenes.txt; approve what has one";
    for (const auto& [suite, rows] : names) {
        std::set<std::string> recorded;
        for (const auto& [name, golden] : approved().read(suite))
            recorded.insert(name);
        EXPECT_EQ(recorded, rows) << suite << ".json";
    }
}

TEST(Goldens, AreSmallAndShowSomething) {
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(approved().path()))
        bytes += entry.file_size();
    EXPECT_LE(bytes, 6'000'000u);
    for (const Scene& scene : all_scenes()) {
        const auto image = approved().picture(scene.full_name());
        ASSERT_TRUE(image) << scene.full_name();
        EXPECT_EQ(image->width, scene.width) << scene.full_name();
        EXPECT_EQ(image->height, scene.height) << scene.full_name();
        std::set<std::uint32_t> colours;
        for (std::size_t i = 0; i < image->rgba.size(); i += 4)
            colours.insert(std::uint32_t(image->rgba[i]) << 16 |
                           std::uint32_t(image->rgba[i + 1]) << 8 | image->rgba[i + 2]);
        EXPECT_GE(colours.size(), 64u) << scene.full_name();
    }
}

// The picture beside the file is the one whose hash is approved first.
TEST(Goldens, PicturesAreThoseThatWereApproved) {
    for (const Scene& scene : all_scenes()) {
        const auto image = approved().picture(scene.full_name());
        const Goldens goldens = approved().read(scene.suite);
        ASSERT_TRUE(image && goldens.count(scene.name) == 1) << scene.full_name();
        const Golden& golden = goldens.at(scene.name);
        ASSERT_FALSE(golden.approved.empty()) << scene.full_name();
        EXPECT_EQ(hash_of(*image), golden.approved.front().pixels) << scene.full_name();
        for (const Approval& a : golden.approved)
            EXPECT_FALSE(a.reason.empty() || a.commit.empty()) << scene.full_name();
    }
}

// Limits that take two of these for the same would take a broken picture for a good one.
TEST(Goldens, EveryPairIsToldApartByTierTwo) {
    const std::vector<Scene> scenes = all_scenes();
    std::vector<Image> images;
    for (const Scene& scene : scenes)
        images.push_back(approved().picture(scene.full_name()).value());
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        for (std::size_t k = 0; k < scenes.size(); ++k) {
            if (i == k) continue;
            ++pairs;
            EXPECT_NE(excess(compare(images[i], images[k]), close_limits(scenes[i])), "")
                << scenes[i].full_name() << " and " << scenes[k].full_name();
        }
    }
    EXPECT_GT(pairs, 8000u);
}

}  // namespace
}  // namespace ember::golden
