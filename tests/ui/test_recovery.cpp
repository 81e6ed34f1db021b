#include "ui/recovery.h"

#include "bench_rig.h"

namespace ember {
namespace {

namespace fs = std::filesystem;

TEST(Recovery, KeepsWhatItIsGivenUntilItMayForget) {
    const TemporaryFolder folder;
    Recovery recovery(folder.path());
    EXPECT_FALSE(recovery.due(1));
    EXPECT_TRUE(recovery.due(Recovery::kEvery));
    recovery.keep("one", 10);
    EXPECT_FALSE(recovery.due(11));
    recovery.keep("two", 20);
    ASSERT_EQ(folder.files().size(), 1u);
    EXPECT_EQ(folder.read(*folder.files().begin()), "two");
    EXPECT_TRUE(recovery.left_behind().empty()) << "its process is still here";
    recovery.forget();
    EXPECT_TRUE(folder.files().empty());
}

TEST(Recovery, FindsWhatADeadProcessHasLeft) {
    const TemporaryFolder folder;
    folder.write("running_999999999.take", "lost?");
    folder.write("running_x.toml", "something else");
    const auto found = Recovery(folder.path()).left_behind();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].filename(), "recovered_999999999.take");
    EXPECT_EQ(folder.read("recovered_999999999.take"), "lost?");
    EXPECT_TRUE(fs::exists(folder / "running_x.toml"));
    EXPECT_TRUE(Recovery(folder.path()).left_behind().empty()) << "it is said once";
    EXPECT_TRUE(Recovery(folder / "no such folder").left_behind().empty());
}

TEST_F(AtTheBench, WhatIsNotSavedIsKeptForTheCaseOfACrash) {
    drag_grammage(0.120);
    time_ += Recovery::kEvery;
    frames();
    fs::path kept;
    for (const auto& file : fs::directory_iterator(folders_.state))
        kept = file.path();
    ASSERT_FALSE(kept.empty());
    EXPECT_DOUBLE_EQ(open_document(kept).saved.params.paper.grammage, 0.120);
    bench_->act(Action::Quit);
    EXPECT_FALSE(bench_->requests.quit) << "it asks first";
    bench_->answer(false, true);
    EXPECT_TRUE(bench_->requests.quit);
    EXPECT_FALSE(fs::exists(kept)) << "given up";
}

}  // namespace
}  // namespace ember
