#include "ui/workbench.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <utility>

#include "app/preset_io/atomic_file.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/steering.h"
#include "sim/lighter.h"
#include "sim/param_table.h"
#include "ui/lighter_placement.h"

namespace ember {
namespace {

constexpr double kWatchEvery = 1.0;                     // [s]
constexpr double kSlowest = 1.0 / 16, kFastest = 16.0;  // [1] of real time

}  // namespace

Workbench::Workbench(Document document, UserFolders folders, Settings remembered, int threads,
                     std::function<void()> wake)
    : values(document.saved),
      settings(std::move(remembered)),
      document_(std::move(document)),
      folders_(std::move(folders)),
      other_(document_.saved),
      recovery_(folders_.state),
      session_(document_.saved.params, threads, std::move(wake)) {
    snapshot_ = session_.latest();
    Document opened = document_;
    take_document(std::move(opened));
    post([](Session& s) { s.play(); });
    for (const auto& file : recovery_.left_behind())
        say(Severity::Warning,
            "an earlier window ended before it was closed; what was done in it: " + file.string());
}

void Workbench::post(SessionThread::Command command) {
    last_edit_ = session_.post(std::move(command));
}

// Everything begins anew with what has been read or written.
void Workbench::take_document(Document document) {
    document_ = std::move(document);
    values = document_.saved;
    lighter = 0;
    history_.start(values);
    if (!shown.side_by_side) other_ = values;
    if (!document_.info.path.empty()) settings.remember(document_.info.path.string());
    for (const std::string& warning : plausibility_warnings(values.params))
        say(Severity::Warning, warning);
    post([params = values.params, script = document_.script](Session& s) {
        s.apply(params);
        if (s.tick_number() != 0) s.restart();
        s.follow_script(script);
    });
}

void Workbench::begin_frame(double now, bool busy) {
    now_ = now;
    snapshot_ = session_.latest();
    if (snapshot_->message != said_) {
        said_ = snapshot_->message;
        if (!said_.empty()) say(Severity::Error, said_);
    }
    // what was refused is taken back, and on the timeline the parameters are those of that tick
    if (!busy && caught_up() && compare(snapshot_->params, values.params) != ParamChange::None) {
        values.params = snapshot_->params;
        history_.adopt(values);
    }
    lighter = std::min(lighter, lighters_of(values.params).size() - 1);
    recording.poll(now);
    const bool recording_now = recording.state() == Recording::State::Running;
    if (was_recording_ && !recording_now) {
        if (recording.state() == Recording::State::Done)
            say(Severity::Info, "recorded " + recording.output().string());
        if (recording.state() == Recording::State::Failed)
            say(Severity::Error, "the recording failed: " + recording.problem());
    }
    was_recording_ = recording_now;
    if (busy) flight_.stop();
    if (const auto camera = flight_.at(now)) values.render.camera = *camera;
    if (recovery_.due(now)) keep_recovery();
    session_.want_springs(needs_springs(values.render.view.mode));
    if (now - watched_ >= kWatchEvery) watch_files();
}

void Workbench::end_frame(bool busy) {
    if (!busy && caught_up()) history_.settle(values);
    dirty_ = !unsaved().empty();
}

void Workbench::keep_recovery() {
    try {
        const bool something = dirty_ || !snapshot_->script->empty();
        if (something) recovery_.keep(take_of(*snapshot_), now_);
        if (!something) recovery_.forget();
    } catch (const std::exception& e) {
        say(Severity::Warning, e.what());
    }
}

std::vector<ShownChange> Workbench::unsaved() const {
    return shown_changes(document_.saved, values, false);
}

const Snapshot& Workbench::pictured() const {
    return shown.comparing && snapshot_->beside != nullptr ? *snapshot_->beside : *snapshot_;
}

void Workbench::apply() {
    post([params = values.params](Session& s) { s.apply(params); });
}

// Files that others write are read again, as long as nothing here would be lost by it.
void Workbench::watch_files() {
    watched_ = now_;
    if (!document_.changed_on_disk()) return;
    for (auto& [file, time] : document_.times) {
        std::error_code gone;
        time = std::filesystem::last_write_time(file, gone);  // say it once
    }
    if (dirty_)
        return say(Severity::Warning,
                   "the preset's file has changed; Ctrl+R reads it and drops what is not saved");
    open(document_.info.path, true);
}

void Workbench::open(const std::filesystem::path& path, bool discard) {
    if (dirty_ && !discard) {
        pending_ = path;
        shown.leaving = true;
        return;
    }
    try {
        Document opened = open_document(path);
        const bool same = opened.info.path == document_.info.path;
        take_document(std::move(opened));
        say(Severity::Info, (same ? "read again: " : "opened ") + document_.title());
        shown.browser = false;
    } catch (const std::exception& e) {
        say(Severity::Error, e.what());
    }
}

void Workbench::open_beside(const std::filesystem::path& path) {
    try {
        other_ = open_document(path).saved;
        shown.side_by_side = true;
        renew_beside();
        put_beside(true);
    } catch (const std::exception& e) {
        say(Severity::Error, e.what());
    }
}

bool Workbench::save_to(const std::filesystem::path& path) {
    try {
        document_ = save_document(document_, values, path);
        settings.remember(path.string());
        dirty_ = !unsaved().empty();
        say(Severity::Info, "saved " + path.string());
        return true;
    } catch (const std::exception& e) {
        say(Severity::Error, e.what());
        return false;
    }
}

void Workbench::answer(bool save, bool discard) {
    shown.leaving = false;
    if (save && document_.read_only) {
        shown.save_as = true;  // and then once more
        return;
    }
    if (save && !save_to(document_.info.path)) return;
    const std::filesystem::path path = std::exchange(pending_, {}).value_or("");
    if (!save && !discard) return;
    if (path.empty()) return quit();
    open(path, true);
}

void Workbench::quit() {
    recovery_.forget();
    requests.quit = true;
}

void Workbench::go_to(std::uint64_t tick) {
    post([tick](Session& s) { s.go_to(tick); });
}

void Workbench::set_speed(double speed) {
    speed_ = std::clamp(speed, kSlowest, kFastest);
    post([speed = speed_](Session& s) { s.set_speed(speed); });
}

LighterParams Workbench::lighter_now(std::size_t number) const {
    return lighters_of(values.params).at(number);
}

void Workbench::change_lighter(std::size_t number, const LighterParams& changed) {
    const bool edited = number == lighter;
    set_lighter(values.params, number, edited ? with_path(lighter_now(number), changed) : changed);
    apply();
}

LighterParams Workbench::with_path(const LighterParams& before, LighterParams now) const {
    if (now.x == before.x && now.y == before.y && now.z == before.z) return now;
    now.path.clear();
    if (!shown.recording_path) return now;
    now.path = before.path;
    extend_path(now, snapshot_->view.time, snapshot_->timeline.tick_duration);
    return now;
}

void Workbench::place_lighter(const Vector3& place) {
    LighterParams moved = lighter_now(lighter);
    const double time = snapshot_->view.time;
    const bool lit = lighter_lit(moved, time, snapshot_->timeline.tick_duration);
    move_lighter(moved, place, lit, time);
    change_lighter(lighter, moved);
}

std::string Workbench::take_of(const Snapshot& shot) const {
    PresetValues base = values;
    base.params = shot.base;
    return take_text(document_, base, *shot.script);
}

std::filesystem::path Workbench::save_take(const std::filesystem::path& folder) {
    std::filesystem::path file = numbered_file(folder, ".take");
    write_file(file, take_of(*snapshot_));
    return file;
}

std::filesystem::path Workbench::output_of(const RecordingOptions& options) const {
    return options.film ? numbered_file(folders_.videos, ".mp4")
                        : numbered_file(folders_.pictures, "") / "frame_####.png";
}

void Workbench::record(const RecordingOptions& options) {
    try {
        const std::filesystem::path take = save_take(folders_.state / "takes");
        recording.start(take, output_of(options), options, now_);
        was_recording_ = true;
    } catch (const std::exception& e) {
        say(Severity::Error, e.what());
    }
}

void Workbench::copy_recording(const RecordingOptions& options) {
    try {
        const std::filesystem::path take = save_take(folders_.state / "takes");
        requests.copy = command_line(render_words("emberleaf", take, output_of(options), options));
        say(Severity::Info, "copied; the take is " + take.string());
    } catch (const std::exception& e) {
        say(Severity::Error, e.what());
    }
}

std::filesystem::path Workbench::numbered_file(const std::filesystem::path& folder,
                                               const std::string& end) const {
    const std::string stem = document_.info.path.stem().string();
    for (int number = 1;; ++number) {
        char digits[16];
        std::snprintf(digits, sizeof digits, "_%04d", number);
        std::filesystem::path file = folder / ((stem.empty() ? "untitled" : stem) + digits + end);
        if (!std::filesystem::exists(file)) return file;
    }
}

std::vector<std::string> Workbench::command() const {
    std::vector<std::string> words = {"emberleaf", "render", document_.info.path.string()};
    PresetValues saved = document_.saved, now = values;
    now.params = snapshot_->params;
    const auto set = [&words](const std::string& assignment) {
        words.push_back("--set");
        words.push_back(assignment);
    };
    for (const std::string& assignment : assignments_between(saved.params, now.params))
        set(assignment);
    for (const ParamInfo& row : render_param_rows()) {
        if (row.value(&saved.render) != row.value(&now.render))
            set(std::string(row.key) + '=' + value_text(row, &now.render));
    }
    char time[32];
    std::snprintf(time, sizeof time, "%.6g", snapshot_->view.time);
    words.insert(words.end(), {"--at", time, "-o", document_.info.path.stem().string() + ".png"});
    return words;
}

}  // namespace ember
