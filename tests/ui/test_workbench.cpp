// What a person does in the window, without the window: edit, undo, fork, save, compare, record.
#include <gtest/gtest.h>

#include "bench_rig.h"
#include "sim/lighter.h"

namespace ember {
namespace {

TEST_F(AtTheBench, AnEditIsUndoneAsOneGestureAndMarksThePreset) {
    steps(20);
    EXPECT_FALSE(bench_->dirty());
    drag_grammage(0.120);
    EXPECT_EQ(bench_->snapshot().stats.tick, 20u) << "grammage is live";
    EXPECT_TRUE(bench_->dirty());
    EXPECT_EQ(bench_->history().size(), 1u);
    bench_->act(Action::Undo);
    frames();
    EXPECT_DOUBLE_EQ(bench_->values.params.paper.grammage, 0.080);
    EXPECT_DOUBLE_EQ(bench_->snapshot().params.paper.grammage, 0.080);
    EXPECT_FALSE(bench_->dirty());
    bench_->act(Action::Redo);
    frames();
    EXPECT_DOUBLE_EQ(bench_->snapshot().params.paper.grammage, 0.120);
}

TEST_F(AtTheBench, ScrubbingBackShowsThePastAndEditingThereForks) {
    steps(20);
    drag_grammage(0.120);
    steps(20);
    bench_->go_to(10);
    frames();
    EXPECT_EQ(bench_->snapshot().stats.tick, 10u);
    EXPECT_DOUBLE_EQ(bench_->values.params.paper.grammage, 0.080) << "as it was then";
    EXPECT_EQ(bench_->history().size(), 1u) << "looking back is no edit";
    EXPECT_EQ(bench_->snapshot().timeline.end, 40u);
    drag_grammage(0.200);
    EXPECT_EQ(bench_->snapshot().timeline.end, 10u);
}

TEST_F(AtTheBench, WhatIsRefusedIsTakenBackAndSaid) {
    bench_->values.params.sheet.width = 0;
    bench_->apply();
    frames();
    frames();
    EXPECT_GT(bench_->values.params.sheet.width, 0);
    EXPECT_NE(said().find("sheet.width"), std::string::npos);
}

TEST_F(AtTheBench, SaveKeepsCommentsAndSaveAsInherits) {
    drag_grammage(0.120);
    bench_->act(Action::Save);
    EXPECT_NE(read(file_).find("grammage = 120  # as in the office"), std::string::npos);
    EXPECT_FALSE(bench_->dirty());
    bench_->open("paper/nothing");
    EXPECT_NE(said().find("nothing"), std::string::npos) << "what cannot be opened says why";
    EXPECT_EQ(bench_->document().info.path, file_);
    bench_->open(find_preset("paper/corner", ""));
    frames();
    EXPECT_TRUE(bench_->document().read_only);
    bench_->act(Action::Save);
    EXPECT_TRUE(bench_->shown.save_as) << "built-in presets stay as they are";
    drag_grammage(0.100);
    ASSERT_TRUE(bench_->save_to(folders_.presets / "mine.toml"));
    const std::string mine = read(folders_.presets / "mine.toml");
    EXPECT_NE(mine.find("inherits = \"paper/corner\""), std::string::npos) << mine;
    EXPECT_NE(mine.find("grammage = 100"), std::string::npos) << mine;
    EXPECT_LT(mine.size(), 200u) << mine;
    EXPECT_DOUBLE_EQ(bench_->document().parent.params.paper.grammage, 0.080);
    EXPECT_EQ(bench_->settings.recent.front(), (folders_.presets / "mine.toml").string());
}

TEST_F(AtTheBench, UnsavedChangesAreAskedAboutWithAList) {
    drag_grammage(0.120);
    bench_->act(Action::Quit);
    EXPECT_TRUE(bench_->shown.leaving);
    EXPECT_FALSE(bench_->requests.quit);
    const auto changes = bench_->unsaved();
    ASSERT_EQ(changes.size(), 1u);
    EXPECT_EQ(changes[0].key + ' ' + changes[0].from + ' ' + changes[0].to,
              "paper.grammage 80 g/m\u00b2 120 g/m\u00b2");
    bench_->answer(false, false);
    EXPECT_FALSE(bench_->requests.quit);
    bench_->act(Action::Quit);
    bench_->answer(true, false);
    EXPECT_TRUE(bench_->requests.quit);
    EXPECT_NE(read(file_).find("grammage = 120"), std::string::npos);
}

TEST_F(AtTheBench, AFileThatOthersChangeIsReadAgainAndABadOneIsNot) {
    const auto later = std::filesystem::last_write_time(file_) + std::chrono::seconds(5);
    folder_.write("small.toml", std::string(kPreset) + "c_s = 5e-3\n");
    std::filesystem::last_write_time(file_, later);
    time_ += 2;
    frames();
    frames();
    EXPECT_DOUBLE_EQ(bench_->values.params.paper.c_s, 5e-3);
    folder_.write("small.toml", std::string(kPreset) + "c_s = true\n");
    std::filesystem::last_write_time(file_, later + std::chrono::seconds(5));
    time_ += 2;
    frames();
    EXPECT_DOUBLE_EQ(bench_->values.params.paper.c_s, 5e-3) << "the last good one stays";
    EXPECT_NE(said().find("small.toml:10:7: error: paper.c_s"), std::string::npos) << said();
}

TEST_F(AtTheBench, TwoSlotsAreExchangedAndBurnSideBySide) {
    bench_->act(Action::StoreSlot);
    drag_grammage(0.120);
    bench_->act(Action::SideBySide);
    steps(5);
    for (int i = 0; i < 500 && (bench_->snapshot().beside == nullptr ||
                                bench_->snapshot().beside->stats.tick != 5);
         ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(4));
        frames();
    }
    ASSERT_NE(bench_->snapshot().beside, nullptr);
    EXPECT_EQ(bench_->snapshot().beside->stats.tick, 5u);
    EXPECT_DOUBLE_EQ(bench_->snapshot().beside->params.paper.grammage, 0.080);
    bench_->act(Action::SwapSlots);
    frames();
    EXPECT_STREQ(bench_->slot(), "B");
    EXPECT_DOUBLE_EQ(bench_->values.params.paper.grammage, 0.080);
    EXPECT_DOUBLE_EQ(bench_->other_slot().params.paper.grammage, 0.120);
}

TEST_F(AtTheBench, LightersAreAddedMovedAndRemoved) {
    bench_->act(Action::AddLighter);
    frames();
    ASSERT_EQ(bench_->snapshot().view.lighters.size(), 2u);
    EXPECT_EQ(bench_->lighter, 1u);
    bench_->place_lighter({0.01, 0.15, 0});
    frames();
    EXPECT_DOUBLE_EQ(bench_->snapshot().view.lighters[1].position.x(), 0.01);
    bench_->act(Action::RemoveLighter);
    frames();
    EXPECT_EQ(bench_->snapshot().view.lighters.size(), 1u);
}

TEST_F(AtTheBench, MovementsOfALighterBecomeItsPath) {
    const auto path = [&] { return bench_->lighter_now(0).path; };
    steps(6);
    bench_->place_lighter({0.03, 0.14, 0});
    frames();
    EXPECT_TRUE(path().empty()) << "moved by hand, it stays there";
    bench_->act(Action::RecordPath);
    bench_->place_lighter({0.04, 0.14, 0});
    frames();
    steps(30);
    bench_->place_lighter({0.05, 0.13, 0});
    frames();
    bench_->act(Action::RecordPath);
    ASSERT_EQ(path().size(), 3u) << "there, there until just before, and then here";
    bench_->act(Action::Restart);
    frames();
    const auto x_at = [&](double time) {
        return lighter_position(bench_->lighter_now(0), time).x();
    };
    EXPECT_DOUBLE_EQ(x_at(6.0 / 60), 0.04);
    EXPECT_DOUBLE_EQ(x_at(30.0 / 60), 0.04);
    EXPECT_DOUBLE_EQ(x_at(36.0 / 60), 0.05);
    bench_->place_lighter({0.06, 0.13, 0});
    EXPECT_TRUE(path().empty());
}

TEST_F(AtTheBench, ATakeIsWhatWasDoneAndOpensAgain) {
    steps(10);
    drag_grammage(0.120);
    steps(10);
    bench_->place_lighter({0.02, 0.14, 0});
    steps(20);
    const std::uint64_t hash = bench_->snapshot().hash;
    const std::filesystem::path take = bench_->save_take(folders_.state);
    bench_->open(take, true);
    frames();
    EXPECT_EQ(bench_->snapshot().stats.tick, bench_->snapshot().timeline.cursor);
    bench_->act(Action::TogglePlay);
    bench_->act(Action::TogglePlay);
    frames();
    while (bench_->snapshot().stats.tick < 40)
        steps(1);
    EXPECT_EQ(bench_->snapshot().hash, hash);
}

TEST_F(AtTheBench, ATakeOfAPresetWithPicturesFindsThem) {
    bench_->open(find_preset("scenes/leaf", ""));
    frames();
    steps(3);
    const std::filesystem::path take = bench_->save_take(folders_.state);
    EXPECT_FALSE(open_document(take).saved.params.masks.empty());
}

TEST_F(AtTheBench, ARecordingIsTheProgramItself) {
    bench_->recording = Recording(EMBERLEAF_BINARY);
    steps(4);
    drag_grammage(0.120);
    bench_->record({.frames = 3, .fps = 60, .width = 64, .height = 48});
    for (int i = 0; i < 600 && bench_->recording.state() == Recording::State::Running; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        frames();
    }
    EXPECT_EQ(bench_->recording.state(), Recording::State::Done) << bench_->recording.problem();
    EXPECT_TRUE(
        std::filesystem::exists(bench_->recording.output().parent_path() / "frame_0002.png"));
}

TEST_F(AtTheBench, TheCommandLineSaysWhatIsDifferent) {
    drag_grammage(0.120);
    steps(30);
    const std::vector<std::string> words = bench_->command();
    EXPECT_EQ(command_line(words), "emberleaf render " + file_.string() +
                                       " --set paper.grammage=120 --at 0.5 -o small.png");
    EXPECT_EQ(command_line({"a b", "it's"}), "'a b' 'it'\\''s'");
}

TEST(Recording, ReadsHowFarItIs) {
    EXPECT_EQ(frames_done(""), 0);
    const std::string written =
        "out.mp4: 3 MB\n{\"event\":\"progress\",\"done\":7,\"total\":9}\nerror: no space\n";
    EXPECT_EQ(frames_done(written), 7);
    EXPECT_EQ(complaints(written), "out.mp4: 3 MB\nerror: no space\n");
}

TEST(Settings, AreReadAsTheyWereWrittenAndNonsenseIsLeftOut) {
    const TemporaryFolder folder;
    Settings settings;
    settings.width = 1600;
    settings.scheme = CameraScheme::Maya;
    settings.show_plots = true;
    for (int i = 0; i < 15; ++i)
        settings.remember("preset " + std::to_string(i));
    settings.remember("preset 9");
    write_settings(folder / "settings", settings);
    const Settings again = read_settings(folder / "settings");
    EXPECT_EQ(again.width, 1600);
    EXPECT_EQ(again.scheme, CameraScheme::Maya);
    EXPECT_TRUE(again.show_plots);
    EXPECT_EQ(again.recent, settings.recent);
    EXPECT_EQ(again.recent.size(), Settings::kMostRecent);
    EXPECT_EQ(again.recent[0], "preset 9");
    folder.write("settings", "width=-3\nheight=zero\ncamera=?\nnonsense\n=\n");
    const Settings bad = read_settings(folder / "settings");
    EXPECT_EQ(bad.width, Settings().width);
    EXPECT_EQ(bad.height, Settings().height);
}

}  // namespace
}  // namespace ember
