#include "ui/dialogs.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "ui/panels.h"
#include "ui/theme.h"

namespace ember {
namespace {

constexpr ImGuiWindowFlags kDialog = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
constexpr int kMostListed = 12;  // changes

// In the middle of the picture.
bool begin(const char* title, bool* open, const Workbench& bench) {
    const PictureRect r = layout_of(bench).picture;
    ImGui::SetNextWindowPos(
        ImVec2(static_cast<float>(r.x + 0.5 * r.width), static_cast<float>(r.y + 0.45 * r.height)),
        ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    return ImGui::Begin(title, open, kDialog);
}

float wide(float fonts) {
    return fonts * ImGui::GetFontSize();
}

// A name becomes a file: letters, digits, - and _ stay.
std::string file_name(const std::string& name) {
    std::string file;
    for (const char c : name) {
        const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
        if (plain || static_cast<unsigned char>(c) >= 0x80u) file += c;
        if (c == ' ') file += '_';
    }
    return file;
}

}  // namespace

void Dialogs::draw(Workbench& bench) {
    if (bench.shown.save_as) save_as(bench);
    if (bench.shown.open_path) open_path(bench);
    if (bench.shown.leaving) leaving(bench);
    if (bench.shown.record) record(bench);
    if (bench.snapshot().stopped) stopped(bench);
    asked_name_ = bench.shown.save_as;
    asked_path_ = bench.shown.open_path;
    asked_record_ = bench.shown.record;
}

void Dialogs::save_as(Workbench& bench) {
    if (!asked_name_) {
        const std::string stem = bench.document().info.path.stem().string() + "_mine";
        std::snprintf(name_, sizeof name_, "%s", stem.c_str());
    }
    if (begin("Save the preset as", &bench.shown.save_as, bench)) {
        if (bench.document().read_only)
            ImGui::TextDisabled("This preset comes with the program and stays as it is.");
        ImGui::SetNextItemWidth(wide(22));
        if (!asked_name_) ImGui::SetKeyboardFocusHere();
        const bool entered =
            ImGui::InputText("##name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue);
        const std::string file = file_name(name_);
        const auto path = bench.folders().presets / (file + ".toml");
        const bool exists = std::filesystem::exists(path);
        ImGui::TextDisabled("%s", path.string().c_str());
        if (exists) ImGui::TextColored(warning_colour(), "There is one of that name.");
        ImGui::BeginDisabled(file.empty());
        const bool pressed = ImGui::Button(exists ? "Replace it###save" : "Save###save");
        ImGui::EndDisabled();
        if (!file.empty() && (pressed || entered) && bench.save_to(path)) {
            bench.shown.save_as = false;
            if (bench.pending()) bench.answer(false, true);
        }
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) bench.shown.save_as = false;
    }
    ImGui::End();
}

void Dialogs::open_path(Workbench& bench) {
    if (begin("Open a preset, a take or a picture", &bench.shown.open_path, bench)) {
        ImGui::SetNextItemWidth(wide(34));
        if (!asked_path_) ImGui::SetKeyboardFocusHere();
        const bool entered =
            ImGui::InputText("##path", path_, sizeof path_, ImGuiInputTextFlags_EnterReturnsTrue);
        if ((ImGui::Button("Open") || entered) && path_[0] != '\0') {
            bench.shown.open_path = false;
            bench.open(path_);
        }
        ImGui::SameLine();
        if (ImGui::Button("Cancel")) bench.shown.open_path = false;
        ImGui::SameLine();
        ImGui::TextDisabled("or drop a file on the window");
    }
    ImGui::End();
}

void Dialogs::leaving(Workbench& bench) {
    if (begin("Unsaved changes", &bench.shown.leaving, bench)) {
        const auto changes = bench.unsaved();
        ImGui::Text("%s has %zu unsaved change%s:", bench.document().title().c_str(),
                    changes.size(), changes.size() == 1 ? "" : "s");
        int listed = 0;
        for (const ShownChange& c : changes) {
            if (++listed > kMostListed) break;
            ImGui::BulletText("%s: %s \u2192 %s", c.key.c_str(), c.from.c_str(), c.to.c_str());
        }
        if (listed > kMostListed) ImGui::TextDisabled("and more");
        ImGui::Spacing();
        if (ImGui::Button(bench.document().read_only ? "Save as ...###keep" : "Save###keep"))
            bench.answer(true, false);
        ImGui::SameLine();
        if (ImGui::Button("Discard them")) bench.answer(false, true);
        ImGui::SameLine();
        if (ImGui::Button("Go on editing")) bench.answer(false, false);
    }
    ImGui::End();
}

void Dialogs::stopped(Workbench& bench) {
    if (begin("The burn has stopped", nullptr, bench)) {
        ImGui::PushTextWrapPos(wide(30));
        ImGui::TextUnformatted(bench.snapshot().message.c_str());
        ImGui::PopTextWrapPos();
        ImGui::Spacing();
        action_button(bench, Action::Retry, "Retry with smaller step");
        ImGui::SameLine();
        action_button(bench, Action::StepBackTen, "Ten ticks back");
        ImGui::SameLine();
        action_button(bench, Action::Restart, "Restart");
    }
    ImGui::End();
}

void Dialogs::record(Workbench& bench) {
    const Recording& recording = bench.recording;
    const bool running = recording.state() == Recording::State::Running;
    if (!asked_record_) {  // what has burnt so far
        const TimelineSpan& t = bench.snapshot().timeline;
        const double seconds = static_cast<double>(t.end) * t.tick_duration;
        options_.frames = std::max(1, static_cast<int>(seconds * options_.fps + 0.5));
    }
    if (begin("Record the burn from its start", &bench.shown.record, bench)) {
        ImGui::BeginDisabled(running);
        ImGui::PushItemWidth(wide(9));
        ImGui::InputInt("frames", &options_.frames);
        ImGui::InputDouble("frames per second", &options_.fps, 1, 10, "%g");
        ImGui::InputInt("width", &options_.width, 16);
        ImGui::InputInt("height", &options_.height, 16);
        ImGui::InputDouble("turntable, degrees", &options_.turntable, 15, 90, "%g");
        ImGui::PopItemWidth();
        options_.frames = std::clamp(options_.frames, 1, 100000);
        options_.fps = std::clamp(options_.fps, 1.0, 1000.0);
        options_.width = std::clamp(options_.width, 16, 16384);
        options_.height = std::clamp(options_.height, 16, 16384);
        ImGui::Checkbox("transparent", &options_.transparent);
        ImGui::Checkbox("a film (MP4, needs ffmpeg) instead of numbered pictures", &options_.film);
        ImGui::TextDisabled("%d frames are %.1f s; edits so far are replayed as they were made",
                            options_.frames, options_.frames / options_.fps);
        const bool entered = ImGui::IsWindowFocused() && !ImGui::GetIO().WantTextInput &&
                             ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
        if (ImGui::Button("Record") || (entered && !running)) bench.record(options_);
        ImGui::EndDisabled();
        ImGui::SameLine();
        if (ImGui::Button("Copy as command line")) bench.copy_recording(options_);
        ImGui::SameLine();
        if (ImGui::Button("Close")) bench.shown.record = false;
        if (running) {
            const float share = static_cast<float>(recording.done()) /
                                static_cast<float>(std::max(1, recording.total()));
            char text[64];
            std::snprintf(text, sizeof text, "%d of %d, %.0f s left", recording.done(),
                          recording.total(), std::max(0.0, recording.left()));
            ImGui::ProgressBar(share, ImVec2(wide(22), 0), recording.left() < 0 ? "" : text);
            ImGui::SameLine();
            if (ImGui::Button("Cancel")) bench.recording.cancel();
        }
        if (!recording.output().empty())
            ImGui::TextDisabled("%s", recording.output().string().c_str());
    }
    ImGui::End();
}

}  // namespace ember
