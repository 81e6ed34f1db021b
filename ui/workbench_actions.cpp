// What keys, menus and buttons do.
#include <algorithm>
#include <array>
#include <exception>

#include "render/camera.h"
#include "sim/lighter.h"
#include "sim/param_table.h"
#include "ui/camera_text.h"
#include "ui/child_process.h"
#include "ui/workbench.h"

namespace ember {
namespace {

constexpr double kFlat = 0.04;  // [rad] of view
constexpr std::array kCameras = {"front", "three_quarter", "side", "back", "top", "low", "close"};

}  // namespace

void Workbench::act(Action action) {
    act_on_file(action);
    act_on_time(action);
    act_on_view(action);
    act_on_slots(action);
    act_on_panels(action);
    act_on_lighter(action);
}

void Workbench::act_on_file(Action action) {
    switch (action) {
        case Action::OpenBrowser:
            shown.browser = !shown.browser;
            break;
        case Action::OpenPath:
            shown.open_path = true;
            break;
        case Action::Save:
        case Action::SaveAs:
            pending_.reset();  // this is no answer to what was asked
            shown.save_as = action == Action::SaveAs || document_.read_only;
            if (!shown.save_as) save_to(document_.info.path);
            break;
        case Action::Reload:
            open(document_.info.path);
            break;
        case Action::SaveTake:
            try {
                say(Severity::Info, "saved " + save_take(folders_.state / "takes").string());
            } catch (const std::exception& e) {
                say(Severity::Error, e.what());
            }
            break;
        case Action::Screenshot:
            requests.screenshot = true;
            break;
        case Action::ScreenshotClear:
            requests.screenshot_clear = true;
            break;
        case Action::Record:
            shown.record = true;
            break;
        case Action::CopyCommand:
            requests.copy = command_line(command());
            say(Severity::Info, snapshot_->script->empty()
                                    ? "copied the command that draws this picture"
                                    : "copied; edits in mid-burn are only in a take (Ctrl+T)");
            break;
        case Action::CopyCamera:
            requests.copy = camera_text(values.render.camera);
            break;
        case Action::PasteCamera:
            requests.paste_camera = true;
            break;
        case Action::Undo:
        case Action::Redo:
            undo(action == Action::Redo);
            break;
        case Action::Quit:
            pending_ = std::filesystem::path();
            shown.leaving = dirty_;
            if (!dirty_) quit();
            break;
        default:
            break;
    }
}

void Workbench::undo(bool again) {
    const auto now = again ? history_.redo(values) : history_.undo(values);
    if (!now) return;
    values = *now;
    apply();
}

// A lighter that was lit by hand in mid-burn would leave the next burn waiting for it.
void Workbench::restart() {
    const auto before = lighters_of(document_.saved.params);
    auto now = lighters_of(values.params);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double start = i < before.size() ? before[i].start : 0.0;
        if (now[i].start <= start) continue;
        now[i].start = start;
        set_lighter(values.params, i, now[i]);
    }
    values.params.hand.on = false;
    post([params = values.params](Session& s) {
        s.apply(params);
        s.restart();
    });
}

void Workbench::act_on_time(Action action) {
    const TimelineSpan& time = snapshot_->timeline;
    const auto back = [&](std::uint64_t ticks) {
        post([ticks](Session& s) {
            s.pause();
            s.go_to(s.tick_number() - std::min(ticks, s.tick_number()));
        });
    };
    const auto forward = [&](int ticks) {
        post([ticks](Session& s) {
            for (int i = 0; i < ticks; ++i)
                s.step_once();
        });
    };
    switch (action) {
        case Action::TogglePlay:
            return post([](Session& s) { s.toggle(); });
        case Action::Step:
            return forward(1);
        case Action::StepTen:
            return forward(10);
        case Action::StepBack:
            return back(1);
        case Action::StepBackTen:
            return back(10);
        case Action::ToStart:
            return go_to(0);
        case Action::ToEnd:
            return go_to(time.end);
        case Action::Restart:
            return restart();
        case Action::Slower:
            return set_speed(speed_ / 2);
        case Action::Faster:
            return set_speed(speed_ * 2);
        case Action::ToggleLoop:
            loop_ = !loop_;
            return post([loop = loop_](Session& s) { s.set_loop(loop); });
        case Action::Retry:
            return post([](Session& s) { s.retry_with_smaller_step(); });
        default:
            return;
    }
}

void Workbench::look(std::string_view camera) {
    CameraParams goal = document_.saved.render.camera;
    look_from(goal, *find_camera_view(camera));
    fly_to(goal);
}

void Workbench::fly_to(const CameraParams& goal) {
    flight_.begin(values.render.camera, goal, now_);
}

// Nearly without perspective, as drawings are made, or with that of the preset again.
void Workbench::flatten_camera() {
    CameraParams goal = values.render.camera;
    const double usual = document_.saved.render.camera.field_of_view;
    const bool flat = goal.field_of_view < 2 * kFlat;
    change_lens(goal, !flat ? kFlat : usual > 2 * kFlat ? usual : CameraParams().field_of_view);
    fly_to(goal);
}

void Workbench::act_on_view(Action action) {
    ViewParams& view = values.render.view;
    const auto next = [&](std::size_t step) {
        camera_ = (camera_ + step) % kCameras.size();
        look(kCameras[camera_]);
    };
    switch (action) {
        case Action::NextView: {
            const ParamInfo& row = *find_param(render_param_rows(), "view.mode");
            const double mode = row.get(&values.render) + 1;
            row.set(&values.render, mode < static_cast<double>(row.choices.size()) ? mode : 0);
            return;
        }
        case Action::ToggleLegend:
            view.legend = !view.legend;
            return;
        case Action::ToggleFlames:
            view.flames = !view.flames;
            return;
        case Action::HomeCamera:
            return fly_to(document_.saved.render.camera);
        case Action::CameraFlat:
            return flatten_camera();
        case Action::CameraFront:
            return look("front");
        case Action::CameraSide:
            return look("side");
        case Action::CameraTop:
            return look("top");
        case Action::CameraThreeQuarter:
            return look("three_quarter");
        case Action::NextCamera:
            return next(1);
        case Action::PreviousCamera:
            return next(kCameras.size() - 1);
        default:
            return;
    }
}

void Workbench::act_on_panels(Action action) {
    switch (action) {
        case Action::FullScreen:
            requests.full_screen = true;
            return;
        case Action::TogglePanel:
            settings.show_panel = !settings.show_panel;
            return;
        case Action::ToggleInfo:
            settings.show_info = !settings.show_info;
            return;
        case Action::ToggleProfiler:
            settings.show_profiler = !settings.show_profiler;
            return;
        case Action::TogglePlots:
            settings.show_plots = !settings.show_plots;
            return;
        case Action::ToggleLog:
            shown.log = !shown.log;
            return;
        case Action::ToggleHelp:
            shown.help = !shown.help;
            return;
        case Action::Cancel:
            notices.dismiss();
            put_beside(shown.side_by_side);
            shown.help = shown.log = shown.browser = shown.placing = shown.record = false;
            shown.save_as = shown.open_path = shown.leaving = false;
            return;
        default:
            return;
    }
}

void Workbench::act_on_lighter(Action action) {
    const double now = snapshot_->view.time;
    switch (action) {
        case Action::PlaceLighter:
            shown.placing = !shown.placing;
            return;
        case Action::LightNow: {
            const LighterParams l = lighter_now(lighter);
            return place_lighter(lighter_position(l, now));
        }
        case Action::RecordPath:
            shown.recording_path = !shown.recording_path;
            return;
        case Action::AddLighter: {
            LighterParams added = lighter_now(lighter);
            added.x += 0.02;
            added.path.clear();
            if (values.params.lighters.empty()) values.params.lighters.emplace_back();
            values.params.lighters.emplace_back();
            lighter = values.params.lighters.size() - 1;
            set_lighter(values.params, lighter, added);
            return apply();
        }
        case Action::RemoveLighter:
            if (values.params.lighters.size() < 2) {
                LighterParams out = lighter_now(lighter);
                out.on = false;
                return change_lighter(lighter, out);
            }
            values.params.lighters.erase(values.params.lighters.begin() +
                                         static_cast<std::ptrdiff_t>(lighter));
            lighter = 0;
            return apply();
        default:
            return;
    }
}

}  // namespace ember
