// What a person works on in the window: values, burn, preset, history. No GL, no ImGui, no clock.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "ui/bindings.h"
#include "ui/camera_flight.h"
#include "ui/document.h"
#include "ui/edit_history.h"
#include "ui/notices.h"
#include "ui/recording.h"
#include "ui/recovery.h"
#include "ui/session_thread.h"
#include "ui/settings.h"
#include "ui/user_folders.h"

namespace ember {

/// Windows over the picture, and modes of the mouse.
struct Shown {
    bool help = false, log = false, browser = false, save_as = false, open_path = false,
         record = false, leaving = false;
    bool placing = false;         ///< the next click puts the lighter there
    bool recording_path = false;  ///< movements of the edited lighter become its path
    bool comparing = false;       ///< the key that shows the other slot is held
    bool side_by_side = false;
    std::array<char, 64> filter{};  ///< of the parameters in sight
};

/// What only the window can do.
struct WindowRequests {
    bool quit = false, full_screen = false, screenshot = false, screenshot_clear = false;
    std::optional<std::string> copy;  ///< to the clipboard
    bool paste_camera = false;
};

class Workbench {
  public:
    /// Opens with a burn of `document`, playing. `wake`: see SessionThread.
    Workbench(Document document, UserFolders folders, Settings settings, int threads,
              std::function<void()> wake = {});

    // ---- what panels show and edit: copies; apply() sends the simulation's part on
    PresetValues values;
    Shown shown;
    Settings settings;
    Notices notices;
    Recording recording;
    WindowRequests requests;
    std::size_t lighter = 0;  ///< the one that is edited

    /// Takes in what has happened. `now` [s] since the window opened; `busy`: a hand is on a widget
    /// or drags something, so that its values must not be touched.
    void begin_frame(double now, bool busy);
    /// Makes undo entries of gestures that have ended.
    void end_frame(bool busy);
    void act(Action action);
    /// Sends the edited parameters to the burn.
    void apply();

    [[nodiscard]] const Snapshot& snapshot() const { return *snapshot_; }
    /// What the picture shows: this burn, or the one beside it while they are compared.
    [[nodiscard]] const Snapshot& pictured() const;
    /// Whether the picture shows both slots.
    [[nodiscard]] bool both_shown() const {
        return shown.side_by_side && snapshot_->beside != nullptr;
    }
    [[nodiscard]] const Document& document() const { return document_; }
    [[nodiscard]] const EditHistory& history() const { return history_; }
    [[nodiscard]] const UserFolders& folders() const { return folders_; }
    /// In what the values differ from the preset's file.
    [[nodiscard]] std::vector<ShownChange> unsaved() const;
    [[nodiscard]] bool dirty() const { return dirty_; }
    /// "A" or "B": the slot that is edited.
    [[nodiscard]] const char* slot() const { return slot_b_ ? "B" : "A"; }
    [[nodiscard]] const PresetValues& other_slot() const { return other_; }
    [[nodiscard]] double speed() const { return speed_; }
    [[nodiscard]] bool loop() const { return loop_; }
    /// The camera is on its way.
    [[nodiscard]] bool flying() const { return flight_.flying(); }
    [[nodiscard]] bool caught_up() const { return snapshot_->commands >= last_edit_; }

    /// Opens a preset, a take or a picture; asks first when there are unsaved changes, unless
    /// `discard`. What cannot be opened changes nothing and says why.
    void open(const std::filesystem::path& path, bool discard = false);
    /// Into the other slot, beside what there is.
    void open_beside(const std::filesystem::path& path);
    /// Returns whether it is written.
    bool save_to(const std::filesystem::path& path);
    /// Whether something waits for an answer about unsaved changes: a file, or leaving the program.
    [[nodiscard]] bool pending() const { return pending_.has_value(); }
    void answer(bool save, bool discard);

    void go_to(std::uint64_t tick);
    void set_speed(double speed);
    /// Lighter `number` as it is in the values now.
    [[nodiscard]] LighterParams lighter_now(std::size_t number) const;
    void change_lighter(std::size_t number, const LighterParams& lighter);
    /// A lighter that was moved by hand, with the path that it has from then on: none, because it
    /// stays there, or, while paths are recorded, one that ends there now.
    [[nodiscard]] LighterParams with_path(const LighterParams& before, LighterParams now) const;
    /// Moves the edited lighter there, lit from now on unless it is.
    void place_lighter(const Vector3& place);
    /// What has led to a state, as the text of a take.
    [[nodiscard]] std::string take_of(const Snapshot& shot) const;
    /// Writes what was done so far as a take; returns its file.
    [[nodiscard]] std::filesystem::path save_take(const std::filesystem::path& folder);
    /// Starts a recording of the burn as it has been steered.
    void record(const RecordingOptions& options);
    /// Copies the command that would do so.
    void copy_recording(const RecordingOptions& options);
    /// The command that draws what the window shows.
    [[nodiscard]] std::vector<std::string> command() const;
    void say(Severity severity, const std::string& text) { notices.say(now_, severity, text); }
    [[nodiscard]] double now() const { return now_; }
    /// A file name that does not exist yet: folder/preset_0007.png.
    [[nodiscard]] std::filesystem::path numbered_file(const std::filesystem::path& folder,
                                                      const std::string& end) const;

  private:
    [[nodiscard]] std::filesystem::path output_of(const RecordingOptions& options) const;
    void take_document(Document document);
    void watch_files();
    void restart();
    void act_on_view(Action action);
    void act_on_slots(Action action);
    void act_on_panels(Action action);
    void act_on_lighter(Action action);
    void act_on_time(Action action);
    void act_on_file(Action action);
    void look(std::string_view camera);
    void fly_to(const CameraParams& goal);
    void flatten_camera();
    void keep_recovery();
    void quit();
    void undo(bool again);
    void swap_slots();
    void post(SessionThread::Command command);
    void put_beside(bool wanted);
    void renew_beside();

    Document document_;
    UserFolders folders_;
    PresetValues other_;  // the slot that is not edited
    EditHistory history_;
    CameraFlight flight_;
    Recovery recovery_;
    SessionThread session_;
    std::shared_ptr<const Snapshot> snapshot_;
    std::optional<std::filesystem::path> pending_;  // a file to open; empty: leaving
    std::uint64_t last_edit_ = 0;                   // number of its command
    std::string said_;                              // by the session, last
    double now_ = 0, watched_ = 0, speed_ = 1;      // [s]
    bool loop_ = false, slot_b_ = false, dirty_ = false, beside_ = false, was_recording_ = false;
    std::size_t camera_ = 0;
};

}  // namespace ember
