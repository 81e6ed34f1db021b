// Names of numbered files, lists of frames and times, and files that are whole or not there.
#include <gtest/gtest.h>

#include "app/exit_code.h"
#include "app/file_pattern.h"
#include "app/frame_list.h"
#include "app/preset_io/atomic_file.h"
#include "app/run_options.h"
#include "temporary_folder.h"

namespace ember {
namespace {

TEST(FilePattern, HashesAndPercentDMarkThePlaceOfTheNumber) {
    EXPECT_EQ(FilePattern("out/f_####.png").name(7), "out/f_0007.png");
    EXPECT_EQ(FilePattern("f_##.png").name(12345), "f_12345.png");
    EXPECT_EQ(FilePattern("f_%04d.png").name(7), "f_0007.png");
    EXPECT_EQ(FilePattern("f%d.png").name(7), "f7.png");
    EXPECT_EQ(FilePattern("f_{frame:4}.png").name(7), "f_0007.png");
    EXPECT_EQ(FilePattern("f_{frame}.png").name(7), "f_7.png");
    EXPECT_EQ(FilePattern("a#b/100%/f##.png").name(3), "a#b/100%/f03.png") << "folders stay";
}

TEST(FilePattern, WithoutAPlaceOneIsInsertedOnlyForSeveralFiles) {
    EXPECT_EQ(FilePattern("out/fire.png").name(3), "out/fire_0003.png");
    EXPECT_EQ(FilePattern("fire").name(3), "fire_0003");
    EXPECT_EQ(FilePattern("out/fire.png", false).name(3), "out/fire.png");
    EXPECT_EQ(FilePattern("out/fire_##.png", false).name(3), "out/fire_03.png");
}

TEST(FilePattern, AnythingElseWithAPercentSignIsRefused) {
    for (const char* bad :
         {"f_%s.png", "f_%n%d.png", "f_%d_%d.png", "##_##.png", "f_%5d.png", "f_%00d.png", "f%.png",
          "f_{name}.png", "f_{frame:}.png", "f_####_{frame}.png", "", "folder/"}) {
        EXPECT_THROW(FilePattern{bad}, InputError) << bad;
    }
}

TEST(FrameList, RangesStepsAndListsAreSortedAndWithoutDuplicates) {
    EXPECT_EQ(parse_frames("3"), (std::vector<long>{3}));
    EXPECT_EQ(parse_frames("0..4"), (std::vector<long>{0, 1, 2, 3, 4}));
    EXPECT_EQ(parse_frames("0..9+4"), (std::vector<long>{0, 4, 8}));
    EXPECT_EQ(parse_frames("9,1..3,2"), (std::vector<long>{1, 2, 3, 9}));
    EXPECT_EQ(parse_frames("1,40..50,+5"), (std::vector<long>{1, 40, 45, 50}))
        << "as Blender has it";
    EXPECT_EQ(parse_times("2,0.5"), (std::vector<double>{0.5, 2.0}));
    EXPECT_EQ(parse_size("960x540").width, 960);
    EXPECT_EQ(parse_size("960x540").height, 540);
}

TEST(FrameList, RatesAreExactWhereTheFilmWorldRounds) {
    EXPECT_EQ(rate_text("24"), "24");
    EXPECT_EQ(std::stod(rate_text("23.976")), 24000.0 / 1001);
    EXPECT_EQ(std::stod(rate_text("29.97")), 30000.0 / 1001);
    EXPECT_EQ(std::stod(rate_text("30000/1001")), 30000.0 / 1001);
    EXPECT_EQ(rate_text("12.5"), "12.5");
    EXPECT_EQ(rate_text("fast"), "fast") << "left to whoever refuses it";
    EXPECT_EQ(rate_text("1/0"), "1/0");
}

TEST(FrameList, WhatIsNoListIsRefused) {
    for (const char* bad :
         {"", "a", "1,", ",1", "3..1", "-1", "1..", "..2", "1...3", "0..9+0", "0..9+-1", "0..9+",
          "+5", "0..9,+0", "0..9,+", "1+2", "0..99999999999", "1.5", "1 2"}) {
        EXPECT_THROW(static_cast<void>(parse_frames(bad)), InputError) << bad;
    }
    for (const char* bad : {"", "-1", "nan", "inf", "1s", "1,,2"}) {
        EXPECT_THROW(static_cast<void>(parse_times(bad)), InputError) << bad;
    }
    for (const char* bad : {"", "960", "960x", "0x10", "960x540x2", "99999x1", "-1x5"}) {
        EXPECT_THROW(static_cast<void>(parse_size(bad)), InputError) << bad;
    }
}

TEST(AtomicFile, CreatesFoldersAndReplacesWholeFiles) {
    const TemporaryFolder folder;
    write_file(folder / "a/b/c.txt", "one");
    write_file(folder / "a/b/c.txt", "two");
    EXPECT_EQ(folder.read("a/b/c.txt"), "two");
    EXPECT_EQ(folder.files(), (std::set<std::string>{"a", "a/b", "a/b/c.txt"}))
        << "no temporary file is left";
}

TEST(AtomicFile, AFailureNamesTheFileAndLeavesNothing) {
    const TemporaryFolder folder;
    folder.write("file", "kept");
    std::filesystem::create_directory(folder / "taken");
    for (const std::string name : {"file/below.txt", "taken"}) {
        try {
            write_file(folder / name, "text");
            ADD_FAILURE() << name << " cannot be written";
        } catch (const std::runtime_error& e) {
            EXPECT_NE(std::string(e.what()).find((folder / "").string()), std::string::npos)
                << e.what();
        }
    }
    EXPECT_EQ(folder.files(), (std::set<std::string>{"file", "taken"}));
    EXPECT_EQ(folder.read("file"), "kept");
}

TEST(Divergence, IsReportedWithStagePlaceTimeAndReason) {
    StepReport report;
    report.status = StepStatus::Diverged;
    report.stage = Stage::Springs;
    report.sheet = 1;
    report.node = 42;
    report.time = 2.5;
    report.retries = 6;
    report.reason = "a velocity is not finite";
    EXPECT_EQ(divergence_text(report),
              "simulation stopped at t = 2.5 s: stage springs, sheet 1, node 42: a velocity is not "
              "finite (after 6 retries with half the step)");
}

}  // namespace
}  // namespace ember
