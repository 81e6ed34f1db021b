// A person's hour at the window, played in as events: the same walk as drive_window.sh takes in a
// real one, where what happened can be looked at.
#include <stb_image.h>

#include <set>

#include "desk_rig.h"

namespace ember {
namespace {

constexpr const char* kSmall =
    "schema = 1\ntitle = \"small\"\n\n[sheet]\nrows = 12\ncolumns = 16\n\n[look]\n"
    "quality = \"preview\"\n";

constexpr std::size_t kCorner = 11 * 17 + 1;  // near the lower left one

class Walk : public DeskRig {
  protected:
    void SetUp() override {
        file_ = folder_.write("small.toml", kSmall);
        open(1280, 720, 1, file_);
        bench().recording = Recording(EMBERLEAF_BINARY);
    }
    // Where a node is in the window.
    [[nodiscard]] ImVec2 place_of(std::size_t node) {
        const SheetView& sheet = bench().snapshot().view.sheets[0];
        return in_window(Vector3(sheet.x[node], sheet.y[node], sheet.z[node]));
    }
    [[nodiscard]] ImVec2 in_window(const Vector3& place) {
        const PictureRect& r = layout().picture;
        const PictureCamera picture = camera_of(r, bench().values.render.camera);
        const Eigen::Vector3f p = project(picture.camera, place.cast<float>(),
                                          static_cast<int>(r.width), static_cast<int>(r.height));
        return ImVec2(p.x() + static_cast<float>(r.x), p.y() + static_cast<float>(r.y));
    }
    // Plays until that many ticks have burnt, at the pace of frames.
    void burn_to(std::uint64_t tick) {
        key(GLFW_KEY_SPACE);
        for (int i = 0; i < 4000 && bench().snapshot().stats.tick < tick; ++i) {
            frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        key(GLFW_KEY_SPACE);
        ASSERT_GE(bench().snapshot().stats.tick, tick);
        ASSERT_FALSE(bench().snapshot().playing);
    }
    // Drags a slider of the panel that holds `value`, found by trying rows from above.
    void drag_slider(const double& value) {
        const double before = value, x = width_ - 0.3 * double(layout().panel);
        for (double y = double(layout().menu) + 20; y < height_ && value == before; y += 6)
            drag(x, y, x + 40, y);
        ASSERT_NE(value, before);
    }
    // How many colours the picture shows, drawn as it is now.
    [[nodiscard]] std::size_t colours() {
        frame();
        desk_->draw(width_, height_, target_->name());
        const std::vector<unsigned char> all = pixels();
        std::set<unsigned> found;
        const PictureRect& r = layout().picture;
        for (int y = 0; y < static_cast<int>(r.height); y += 3) {
            for (int x = 0; x < static_cast<int>(r.width); x += 3) {
                const int row = height_ - 1 - static_cast<int>(r.y) - y;
                const auto* at =
                    &all[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                              static_cast<std::size_t>(x))];
                found.insert(unsigned{at[0]} << 16 | unsigned{at[1]} << 8 | at[2]);
            }
        }
        return found.size();
    }
    void record_to_the_end() {
        for (int i = 0; i < 1200 && bench().recording.state() == Recording::State::Running; ++i) {
            frame();
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
    }
    [[nodiscard]] std::size_t written(const std::filesystem::path& folder) const {
        std::size_t count = 0;
        for (const auto& file : std::filesystem::directory_iterator(folder))
            count += file.path().extension() == ".png" ? 1u : 0u;
        return count;
    }
    // Alpha of a picture's upper left pixel; nothing when it cannot be read to its end.
    [[nodiscard]] static std::optional<int> first_alpha(const std::filesystem::path& picture) {
        int width = 0, height = 0, channels = 0;
        unsigned char* rgba = stbi_load(picture.c_str(), &width, &height, &channels, 4);
        if (rgba == nullptr) return std::nullopt;
        const int alpha = rgba[3];
        stbi_image_free(rgba);
        return alpha;
    }
    std::filesystem::path file_;
};

TEST_F(Walk, LightBurnTuneUndoGoBackForkSaveCompareRecordQuit) {
    ASSERT_GT(colours(), 500u) << "a sheet is to be seen";

    ImGui::GetIO().KeyCtrl = true;
    const ImVec2 corner = place_of(kCorner);
    click(double(corner.x), double(corner.y));
    ImGui::GetIO().KeyCtrl = false;
    const LighterParams lit = bench().lighter_now(0);
    const SheetView& sheet = bench().snapshot().view.sheets[0];
    EXPECT_NEAR(lit.x, sheet.x[kCorner], 0.01);
    EXPECT_EQ(desk_->title(), "small* - 0.00 s, paused - emberleaf");
    burn_to(90);
    EXPECT_GT(bench().snapshot().stats.hottest, 600.0) << "[K]";

    const double c_s = bench().values.params.paper.c_s;
    const double grammage = bench().values.params.paper.grammage;
    drag_slider(bench().values.params.paper.grammage);
    drag_slider(bench().values.params.paper.c_s);
    EXPECT_GE(bench().snapshot().stats.tick, 90u) << "live parameters do not restart";
    while (bench().history().size() > 1)
        key(GLFW_KEY_Z, true);
    EXPECT_EQ(bench().values.params.paper.c_s, c_s);
    EXPECT_EQ(bench().values.params.paper.grammage, grammage);

    const std::uint64_t end = bench().snapshot().timeline.end;
    const double bar = layout().picture.y + layout().picture.height + 12;
    click(0.1 * layout().picture.width, bar);
    EXPECT_LT(bench().snapshot().stats.tick, end);
    EXPECT_EQ(bench().snapshot().timeline.end, end) << "looking back forgets nothing";
    drag_slider(bench().values.params.paper.grammage);
    EXPECT_LT(bench().snapshot().timeline.end, end) << "editing there does";

    key(GLFW_KEY_S, true, true);
    frames(3);
    type("mine q");
    key(GLFW_KEY_ENTER);
    EXPECT_TRUE(std::filesystem::exists(folders_.presets / "mine_q.toml"));
    EXPECT_FALSE(bench().dirty());
    EXPECT_FALSE(bench().requests.quit) << "typing is no shortcut";
    key(GLFW_KEY_R, true);
    EXPECT_EQ(bench().document().title(), "mine_q");

    key(GLFW_KEY_D, true);
    key(GLFW_KEY_D);
    EXPECT_TRUE(bench().shown.side_by_side);
    key(GLFW_KEY_D);
    key(GLFW_KEY_X);
    EXPECT_STREQ(bench().slot(), "B");

    key(GLFW_KEY_ESCAPE);
    EXPECT_FALSE(bench().requests.quit);
    key(GLFW_KEY_Q, true);
    EXPECT_TRUE(bench().requests.quit);
}

TEST_F(Walk, ThirtyFramesAreRecordedToTheEnd) {
    burn_to(10);
    bench().record({.frames = 30, .fps = 60, .width = 64, .height = 48});
    record_to_the_end();
    ASSERT_EQ(bench().recording.state(), Recording::State::Done) << bench().recording.problem();
    EXPECT_EQ(written(bench().recording.output().parent_path()), 30u);
}

TEST_F(Walk, ACancelledRecordingLeavesWholePicturesOnly) {
    bench().record({.frames = 100000, .fps = 60, .width = 64, .height = 48});
    for (int i = 0; i < 600 && bench().recording.done() < 2; ++i) {
        frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    bench().recording.cancel();
    record_to_the_end();
    EXPECT_EQ(bench().recording.state(), Recording::State::Cancelled);
    const auto folder = bench().recording.output().parent_path();
    for (const auto& file : std::filesystem::directory_iterator(folder))
        EXPECT_TRUE(first_alpha(file.path())) << file.path() << " is not whole";
}

TEST_F(Walk, TheHandlesOfALighterMoveIt) {
    const LighterParams before = bench().lighter_now(0);
    const ImVec2 at = in_window({before.x, before.y, before.z});
    const double font = double(ImGui::GetFontSize());
    drag(double(at.x), double(at.y), double(at.x) + 60, double(at.y));
    const LighterParams moved = bench().lighter_now(0);
    EXPECT_GT(std::hypot(moved.x - before.x, moved.z - before.z), 0.005);
    EXPECT_NEAR(in_window({moved.x, moved.y, moved.z}).x, at.x + 60, 2);
    const ImVec2 there = in_window({moved.x, moved.y, moved.z});
    const double top = double(there.y) - 2.2 * font;
    drag(double(there.x), top, double(there.x), top - 50);
    EXPECT_GT(bench().lighter_now(0).y, moved.y + 0.005);
    const ImVec2 high =
        in_window({bench().lighter_now(0).x, bench().lighter_now(0).y, bench().lighter_now(0).z});
    const double side = double(high.x) + 1.3 * font;
    drag(side, double(high.y), side + 40, double(high.y));
    EXPECT_GT(bench().lighter_now(0).radius, 1.2 * moved.radius);
    EXPECT_EQ(bench().history().size(), 3u) << "one entry per gesture";
}

TEST_F(Walk, HoldingTabShowsTheOtherSlotWhileItLasts) {
    key(GLFW_KEY_D, true);
    drag_slider(bench().values.params.paper.grammage);
    desk_->press(GLFW_KEY_TAB, false, false, false);
    for (int i = 0; i < 300 && &bench().pictured() == &bench().snapshot(); ++i) {
        frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    EXPECT_NE(bench().pictured().params.paper.grammage, bench().values.params.paper.grammage);
    desk_->release(GLFW_KEY_TAB);
    frames(2);
    EXPECT_EQ(&bench().pictured(), &bench().snapshot());
}

TEST_F(Walk, LeavingABuiltInPresetWithChangesSavesThemElsewhereAndLeaves) {
    bench().open(find_preset("bench/swing", ""));
    frames(3);
    bench().values.params.paper.grammage *= 1.5;
    bench().apply();
    frames(3);
    key(GLFW_KEY_Q, true);
    EXPECT_TRUE(bench().shown.leaving);
    bench().answer(true, false);
    frames(3);
    type("kept");  // over the suggestion, which is selected
    key(GLFW_KEY_ENTER);
    EXPECT_TRUE(std::filesystem::exists(folders_.presets / "kept.toml"));
    EXPECT_TRUE(bench().requests.quit);
}

TEST_F(Walk, AFileDroppedOnTheWindowIsOpened) {
    const auto other = folder_.write("other.toml", "schema = 1\ntitle = \"other\"\n");
    desk_->drop(other.string());
    frames(3);
    EXPECT_EQ(bench().document().title(), "other");
    desk_->drop((folder_ / "no such file.toml").string());
    frames(3);
    EXPECT_EQ(bench().document().title(), "other");
    EXPECT_NE(bench().notices.all().back().text.find("no such file.toml"), std::string::npos);
}

TEST_F(Walk, TheWheelWithControlGoesTowardsWhatIsUnderTheMouse) {
    const ImVec2 before = place_of(kCorner);
    const double distance = bench().values.render.camera.distance;
    point(double(before.x), double(before.y));
    ImGuiIO& io = ImGui::GetIO();
    for (const bool control : {true, false}) {
        io.KeyCtrl = control;
        io.MouseWheel = 3;
        frame();
        io.KeyCtrl = false;
        const ImVec2 after = place_of(kCorner);
        const float moved = std::hypot(after.x - before.x, after.y - before.y);
        EXPECT_TRUE(control ? moved < 3 : moved > 30) << moved;
    }
    EXPECT_LT(bench().values.render.camera.distance, 0.5 * distance);
}

TEST_F(Walk, ControlAndTheRightButtonTurnTheLampInOneEdit) {
    const PictureRect& r = layout().picture;
    ImGui::GetIO().KeyCtrl = true;
    drag(0.5 * r.width, 0.5 * r.height, 0.5 * r.width + 100, 0.5 * r.height, 1);
    ImGui::GetIO().KeyCtrl = false;
    frames(2);
    EXPECT_NEAR(bench().values.render.look.light_azimuth, 0.8, 1e-9);
    EXPECT_EQ(bench().history().size(), 1u);
    key(GLFW_KEY_Z, true);
    EXPECT_EQ(bench().values.render.look.light_azimuth, 0);
}

TEST_F(Walk, CamerasAreFlownToAndAHandStopsThem) {
    const CameraParams start = bench().values.render.camera;
    key(GLFW_KEY_7);
    EXPECT_TRUE(bench().flying());
    frames(30);
    EXPECT_FALSE(bench().flying());
    EXPECT_GT(bench().values.render.camera.elevation, 1.0);
    key(GLFW_KEY_5);
    frames(30);
    EXPECT_LT(bench().values.render.camera.field_of_view, 0.1);
    key(GLFW_KEY_HOME);
    frames(30);
    EXPECT_EQ(bench().values.render.camera.distance, start.distance);
    key(GLFW_KEY_7);
    const PictureRect& r = layout().picture;
    drag(0.5 * r.width, 0.5 * r.height, 0.5 * r.width + 5, 0.5 * r.height);
    EXPECT_FALSE(bench().flying());
    EXPECT_LT(bench().values.render.camera.elevation, 1.0);
}

TEST_F(Walk, ShadersThatChangeAreTakenUnlessTheyAreWrong) {
    const std::filesystem::path own = EMBERLEAF_SOURCE "/shaders";
    std::filesystem::copy(own, folder_ / "shaders");
    const std::string good = folder_.read("shaders/film.frag");
    SceneView scene(context_->loader(), "test", folder_ / "shaders");
    EXPECT_TRUE(scene.watch_shaders(bench())) << "the first time";
    EXPECT_FALSE(scene.watch_shaders(bench())) << "not twice";
    const auto rewrite = [&](const std::string& text, int later) {
        const auto file = folder_.write("shaders/film.frag", text);
        std::filesystem::last_write_time(
            file, std::filesystem::last_write_time(file) + std::chrono::seconds(later));
        time_ += 1;
        frame();
    };
    rewrite("\n" + good + "nonsense\n", 1);
    EXPECT_FALSE(scene.watch_shaders(bench()));
    EXPECT_NE(bench().notices.all().back().text.find("film.frag:"), std::string::npos)
        << bench().notices.all().back().text;
    scene.draw(bench(), layout().picture, 1, width_, height_, target_->name());
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR}) << "the last good ones draw";
    rewrite(good, 2);
    EXPECT_TRUE(scene.watch_shaders(bench()));
}

TEST_F(Walk, ATransparentScreenshotHasNoBackgroundAndOpensAgain) {
    burn_to(5);
    key(GLFW_KEY_F12, true);
    std::filesystem::path picture;
    for (const auto& file : std::filesystem::directory_iterator(folders_.pictures))
        picture = file.path();
    ASSERT_FALSE(picture.empty());
    EXPECT_EQ(first_alpha(picture), 0) << "the corner shows nothing";
    desk_->drop(picture.string());
    frames(3);
    EXPECT_EQ(bench().values.params.sheet.rows, 12);
}

}  // namespace
}  // namespace ember
