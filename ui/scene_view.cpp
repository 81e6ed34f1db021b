#include "ui/scene_view.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

#include "render/image.h"

namespace ember {
namespace {

constexpr double kWatchEvery = 0.5;              // [s]
constexpr double kSlow = 0.045, kQuick = 0.015;  // [s] for one picture

int pixels(double points, double scale) {
    return std::max(1, static_cast<int>(std::lround(points * scale)));
}

}  // namespace

PictureCamera camera_of(const PictureRect& picture, const CameraParams& camera) {
    return {make_camera(camera, static_cast<int>(picture.width), static_cast<int>(picture.height)),
            picture};
}

std::filesystem::file_time_type SceneView::last_written() const {
    auto last = std::filesystem::file_time_type::min();  // its epoch lies in the future
    std::error_code none;
    for (const auto& file : std::filesystem::directory_iterator(shaders_, none)) {
        const auto written = file.last_write_time(none);
        if (!none) last = std::max(last, written);
    }
    return last;
}

bool SceneView::watch_shaders(Workbench& bench) {
    if (shaders_.empty() || bench.now() - shaders_seen_ < kWatchEvery) return false;
    shaders_seen_ = bench.now();
    const auto written = last_written();
    if (written == shaders_written_) return false;
    shaders_written_ = written;
    try {
        renderer_.reload(shaders_);
        left_.forget();
        right_.forget();
        bench.say(Severity::Info, "shaders from " + shaders_.string());
        return true;
    } catch (const std::exception& e) {
        bench.say(Severity::Error, e.what());
        return false;
    }
}

void SceneView::draw_one(const Snapshot& shot, bool beside, const RenderParams& render, int width,
                         int height, KeptPicture& kept) {
    RenderParams look = render;
    if (simple_ && shot.playing) look.look.quality = Quality::Preview;
    if (kept.holds({shot.revision, beside, look, width, height})) return;
    const bool springs = !needs_springs(look.view.mode) || !shot.springs.empty();
    if (!springs) look.view.mode = ViewMode::Beauty;  // they come with the next state
    const auto begin = std::chrono::steady_clock::now();
    renderer_.draw({&shot.view, shot.springs}, look, width, height, kept.framebuffer());
    glFinish();
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    picture_seconds_ = spent.count();
    simple_ = picture_seconds_ > (simple_ ? kQuick : kSlow);
}

void SceneView::draw(Workbench& bench, const PictureRect& picture, double scale, int width,
                     int height, unsigned target) {
    const Snapshot& shot = bench.snapshot();
    const int whole = pixels(picture.width, scale), high = pixels(picture.height, scale);
    const int bottom = height - pixels(picture.y, scale) - high;
    const bool both = bench.both_shown();
    const int wide = both ? whole / 2 : whole;
    try {
        const Snapshot& first = both ? shot : bench.pictured();
        draw_one(first, &first != &shot, bench.values.render, wide, high, left_);
        if (both) draw_one(*shot.beside, true, bench.values.render, whole - wide, high, right_);
    } catch (const std::exception& e) {
        bench.say(Severity::Error, e.what());
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width, height);
    left_.show(0, bottom, target);
    if (both) right_.show(wide, bottom, target);
    painter_.draw(*ImGui::GetDrawData(), target);
}

void SceneView::screenshot(Workbench& bench, const PictureRect& picture, double scale,
                           bool transparent) {
    try {
        const Snapshot& shot = bench.pictured();
        RenderParams render = bench.values.render;
        render.view.transparent = transparent;
        const Image image =
            renderer_.draw_image({&shot.view, shot.springs}, render, pixels(picture.width, scale),
                                 pixels(picture.height, scale));
        const auto file = bench.numbered_file(bench.folders().pictures, ".png");
        std::filesystem::create_directories(file.parent_path());
        char time[32];
        std::snprintf(time, sizeof time, "%.6g", shot.view.time);
        write_png(file, image,
                  {{"Software", "emberleaf"},
                   {"Version", version_},
                   {"Preset", bench.take_of(shot)},
                   {"Time", time},
                   {"Renderer", renderer_.description()}});
        bench.say(Severity::Info, "saved " + file.string());
    } catch (const std::exception& e) {
        bench.say(Severity::Error, e.what());
    }
}

}  // namespace ember
