#include "ui/desk.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "ui/camera_text.h"

namespace ember {
namespace {

double pixels_per_point() {
    return std::max(0.1, double(ImGui::GetIO().DisplayFramebufferScale.x));
}

}  // namespace

Desk::Desk(GlLoader loader, const std::string& version, Document document,
           const UserFolders& folders, const Settings& settings, int threads,
           std::function<void()> wake, const std::filesystem::path& shaders)
    : scene_(loader, version, shaders),
      browser_(folders.cache),
      bench_(std::move(document), folders, settings, threads, std::move(wake)) {}

void Desk::press(int key, bool control, bool shift, bool repeated) {
    if (ImGui::GetIO().WantTextInput) return;
    if (const KeyBinding* binding = find_binding(key, control, shift, repeated))
        pressed_.push_back(binding->action);
}

void Desk::release(int key) {
    if (key == binding_of(Action::Compare).key) bench_.shown.comparing = false;
}

bool Desk::begin(double now) {
    bench_.begin_frame(now, busy_);
    for (const Action action : std::exchange(pressed_, {}))
        bench_.act(action);
    if (!dropped_.empty()) bench_.open(std::exchange(dropped_, {}));
    const Snapshot& shot = bench_.snapshot();
    const auto ticks = static_cast<int>(shot.stats.tick - std::min(tick_, shot.stats.tick));
    tick_ = shot.stats.tick;
    speed_.simulated(ticks, shot.timeline.tick_duration, shot.stats.tick_seconds * ticks);
    speed_.passed(last_ < 0 ? 0 : now - last_, shot.playing);
    last_ = now;
    obey();
    return changed();
}

// Whether anything but the mouse asks for another picture.
bool Desk::changed() {
    const Snapshot& shot = bench_.snapshot();
    const std::uint64_t now = shot.revision + (shot.beside ? shot.beside->revision : 0) +
                              shot.commands + bench_.notices.all().size() +
                              static_cast<std::uint64_t>(bench_.recording.done()) +
                              static_cast<std::uint64_t>(bench_.recording.state());
    const bool news = std::exchange(seen_, now) != now;
    return scene_.watch_shaders(bench_) || browser_.poll() || news || bench_.flying();
}

void Desk::obey() {
    WindowRequests& asked = bench_.requests;
    if (asked.copy) ImGui::SetClipboardText(asked.copy->c_str());
    if (asked.paste_camera) {
        const char* text = ImGui::GetClipboardText();
        const auto camera = camera_from_text(text == nullptr ? "" : text);
        if (camera) bench_.values.render.camera = *camera;
        if (!camera) bench_.say(Severity::Warning, "the clipboard holds no camera");
    }
    if (asked.screenshot || asked.screenshot_clear)
        scene_.screenshot(bench_, layout_.picture, pixels_per_point(), asked.screenshot_clear);
    asked.copy.reset();
    asked.paste_camera = asked.screenshot = asked.screenshot_clear = false;
}

void Desk::lay_out() {
    layout_ = layout_of(bench_);
    plots_.add(bench_.pictured());
    draw_menu_bar(layout_, bench_);
    draw_main_panel(layout_, bench_);
    draw_timeline(layout_, bench_);
    draw_status_bar(layout_, bench_, speed_.times());
    use_mouse();
    draw_overlays(layout_, bench_, plots_);
    browser_.draw(layout_, bench_);
    dialogs_.draw(bench_);
    busy_ = ImGui::IsAnyItemActive() || controls_.dragging() || handles_.dragging();
    bench_.end_frame(busy_);
    ImGui::Render();
}

void Desk::draw(int width, int height, unsigned target) {
    scene_.draw(bench_, layout_.picture, pixels_per_point(), width, height, target);
}

void Desk::use_mouse() {
    PictureRect tools = layout_.picture;
    if (bench_.both_shown()) tools.width /= 2;
    const PictureCamera picture = camera_of(tools, bench_.values.render.camera);
    const bool taken = bench_.settings.show_panel && handles_.update(picture, bench_);
    const auto drag = controls_.update(bench_.values.render, bench_.settings.scheme,
                                       layout_.picture, bench_.shown.placing, taken);
    if (drag) tools_.use(*drag, picture, bench_);
    if (!taken && !drag && !controls_.dragging()) draw_probe(picture, bench_.pictured());
}

std::string Desk::title() const {
    char time[40];
    std::snprintf(time, sizeof time, " - %.2f s%s", bench_.snapshot().stats.time,
                  bench_.snapshot().playing ? "" : ", paused");
    return bench_.document().title() + (bench_.dirty() ? "*" : "") + time + " - emberleaf";
}

bool Desk::working() const {
    return bench_.recording.state() == Recording::State::Running || browser_.working();
}

}  // namespace ember
