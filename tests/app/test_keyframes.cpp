// Parameters over time, the plan of a shot, and means of pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "app/exit_code.h"
#include "app/frame_painter.h"
#include "app/keyframes.h"
#include "app/shot_record.h"
#include "sim/param_table.h"
#include "sim/units.h"

namespace ember {
namespace {

const ParamInfo& row_of(const char* key) {
    const ParamInfo* row = find_param(render_param_rows(), key);
    return row != nullptr ? *row : *find_param(sim_param_rows(), key);
}

TEST(Track, PassesThroughItsKeysWithoutOvershooting) {
    const std::vector<double> times = {0, 1, 2, 5}, values = {0, 1, 1, 3};
    const Track track(row_of("camera.azimuth"), times, values);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_DOUBLE_EQ(track.at(times[i]), values[i]);
    EXPECT_EQ(track.at(-1), 0) << "before the first key";
    EXPECT_EQ(track.at(9), 3) << "after the last one";
    double last = 0;
    for (double t = 0; t <= 5; t += 0.01) {
        EXPECT_GE(track.at(t), last - 1e-12) << "never back, at " << t;
        last = track.at(t);
    }
    EXPECT_EQ(track.at(1.5), 1) << "flat between equal keys";
}

TEST(Track, HasNoKinkAtAKey) {
    const Track track(row_of("camera.azimuth"), {0, 1, 3}, {0, 1, 2});
    const double h = 1e-6;
    const double before = (track.at(1) - track.at(1 - h)) / h;
    const double after = (track.at(1 + h) - track.at(1)) / h;
    EXPECT_NEAR(before, after, 1e-5);
    EXPECT_GT(before, 0.3) << "nor a stop";
}

TEST(Track, LogarithmicRowsGoByTheirRatio) {
    const Track track(row_of("camera.distance"), {0, 2}, {0.5, 2});
    EXPECT_NEAR(track.at(1), 1.0, 1e-12) << "the geometric mean in the middle";
}

TEST(Track, ChoicesStayUntilTheNextKey) {
    const Track track(row_of("look.lighting"), {0, 1}, {0, 1});
    EXPECT_EQ(track.at(0.999), 0);
    EXPECT_EQ(track.at(1), 1);
}

TEST(Keyframes, ReadShownUnitsAndApplyToBoth) {
    Keyframes keys;
    keys.add("camera.azimuth=0:0,4:90");
    EXPECT_FALSE(keys.move_simulation());
    keys.add("burning.burn_speed=0:1,1:3");
    EXPECT_TRUE(keys.move_simulation());
    RenderParams look;
    keys.apply(look, 4);
    EXPECT_NEAR(look.camera.azimuth, unit::degree.to_si(90), 1e-12);
    Params params;
    keys.apply(params, 1);
    EXPECT_DOUBLE_EQ(params.burning.burn_speed, row_of("burning.burn_speed").unit.to_si(3));
}

TEST(Keyframes, WhatIsNoneIsRefusedWithAReason) {
    const auto reason = [](const std::string& text) -> std::string {
        try {
            Keyframes().add(text);
        } catch (const InputError& e) {
            return e.what();
        }
        return "accepted";
    };
    EXPECT_NE(reason("camera.azimut=0:1").find("did you mean camera.azimuth?"), std::string::npos);
    EXPECT_NE(reason("camera.azimuth").find("KEY=TIME:VALUE"), std::string::npos);
    EXPECT_NE(reason("camera.azimuth=1").find("TIME:VALUE"), std::string::npos);
    EXPECT_NE(reason("camera.azimuth=1:0,0:0").find("ascend"), std::string::npos);
    EXPECT_NE(reason("camera.azimuth=0:9999").find("camera.azimuth"), std::string::npos);
    EXPECT_NE(reason("sheet.rows=0:9,1:12").find("cannot change"), std::string::npos);
    EXPECT_NE(reason("shot.fps=0:9").find("cannot change"), std::string::npos);
}

TEST(Plan, FramesBeginAtTheStartAndAreExposedForTheShuttersTime) {
    RenderOptions options;
    options.frames = "10..11";
    options.start = 2;
    options.blur_samples = 4;
    options.shutter = 90;
    ShotParams shot;
    shot.fps = 20;
    const auto pictures = plan_pictures(options, shot);
    ASSERT_EQ(pictures.size(), 2u);
    EXPECT_EQ(pictures[1], (PlannedPicture{11, 2.55, 0.55, 0.0125}));
    options.frames.clear();
    EXPECT_EQ(plan_pictures(options, shot).size(), 200u);
    options.at = "1";
    EXPECT_EQ(plan_pictures(options, shot).size(), 1u);
    options.turntable = 360;
    const auto around = plan_pictures(options, shot);
    ASSERT_EQ(around.size(), 200u);
    EXPECT_EQ(around[100], (PlannedPicture{100, 1, 5, 0})) << "the burn stands still";
}

TEST(Turntable, TurnsTheCameraByItsAngleInTheShot) {
    RenderJob job;
    job.preset.render.shot.duration = 4;
    job.preset.render.camera.azimuth = 0.5;
    EXPECT_NEAR(look_at(job, 90, 0).camera.azimuth, 0.5, 1e-12);
    EXPECT_NEAR(look_at(job, 90, 4).camera.azimuth, 0.5 + unit::degree.to_si(90), 1e-12);
    job.keys.add("camera.azimuth=0:0,4:10");
    EXPECT_NEAR(look_at(job, 90, 4).camera.azimuth, unit::degree.to_si(100), 1e-12);
}

TEST(Mean, IsOneOfLightAndWeightedByWhatIsCovered) {
    const Image black{1, 1, {0, 0, 0, 255}}, white{1, 1, {255, 255, 255, 255}};
    const Image nothing{1, 1, {77, 77, 77, 0}};
    const Image half = mean_of(std::vector{black, white});
    EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{188, 188, 188, 255})) << "half the light";
    EXPECT_EQ(mean_of(std::vector{white, nothing}).rgba,
              (std::vector<std::uint8_t>{255, 255, 255, 128}));
    EXPECT_EQ(mean_of(std::vector{half, half, half}).rgba, half.rgba);
}

std::string hash_of(const std::function<void(RenderOptions&)>& change) {
    RenderOptions options;
    options.run.preset = "paper/corner";
    change(options);
    return *find_text(shot_text(options, load_render_job(options), "a renderer"), "Hash");
}

TEST(ShotRecord, TheHashIsTheSameExactlyForPicturesThatAreTheSame) {
    const std::string plain = hash_of([](RenderOptions&) {});
    EXPECT_EQ(plain.size(), 16u);
    EXPECT_EQ(hash_of([](RenderOptions& o) { o.run.threads = 7, o.serial = true; }), plain)
        << "neither changes a picture";
    EXPECT_EQ(hash_of([](RenderOptions& o) { o.frames = "3", o.skip_existing = true; }), plain);
    EXPECT_EQ(hash_of([](RenderOptions& o) { o.run.sets = {"shot.duration=5"}; }), plain)
        << "a longer shot begins the same";
    const std::function<void(RenderOptions&)> changes[] = {
        [](RenderOptions& o) { o.run.seed = "7"; },
        [](RenderOptions& o) { o.run.sets = {"paper.grammage=70"}; },
        [](RenderOptions& o) { o.run.preset = "paper/letter"; },
        [](RenderOptions& o) { o.msaa = 1; },
        [](RenderOptions& o) { o.size = "64x48"; },
        [](RenderOptions& o) { o.fps = "24"; },
        [](RenderOptions& o) { o.start = 0.1; },
        [](RenderOptions& o) { o.turntable = 5; },
        [](RenderOptions& o) { o.turntable = 5, o.run.sets = {"shot.duration=5"}; },
        [](RenderOptions& o) { o.turntable = 5, o.at = "1"; },
        [](RenderOptions& o) { o.blur_samples = 2; },
        [](RenderOptions& o) { o.blur_samples = 2, o.shutter = 90; },
        [](RenderOptions& o) { o.camera = "side"; },
        [](RenderOptions& o) { o.focal_length = 50; },
        [](RenderOptions& o) { o.lighting = "night"; },
        [](RenderOptions& o) { o.transparent = true; },
        [](RenderOptions& o) { o.animate = {"camera.azimuth=0:0,1:5"}; },
    };
    std::set<std::string> all = {plain};
    for (const auto& change : changes)
        EXPECT_TRUE(all.insert(hash_of(change)).second) << &change - changes;
}

TEST(TextHash, IsFnv1a) {
    EXPECT_EQ(text_hash(""), 0xCBF29CE484222325u);
    EXPECT_EQ(text_hash("a"), 0xAF63DC4C8601EC8Cu);  // of the reference's own list
}

}  // namespace
}  // namespace ember
