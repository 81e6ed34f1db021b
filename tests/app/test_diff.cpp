// emberleaf diff: what it says, writes and ends with.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/difference_report.h"
#include "child.h"
#include "render/image.h"
#include "temporary_folder.h"

namespace ember {
namespace {

using Json = nlohmann::json;

Image grey(std::uint8_t level) {
    return {40, 30, std::vector<std::uint8_t>(std::size_t{40} * 30 * 4, level)};
}

// `count` pixels of the first row are brighter by so many levels.
Image spotted(std::size_t count, int levels) {
    Image image = grey(100);
    for (std::size_t i = 0; i < 4 * count; ++i)
        image.rgba[i] = static_cast<std::uint8_t>(100 + levels);
    return image;
}

class Diff : public testing::Test {
  protected:
    void SetUp() override {
        write_png(folder_ / "a.png", grey(100), {{"Version", "1"}, {"Preset", "p"}});
        write_png(folder_ / "same.png", grey(100), {{"Version", "1"}, {"Preset", "p"}});
        write_png(folder_ / "off.png", spotted(6, 9), {{"Version", "2"}, {"Preset", "p"}});
        write_png(folder_ / "small.png", {2, 2, std::vector<std::uint8_t>(16, 7)});
    }
    ChildResult diff(std::vector<std::string> words) {
        words.insert(words.begin(), "diff");
        return run_emberleaf(words, {folder_.path(), {}, {}, 0});
    }
    // 6 of 1200 pixels, so 0.5 %, by 9 levels; the worst block has 6 * 9 / 256.
    int with(std::vector<std::string> limits) {
        limits.insert(limits.begin(), {"a.png", "off.png"});
        return diff(limits).code;
    }
    TemporaryFolder folder_;
};

TEST_F(Diff, EqualPicturesEndWithZeroAndOthersWithThree) {
    EXPECT_EQ(diff({"a.png", "same.png"}).code, 0);
    EXPECT_EQ(diff({"a.png", "same.png"}).out, "same.png: equal\n");
    const ChildResult off = diff({"a.png", "off.png"});
    EXPECT_EQ(off.code, 3);
    EXPECT_EQ(off.out,
              "off.png: DIFFERS: 6 of 1200 pixels (0.5 %) differ by more than 0 levels, 0 % may\n"
              "    made otherwise: Version (emberleaf show FILE)\n");
    const ChildResult small = diff({"a.png", "small.png"});
    EXPECT_EQ(small.code, 3);
    EXPECT_NE(small.out.find("the sizes differ: 40x30 and 2x2"), std::string::npos) << small.out;
}

TEST_F(Diff, EachLimitHoldsUpToItsValue) {
    EXPECT_EQ(with({}), 3);
    EXPECT_EQ(with({"--fail", "8"}), 3);
    EXPECT_EQ(with({"--fail", "9"}), 0);
    EXPECT_EQ(with({"--fail-percent", "0.49"}), 3);
    EXPECT_EQ(with({"--fail-percent", "0.5"}), 0);
    EXPECT_EQ(with({"--fail-percent", "1", "--hard-fail", "8"}), 3);
    EXPECT_EQ(with({"--fail-percent", "1", "--hard-fail", "9"}), 0);
    EXPECT_EQ(with({"--fail-percent", "1", "--block", "0.21"}), 3);
    EXPECT_EQ(with({"--fail-percent", "1", "--block", "0.22"}), 0);
    EXPECT_EQ(with({"--close"}), 3);
    write_png(folder_ / "off.png", spotted(6, 1));
    EXPECT_EQ(with({"--close"}), 0);
    EXPECT_EQ(with({"--close", "--fail", "3"}), 2);
}

TEST_F(Diff, WhatCannotBeReadEndsWithTwo) {
    folder_.write("broken.png", folder_.read("a.png").substr(0, 60));
    for (const char* file : {"missing.png", "broken.png", "."})
        EXPECT_EQ(diff({"a.png", file}).code, 2) << file;
    EXPECT_NE(diff({"a.png", "missing.png"}).err.find("missing.png: "), std::string::npos);
    EXPECT_EQ(diff({"missing.png", "missing.png"}).code, 2);
    EXPECT_EQ(with({"--fail", "256"}), 2);
}

TEST_F(Diff, FoldersAreComparedByNameAndNothingMayBeMissing) {
    for (const char* name : {"ref/1.png", "new/1.png", "ref/2.png", "new/3.png"})
        write_png(folder_ / name, grey(100));
    const ChildResult result = diff({"ref", "new", "--junit", "d.xml", "--html", "d.html"});
    EXPECT_EQ(result.code, 3);
    EXPECT_EQ(result.out,
              "1.png: equal\n2.png: DIFFERS: missing: was not drawn\n"
              "3.png: DIFFERS: not expected: no such reference\n2 of 3 pictures differ\n");
    const std::string xml = folder_.read("d.xml");
    EXPECT_NE(xml.find("tests=\"3\" failures=\"2\""), std::string::npos) << xml;
    EXPECT_NE(xml.find("name=\"2.png\"><failure message=\"missing"), std::string::npos) << xml;
    EXPECT_EQ(diff({"ref", "new", "-o", "d.png"}).code, 2);
    EXPECT_EQ(diff({"ref", "ref", "-q"}).out, "");
}

// Every key of `json`, those within included.
void expect_documented(const Json& json, const std::string& page) {
    for (const auto& [key, value] : json.items()) {
        if (json.is_object()) {
            EXPECT_NE(page.find('"' + key + "\":"), std::string::npos) << key;
        }
        if (value.is_structured()) expect_documented(value, page);
    }
}

TEST_F(Diff, TheJsonIsAsDocumented) {
    const Json json = Json::parse(diff({"a.png", "off.png", "--json"}).out);
    EXPECT_EQ(json.at("schema"), 1);
    EXPECT_EQ(json.at("same"), false);
    EXPECT_TRUE(json.at("limits").at("block").is_null());
    const Json& picture = json.at("pictures").at(0);
    EXPECT_EQ(picture.at("made_otherwise"), Json({"Version"}));
    EXPECT_EQ(picture.at("metrics").at("pixels_different"), 6);
    EXPECT_EQ(picture.at("metrics").at("max"), 9);
    EXPECT_DOUBLE_EQ(picture.at("metrics").at("worst_block"), 6 * 9 / 256.0);
    std::ostringstream page;
    page << std::ifstream(EMBERLEAF_SOURCE "/docs/GOLDEN.md").rdbuf();
    expect_documented(json, page.str());
    const Json equal = Json::parse(diff({"a.png", "same.png", "--json"}).out);
    EXPECT_TRUE(equal.at("pictures").at(0).at("metrics").at("psnr").is_null());
    EXPECT_EQ(equal.at("pictures").at(0).at("exact"), true);
}

TEST_F(Diff, ThePictureShowsTheDifferenceAndTheReportNeedsNothingElse) {
    EXPECT_EQ(diff({"a.png", "off.png", "-o", "d.png", "--gain", "10", "--html", "d.html"}).code,
              3);
    const Image picture = read_image(folder_ / "d.png");
    EXPECT_EQ(picture.rgba[0], 90);
    EXPECT_EQ(picture.rgba[4 * 6], 0);
    const std::string html = folder_.read("d.html");
    EXPECT_NE(html.find("6 of 1200 (0.5 %)"), std::string::npos);
    EXPECT_NE(html.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos);
    for (const char* outside : {"http:", "https:", "<script", "<link", "src=\"/", "url("})
        EXPECT_EQ(html.find(outside), std::string::npos) << outside;
}

TEST(DifferenceReport, HasEveryPanelAndEscapesWhatItIsTold) {
    const ReportEntry entry{"<b>&", "line 1\nline 2", grey(100), spotted(6, 9), {{"how", "\"x\""}}};
    const std::string html = difference_report("title", {&entry, 1});
    for (const char* part : {"expected", "drawn", "difference, 16 times", "heat map",
                             "&lt;b&gt;&amp;", "line 1\nline 2", "&quot;x&quot;", "<h1>title"})
        EXPECT_NE(html.find(part), std::string::npos) << part;
    std::size_t images = 0;
    for (std::size_t at = 0; (at = html.find("<img", at)) != std::string::npos; ++at)
        ++images;
    EXPECT_EQ(images, 5u);
}

}  // namespace
}  // namespace ember
