// The program where it is installed, with the folder that it was built from out of reach.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "temporary_folder.h"
#include "tool.h"

namespace ember {
namespace {

namespace fs = std::filesystem;

const std::string kSource = EMBERLEAF_SOURCE;

std::size_t built_in_count() {
    std::size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kSource + "/presets"))
        count += entry.path().extension() == ".toml" ? 1u : 0u;
    return count;
}

// An installation as a test can look at it.
class Installed : public testing::Test {
  protected:
    void install() {
        expect_good("cmake --install " EMBERLEAF_BUILD " --prefix '" + prefix() + '\'');
    }
    [[nodiscard]] std::string prefix() const { return (folder_ / "usr").string(); }

    static std::string expect_good(const std::string& command) {
        const ToolResult result = run_tool(command);
        EXPECT_EQ(result.status, 0) << command << '\n' << result.out;
        return result.out;
    }
    // Makes every mention of the source folder in the program one of a folder that does not exist.
    void forget_the_source() {
        std::string program = folder_.read("usr/bin/emberleaf");
        const std::string nowhere = '/' + std::string(kSource.size() - 1, 'x');
        for (std::size_t at = 0; (at = program.find(kSource, at)) != std::string::npos;)
            program.replace(at, kSource.size(), nowhere);
        folder_.write("usr/bin/emberleaf", program);
    }
    // What a shell says in an empty folder, where emberleaf is the installed one.
    std::string say(const std::string& script) const {
        fs::create_directories(folder_ / "here");
        folder_.write("script.sh", script);
        return expect_good("cd '" + (folder_ / "here").string() + "' && env -i HOME=/ PATH='" +
                           prefix() + "/bin:/usr/bin:/bin' bash -e '" +
                           (folder_ / "script.sh").string() + '\'');
    }
    // Presets, their pictures, shaders and textures are all there.
    void expect_it_works() const {
        const std::string presets = say("emberleaf presets");
        EXPECT_EQ(static_cast<std::size_t>(std::count(presets.begin(), presets.end(), '\n')),
                  built_in_count())
            << presets;
        EXPECT_EQ(say("emberleaf check scenes/letter"), "scenes/letter: ok\n");
        say("emberleaf render scenes/letter -o letter.png --at 0 --size 160x90 -q");
        EXPECT_GT(fs::file_size(folder_ / "here/letter.png"), 5000u);
        EXPECT_NE(say("emberleaf show letter.png").find("scenes/letter.toml"), std::string::npos);
    }
    TemporaryFolder folder_;
};

TEST_F(Installed, RunsWithoutTheSource) {
    install();
    forget_the_source();
    expect_it_works();
    for (const char* file : {"share/man/man1/emberleaf.1", "share/doc/emberleaf/copyright",
                             "share/doc/emberleaf/GOLDEN.md", "share/emberleaf/presets/README.md",
                             "share/bash-completion/completions/emberleaf"})
        EXPECT_TRUE(fs::exists(folder_ / "usr" / file)) << file;
}

TEST_F(Installed, PrefersThePresetsBesideIt) {
    install();
    const std::string name = "usr/share/emberleaf/presets/paper/corner.toml";
    folder_.write(name, std::regex_replace(folder_.read(name), std::regex("title = \"[^\"]*\""),
                                           "title = \"a studio's own corner\""));
    EXPECT_NE(say("emberleaf presets").find("a studio's own corner"), std::string::npos);
}

TEST_F(Installed, APackageHasWhatItNeedsAndRunsWhereItIsUnpacked) {
    expect_good("cd '" + folder_.path().string() + "' && cpack -G DEB -B '" +
                folder_.path().string() + "' --config " EMBERLEAF_BUILD "/CPackConfig.cmake");
    const std::string package = "'" + folder_.path().string() + "'/emberleaf_*.deb";
    const std::string depends = expect_good("dpkg-deb -f " + package + " Depends");
    for (const char* library : {"libosmesa6", "libc6", "libpng16-16", "libstdc++6"})
        EXPECT_NE(depends.find(library), std::string::npos) << depends;
    expect_good("dpkg-deb -x " + package + " '" + folder_.path().string() + '\'');
    forget_the_source();
    expect_it_works();
}

// The blocks of the page, one after the other, as somebody would type them.
TEST_F(Installed, DoesWhatThePageAboutGoldensSays) {
    install();
    forget_the_source();
    std::ostringstream text;
    text << std::ifstream(kSource + "/docs/GOLDEN.md").rdbuf();
    const std::string page = text.str();
    static const std::regex block("```sh\n([^`]*)```");
    std::string script;
    for (std::sregex_iterator match(page.begin(), page.end(), block), end; match != end; ++match)
        script += (*match)[1];
    EXPECT_EQ(std::count(script.begin(), script.end(), '\n'), 7) << script;
    const std::string out = say(script);
    EXPECT_NE(out.find("0 of 3 pictures differ"), std::string::npos) << out;
    EXPECT_NE(out.find("corner_0001.png: equal"), std::string::npos) << out;
    EXPECT_NE(out.find("state hash: "), std::string::npos) << out;
    for (const char* file : {"diff.xml", "diff.html", "diff.json", "difference.png"})
        EXPECT_TRUE(fs::exists(folder_ / "here" / file)) << file;
}

}  // namespace
}  // namespace ember
