// Presets that ask for too much, or for files that are none of theirs: refused before anything is
// made or read.
#include <sys/resource.h>

#include <climits>

#include "app/exit_code.h"
#include "app/preset_io/memory_limit.h"
#include "app/run_options.h"
#include "preset_rig.h"
#include "render/image.h"
#include "sim/scene_check.h"

namespace ember {
namespace {

std::string refusal(const std::filesystem::path& preset,
                    const std::vector<std::string>& sets = {}) {
    RunOptions options;
    options.preset = preset;
    options.sets = sets;
    try {
        static_cast<void>(load_run(options));
    } catch (const InputError& e) {
        const std::string text = e.what();
        return text.substr(0, text.find('\n'));
    }
    return "";
}

long peak_kilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

TEST(Limits, TooManyNodesAreRefusedBeforeAnythingIsMade) {
    const TemporaryFolder folder;
    // whose picture is not there: it would be missed if it were looked for
    const auto preset = folder.write("p.toml", "schema = 1\n[sheet]\nmask = \"gone.png\"\n");
    static_cast<void>(refusal(preset));  // whatever a first run takes
    const long before = peak_kilobytes();
    EXPECT_NE(refusal(preset, {"sheet.rows=4096", "sheet.columns=4096"})
                  .find("sheet.rows: more than 4096 x 4096 nodes in all, here 1 x 4097 x 4097"),
              std::string::npos);
    EXPECT_NE(refusal(preset, {"sheet.rows=4096", "sheet.columns=4096", "sheet.count=64"})
                  .find("here 64 x 4097 x 4097"),
              std::string::npos)
        << "a product beyond 32 bits";
    EXPECT_NE(refusal(preset, {"sheet.rows=9000"}).find("expected a whole number from 1 to 4096"),
              std::string::npos);
    EXPECT_LT(peak_kilobytes() - before, 10'000);
}

TEST(Limits, MoreThanFitsIntoMemoryIsRefused) {
    Params params;
    params.sheet.rows = params.sheet.columns = 999;
    EXPECT_NO_THROW(check_memory(params, 1'100'000'000));
    try {
        check_memory(params, 1'099'999'999);
        ADD_FAILURE() << "there is too little";
    } catch (const SceneError& e) {
        EXPECT_EQ(e.key(), "sheet.rows");
        EXPECT_EQ(e.message(), "1000000 nodes need about 1.1 GB of memory, and 1.1 GB are free");
    }
    params.sheets.resize(3);
    EXPECT_EQ(count_nodes(params), 3'000'000);
    EXPECT_THROW(check_memory(params, 2'000'000'000), SceneError);
    EXPECT_GT(free_memory(), 10'000'000u);
}

TEST(Limits, TheLimitOfAProcessIsSeen) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer needs more addresses than the limit leaves";
#endif
    rlimit before{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &before), 0);
    rlimit tight = before;
    tight.rlim_cur = 3ull << 30;
    if (before.rlim_cur < tight.rlim_cur) GTEST_SKIP() << "it is tighter already";
    ASSERT_EQ(setrlimit(RLIMIT_AS, &tight), 0);
    const std::string reason = refusal("paper/corner", {"sheet.rows=4000", "sheet.columns=4000"});
    setrlimit(RLIMIT_AS, &before);
    EXPECT_NE(reason.find("16008001 nodes need about 17.6 GB of memory"), std::string::npos)
        << reason;
}

TEST(Limits, PicturesAreReadFromThePresetsOwnFolderOnly) {
    const TemporaryFolder folder;
    Image image{4, 4, std::vector<std::uint8_t>(64, 255)};
    write_png(folder / "secret.png", image);
    std::filesystem::create_directories(folder / "mine/below");
    write_png(folder / "mine/below/own.png", image);
    const auto preset = folder.write("mine/p.toml", "schema = 1\n");
    std::filesystem::create_symlink(folder / "secret.png", folder / "mine/link.png");
    std::filesystem::create_directory_symlink(folder.path(), folder / "mine/way");
    std::filesystem::create_symlink("below/own.png", folder / "mine/inside.png");
    const auto with = [&](const std::string& key, const std::string& name) {
        folder.write("mine/p.toml", "schema = 1\n[" + key.substr(0, key.find('.')) + "]\n" +
                                        key.substr(key.find('.') + 1) + " = \"" + name + "\"\n");
        return refusal(preset);
    };
    for (const char* key : {"sheet.mask", "print.front", "print.back"}) {
        SCOPED_TRACE(key);
        for (const std::string& out : std::vector<std::string>{
                 "../secret.png", "below/../../secret.png", (folder / "secret.png").string(),
                 "link.png", "way/secret.png"}) {
            EXPECT_NE(with(key, out).find("expected a file in the preset's own folder, got"),
                      std::string::npos)
                << out;
        }
        EXPECT_EQ(with(key, "below/own.png"), "");
        EXPECT_EQ(with(key, "inside.png"), "") << "a link that stays inside";
    }
}

TEST(Limits, NothingButPresetsIsInheritedFromElsewhere) {
    const TemporaryFolder folder;
    folder.write("passwords", "root = secret\n");
    folder.write("base.toml", "schema = 1\n");
    std::filesystem::create_directory(folder / "mine");
    std::filesystem::create_symlink(folder / "passwords", folder / "mine/link");
    const auto inherits = [&](const std::string& name) {
        folder.write("mine/p.toml", "schema = 1\ninherits = \"" + name + "\"\n");
        return refusal(folder / "mine/p.toml");
    };
    for (const std::string& out :
         std::vector<std::string>{"../passwords", (folder / "passwords").string(), "link"}) {
        const std::string reason = inherits(out);
        EXPECT_NE(reason.find("p.toml:2:12: error: inherits: outside of the preset's own folder"),
                  std::string::npos)
            << reason;
        EXPECT_EQ(reason.find("secret"), std::string::npos) << reason;
    }
    EXPECT_EQ(inherits("../base"), "");
    EXPECT_EQ(inherits("../base.toml"), "");
    EXPECT_EQ(inherits("paper/corner"), "");
}

}  // namespace
}  // namespace ember
