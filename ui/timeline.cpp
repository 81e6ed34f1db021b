#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "ui/panels.h"
#include "ui/speedometer.h"

namespace ember {
namespace {

constexpr float kPanelWidth = 26.0f;  // [font sizes]
constexpr double kLeastSpan = 5.0;    // [s] that the timeline shows

constexpr ImGuiWindowFlags kBar = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_NoBringToFrontOnFocus;

float bar_height() {
    return 2 * ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.y +
           2 * ImGui::GetStyle().FramePadding.y + ImGui::GetStyle().ItemSpacing.y;
}

float status_height() {
    return ImGui::GetFontSize() + 2 * ImGui::GetStyle().FramePadding.y + 2;
}

void transport(Workbench& bench) {
    const float size = 2.2f * ImGui::GetFontSize();
    const auto button = [&](Action action, const char* label, bool on = false, float width = 0) {
        action_button(bench, action, label, width > 0 ? width : size, on);
        ImGui::SameLine();
    };
    button(Action::ToStart, "|<");
    button(Action::StepBack, "<");
    button(Action::TogglePlay, bench.snapshot().playing ? "Pause###play" : "Play###play",
           bench.snapshot().playing, 1.7f * size);
    button(Action::Step, ">");
    button(Action::ToEnd, ">|");
    button(Action::Restart, "Restart", false, 2 * size);
    button(Action::ToggleLoop, "Loop", bench.loop(), 1.4f * size);
    button(Action::Slower, "-", false, 0.7f * size);
    ImGui::AlignTextToFramePadding();
    ImGui::Text("%g\u00d7", bench.speed());
    ImGui::SameLine();
    button(Action::Faster, "+", false, 0.7f * size);
    ImGui::Text("%.2f s", bench.snapshot().stats.time);
}

// The burn so far as a bar to drag along: what is kept, where something was edited, where it is.
void scrub_bar(Workbench& bench) {
    const TimelineSpan& t = bench.snapshot().timeline;
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const ImVec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight());
    const auto least = static_cast<std::uint64_t>(kLeastSpan / t.tick_duration);
    const std::uint64_t span = std::max(least, t.end + t.end / 8);
    const auto at = [&](std::uint64_t tick) {
        return from.x + size.x * static_cast<float>(tick) / static_cast<float>(span);
    };
    ImGui::InvisibleButton("scrub", size);
    if (ImGui::IsItemActive()) {
        const float share = std::clamp((ImGui::GetIO().MousePos.x - from.x) / size.x, 0.0f, 1.0f);
        const auto tick = static_cast<std::uint64_t>(std::lround(share * static_cast<float>(span)));
        if (std::min(tick, t.end) != t.cursor) bench.go_to(std::min(tick, t.end));
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to(from.x + size.x, from.y + size.y);
    const float third = size.y / 3, font = ImGui::GetFontSize();
    list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
    list.AddRectFilled(ImVec2(from.x, from.y + third), ImVec2(at(t.end), to.y - third),
                       ImGui::GetColorU32(ImGuiCol_ButtonHovered), 2);
    for (const std::uint64_t edit : t.edits)
        list.AddLine(ImVec2(at(edit), from.y), ImVec2(at(edit), to.y),
                     ImGui::GetColorU32(ImGuiCol_Text), 1);
    const float x = at(t.cursor);
    list.AddLine(ImVec2(x, from.y), ImVec2(x, to.y), ImGui::GetColorU32(ImGuiCol_CheckMark),
                 0.15f * font);
    list.AddTriangleFilled(ImVec2(x - 0.35f * font, from.y), ImVec2(x + 0.35f * font, from.y),
                           ImVec2(x, from.y + 0.45f * font),
                           ImGui::GetColorU32(ImGuiCol_CheckMark));
    if (!ImGui::IsItemHovered() || ImGui::IsItemActive()) return;
    const std::string kept = t.interval == 1
                                 ? "every state is kept"
                                 : "a state is kept every " + std::to_string(t.interval) + " ticks";
    char text[160];
    std::snprintf(text, sizeof text, "%.2f of %.2f s; %s, %.0f MB; lines are edits",
                  static_cast<double>(t.cursor) * t.tick_duration,
                  static_cast<double>(t.end) * t.tick_duration, kept.c_str(),
                  static_cast<double>(t.bytes) / 1e6);
    const float half = 0.5f * ImGui::CalcTextSize(text).x + 2 * font;
    const float middle = std::clamp(ImGui::GetIO().MousePos.x, half, std::max(half, to.x - half));
    ImGui::SetNextWindowPos(ImVec2(middle, from.y - 0.3f * font), ImGuiCond_Always,
                            ImVec2(0.5f, 1));
    ImGui::SetTooltip("%s", text);
}

}  // namespace

Layout layout_of(const Workbench& bench) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float font = ImGui::GetIO().Fonts->Fonts[0]->FontSize;
    Layout layout;
    const bool all = bench.settings.show_panel;
    layout.menu = all ? font + 2 * ImGui::GetStyle().FramePadding.y : 0;
    layout.panel = all ? std::min(kPanelWidth * font, 0.5f * display.x) : 0;
    layout.bottom = all ? bar_height() + status_height() : 0;
    layout.picture = {0, double(layout.menu), std::max(1.0, double(display.x - layout.panel)),
                      std::max(1.0, double(display.y - layout.menu - layout.bottom))};
    return layout;
}

void draw_timeline(const Layout& layout, Workbench& bench) {
    if (layout.bottom <= 0) return;
    const float top = static_cast<float>(layout.picture.y + layout.picture.height);
    ImGui::SetNextWindowPos(ImVec2(0, top));
    ImGui::SetNextWindowSize(ImVec2(static_cast<float>(layout.picture.width), bar_height()));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        ImVec2(ImGui::GetStyle().ItemSpacing.x, ImGui::GetStyle().FramePadding.y));
    if (ImGui::Begin("timeline", nullptr, kBar)) {
        scrub_bar(bench);
        transport(bench);
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

void draw_status_bar(const Layout& layout, const Workbench& bench, const FrameTimes& times) {
    if (layout.bottom <= 0) return;
    const Snapshot& shot = bench.snapshot();
    const float height = status_height();
    ImGui::SetNextWindowPos(ImVec2(0, ImGui::GetIO().DisplaySize.y - height));
    ImGui::SetNextWindowSize(ImVec2(static_cast<float>(layout.picture.width), height));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ImGui::GetStyle().ItemSpacing.x, 1));
    if (ImGui::Begin("status", nullptr, kBar)) {
        char text[240];
        int used = std::snprintf(text, sizeof text, "tick %llu   sim %.1f ms   picture %.0f ms   ",
                                 static_cast<unsigned long long>(shot.stats.tick),
                                 1e3 * shot.stats.tick_seconds, times.picture_ms);
        const auto add = [&](const char* format, auto... values) {
            const auto size = static_cast<std::size_t>(used);
            if (size < sizeof text)
                used += std::snprintf(text + size, sizeof text - size, format, values...);
        };
        if (times.real_time > 0) add("%.2f\u00d7 real time   ", times.real_time);
        if (times.real_time == 0) add("%s   ", shot.stopped ? "stopped" : "paused");
        if (shot.stats.dropped >= 0.1) add("%.1f s not simulated in time   ", shot.stats.dropped);
        add("seed %lld   ", static_cast<long long>(shot.params.numerics.seed));
        if (shot.hash != 0) add("%016llx", static_cast<unsigned long long>(shot.hash));
        ImGui::TextDisabled("%s", text);
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace ember
