#include "ui/overlays.h"

#include <imgui.h>

#include <cstdarg>
#include <cstdio>

#include "ui/theme.h"

namespace ember {
namespace {

constexpr ImGuiWindowFlags kOverlay =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav;
constexpr double kZeroCelsius = 273.15;  // [K]

// One line of a table: a name, and a value as printf writes it.
void line(const char* name, const char* format, ...) IM_FMTARGS(2);
void line(const char* name, const char* format, ...) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    va_list values;
    va_start(values, format);
    ImGui::TextV(format, values);
    va_end(values);
}

void statistics(const SessionStats& s, const FrameTimes& t) {
    const auto count = [](auto n) { return static_cast<long long>(n); };
    line("time", "%.2f s, tick %lld", s.time, count(s.tick));
    if (t.real_time > 0) line("speed", "%.2f \u00d7 real time", t.real_time);
    if (t.real_time == 0) line("speed", "%s", "paused");
    line("picture", "%.0f ms, tick %.1f ms", t.picture_ms, t.tick_ms);
    line("unburnt", "%lld", count(s.unburnt));
    line("burning", "%lld", count(s.burning));
    line("burnt out", "%lld", count(s.burnt_out));
    line("particles", "%lld", count(s.particles));
    line("cuts", "%lld", count(s.cuts));
    line("hottest", "%.0f \u00b0C", s.hottest - kZeroCelsius);
    line("mass", "%.2f g", 1e3 * s.mass);
    line("caliper", "%.0f \u00b5m", 1e6 * s.caliper);
    line("sub-steps", "%lld per tick", count(s.substeps));
    if (s.retries > 0) line("retried", "%lld ticks", count(s.retries));
    if (s.dropped >= 0.1) line("skipped", "%.1f s behind real time", s.dropped);
}

void statistics_window(const PanelModel& model) {
    const float gap = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(gap, ImGui::GetIO().DisplaySize.y - gap), ImGuiCond_Always,
                            ImVec2(0, 1));
    ImGui::SetNextWindowBgAlpha(0.55f);
    // the mouse goes through it to the picture
    if (ImGui::Begin("statistics", nullptr, kOverlay | ImGuiWindowFlags_NoInputs) &&
        ImGui::BeginTable("lines", 2)) {
        // fixed, so that the window does not breathe with its numbers
        ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 5.5f * gap);
        ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, 11.5f * gap);
        statistics(model.stats, model.times);
        ImGui::EndTable();
    }
    ImGui::End();
}

void messages(const PanelModel& model, float width) {
    if (model.message.empty() && model.warnings.empty() && !model.placing) return;
    const float gap = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(gap, gap));
    ImGui::SetNextWindowSize(ImVec2(width - 2 * gap, 0));
    ImGui::SetNextWindowBgAlpha(0.8f);
    if (ImGui::Begin("messages", nullptr, kOverlay | ImGuiWindowFlags_NoInputs)) {
        const auto say = [](const std::string& text, const ImVec4& colour) {
            ImGui::PushStyleColor(ImGuiCol_Text, colour);
            ImGui::TextWrapped("%s", text.c_str());
            ImGui::PopStyleColor();
        };
        if (!model.message.empty()) say(model.message, error_colour());
        for (const std::string& warning : model.warnings)
            say(warning, warning_colour());
        if (model.placing) ImGui::TextUnformatted("Click where the lighter should be; Esc stops.");
    }
    ImGui::End();
}

// Keys that do the same share a line.
void key_lines() {
    const auto all = key_bindings();
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::string names = all[i].name;
        const char* text = all[i].text;
        while (i + 1 < all.size() && all[i + 1].action == all[i].action) {
            names += std::string(" or ") + all[++i].name;
        }
        line(names.c_str(), "%s", text);
    }
}

void help_sheet(bool& open, float width) {
    const ImVec2 centre(0.5f * width, 0.5f * ImGui::GetIO().DisplaySize.y);
    ImGui::SetNextWindowPos(centre, ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Keys and mouse", &open, flags) &&
        ImGui::BeginTable("help", 2, ImGuiTableFlags_SizingFixedFit)) {
        key_lines();
        line("", "%s", "");
        for (const DragBinding& drag : drag_bindings())
            line(drag.name, "%s", drag.text);
        for (const MouseHint& hint : mouse_hints())
            line(hint.name, "%s", hint.text);
        ImGui::EndTable();
    }
    ImGui::End();
}

}  // namespace

void draw_overlays(PanelModel& model, float width) {
    if (model.show_statistics) statistics_window(model);
    messages(model, width);
    if (model.show_help) help_sheet(model.show_help, width);
}

}  // namespace ember
