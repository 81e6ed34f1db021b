#include "ui/overlays.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <string>

#include "ui/pick.h"
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

// An overlay at the lower edge of the picture, so far from its left [font sizes], that lets the
// mouse through; ends with end_corner().
bool begin_corner(const char* name, const Layout& layout, float from_left, float width) {
    const float gap = ImGui::GetFontSize();
    const PictureRect& r = layout.picture;
    ImGui::SetNextWindowPos(ImVec2(from_left * gap, static_cast<float>(r.y + r.height) - gap),
                            ImGuiCond_Always, ImVec2(0, 1));
    ImGui::SetNextWindowBgAlpha(0.6f);
    if (!ImGui::Begin(name, nullptr, kOverlay | ImGuiWindowFlags_NoInputs) ||
        !ImGui::BeginTable("lines", 2))
        return false;
    // fixed, so that the window does not breathe with its numbers
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 6.0f * gap);
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, width * gap);
    return true;
}

void end_corner(bool open) {
    if (open) ImGui::EndTable();
    ImGui::End();
}

void figures(const Layout& layout, const Snapshot& shot) {
    const bool open = begin_corner("figures", layout, 1.0f, 7.5f);
    const auto count = [](auto n) { return static_cast<long long>(n); };
    const SessionStats& s = shot.stats;
    if (open) {
        line("unburnt", "%lld nodes", count(s.unburnt));
        line("burning", "%lld", count(s.burning));
        line("burnt out", "%lld", count(s.burnt_out));
        line("particles", "%lld", count(s.particles));
        line("cuts", "%lld", count(s.cuts));
        line("hottest", "%.0f \u00b0C", s.hottest - kZeroCelsius);
        line("mass", "%.2f g", 1e3 * s.mass);
        line("heat", "%.3g J", s.heat);
        if (s.retries > 0) line("retried", "%lld ticks", count(s.retries));
    }
    end_corner(open);
}

void profiler(const Layout& layout, const Snapshot& shot) {
    const bool open = begin_corner("profiler", layout, 18.5f, 8.5f);
    if (open) {
        const double whole = std::max(1e-9, shot.stats.tick_seconds);
        for (std::size_t i = 0; i < kStageCount; ++i) {
            const double seconds = shot.stats.stage_seconds[i];
            line(std::string(kStageNames[i]).c_str(), "%.2f ms  %.0f %%", 1e3 * seconds,
                 100 * seconds / whole);
        }
        line("whole tick", "%.2f ms", 1e3 * shot.stats.tick_seconds);
    }
    end_corner(open);
}

// Keys that do the same share a line.
void key_lines(std::string_view menu) {
    const auto all = key_bindings();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].menu != menu || all[i].key == 0) continue;
        std::string names = all[i].name;
        const char* text = all[i].text;
        while (i + 1 < all.size() && all[i + 1].action == all[i].action)
            names += std::string(", ") + all[++i].name;
        line(names.c_str(), "%s", text);
    }
}

// A part of the sheet: a title, and names in front of what they do, of those widths [font sizes].
template <class Lines>
void section(const char* title, float width, float text_width, Lines&& lines) {
    ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", title);
    if (!ImGui::BeginTable(title, 2, ImGuiTableFlags_NoHostExtendX)) return;
    const float font = ImGui::GetFontSize();
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, width * font);
    ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthFixed, text_width * font);
    lines();
    ImGui::EndTable();
}

void key_columns() {
    const auto keys = [](const char* menu) {
        section(menu, 8.7f, 14.5f, [menu] { key_lines(menu); });
    };
    ImGui::BeginGroup();
    keys("File");
    keys("Edit");
    ImGui::EndGroup();
    ImGui::SameLine(0, ImGui::GetFontSize());
    ImGui::BeginGroup();
    keys("Time");
    keys("Lighter");
    ImGui::EndGroup();
    ImGui::SameLine(0, ImGui::GetFontSize());
    ImGui::BeginGroup();
    section("View", 8.7f, 14.5f, [] {
        key_lines("View");
        key_lines("");
    });
    keys("Help");
    ImGui::EndGroup();
}

void help_sheet(Workbench& bench) {
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(0.5f * display.x, 0.5f * display.y), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Keys and mouse", &bench.shown.help, flags)) {
        key_columns();
        ImGui::BeginGroup();
        section("Mouse on the picture", 12, 13, [&] {
            for (const DragBinding& drag : drag_bindings()) {
                if (in_scheme(drag, bench.settings.scheme)) line(drag.name, "%s", drag.text);
            }
        });
        ImGui::EndGroup();
        ImGui::SameLine(0, 2 * ImGui::GetFontSize());
        ImGui::BeginGroup();
        section("Mouse elsewhere", 12, 23, [&] {
            for (const MouseHint& hint : mouse_hints())
                line(hint.name, "%s", hint.text);
        });
        ImGui::EndGroup();
    }
    ImGui::End();
}

ImVec4 colour_of(Severity severity) {
    if (severity == Severity::Error) return error_colour();
    if (severity == Severity::Warning) return warning_colour();
    return ImGui::GetStyleColorVec4(ImGuiCol_Text);
}

void toasts(const Layout& layout, const Workbench& bench) {
    const auto fresh = bench.notices.fresh(bench.now());
    const bool placing = bench.shown.placing, comparing = bench.shown.comparing;
    const bool begins =
        (comparing || bench.shown.side_by_side) && bench.snapshot().beside == nullptr;
    if (fresh.empty() && !placing && !comparing && !begins) return;
    const float gap = ImGui::GetFontSize(), width = static_cast<float>(layout.picture.width);
    ImGui::SetNextWindowPos(ImVec2(gap, static_cast<float>(layout.picture.y) + gap));
    ImGui::SetNextWindowSize(ImVec2(std::min(width - 2 * gap, 44 * gap), 0));
    ImGui::SetNextWindowBgAlpha(0.85f);
    if (ImGui::Begin("messages", nullptr, kOverlay | ImGuiWindowFlags_NoInputs)) {
        for (const Notice* notice : fresh) {
            ImGui::PushStyleColor(ImGuiCol_Text, colour_of(notice->severity));
            ImGui::TextWrapped("%s", notice->text.c_str());
            ImGui::PopStyleColor();
        }
        if (placing) ImGui::TextUnformatted("Click where the lighter should be; Esc stops.");
        if (begins) ImGui::TextUnformatted("The other slot begins to burn ...");
        if (comparing && bench.snapshot().beside != nullptr)
            ImGui::Text("Slot %s at %.2f s", bench.slot()[0] == 'A' ? "B" : "A",
                        bench.snapshot().beside->stats.time);
    }
    ImGui::End();
}

void log_window(const Layout& layout, Workbench& bench) {
    const auto width = static_cast<float>(layout.picture.width);
    const auto height = static_cast<float>(layout.picture.height);
    ImGui::SetNextWindowPos(ImVec2(0.1f * width, layout.menu + 0.1f * height));
    ImGui::SetNextWindowSize(ImVec2(0.8f * width, 0.8f * height));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Messages so far", &bench.shown.log, flags)) {
        for (const Notice& notice : bench.notices.all()) {
            ImGui::TextDisabled("%7.1f s", notice.time);
            ImGui::SameLine();
            ImGui::PushStyleColor(ImGuiCol_Text, colour_of(notice.severity));
            ImGui::TextWrapped("%s", notice.text.c_str());
            ImGui::PopStyleColor();
        }
        if (bench.notices.all().empty()) ImGui::TextDisabled("none");
    }
    ImGui::End();
}

// The largest stress [Pa] of the structural springs at a node; 0 without springs.
double stress_at(const Snapshot& shot, const Pick& pick) {
    double largest = 0;
    if (pick.sheet >= shot.springs.size()) return 0;
    const auto node = static_cast<Index>(pick.node);
    for (const SpringSegment& spring : shot.springs[pick.sheet]) {
        if (spring.a != node && spring.b != node) continue;
        if (std::abs(spring.stress) > std::abs(largest)) largest = spring.stress;
    }
    return largest;
}

// Which half of the picture is which.
void slot_names(const Layout& layout, const Workbench& bench) {
    const bool a = bench.slot()[0] == 'A';
    const PictureRect& r = layout.picture;
    const float gap = ImGui::GetFontSize(), right = static_cast<float>(r.x + r.width);
    const float middle = static_cast<float>(r.x + 0.5 * r.width);
    const float y = static_cast<float>(r.y) + gap;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
    const std::string left_name = std::string(a ? "A" : "B") + ", edited";
    const std::string right_name =
        std::string(a ? "B" : "A") + (bench.snapshot().beside == nullptr ? ", begins ..." : "");
    list.AddText(ImVec2(middle - gap - ImGui::CalcTextSize(left_name.c_str()).x, y), colour,
                 left_name.c_str());
    list.AddText(ImVec2(right - gap - ImGui::CalcTextSize(right_name.c_str()).x, y), colour,
                 right_name.c_str());
    list.AddLine(ImVec2(middle, static_cast<float>(r.y)),
                 ImVec2(middle, static_cast<float>(r.y + r.height)), IM_COL32(0, 0, 0, 255), 2);
}

}  // namespace

void draw_probe(const PictureCamera& picture, const Snapshot& shot) {
    const auto mouse = mouse_in(picture.rect);
    if (!mouse || ImGui::IsAnyMouseDown()) return;
    const auto hit = pick_sheet(shot.view, picture.eye(), picture.ray(*mouse));
    if (!hit) return;
    const SheetView& sheet = shot.view.sheets[hit->sheet];
    constexpr const char* kPhases[] = {"unburnt", "burning", "burnt out"};
    const Index site = sheet.site[hit->node];
    ImGui::BeginTooltip();
    ImGui::TextDisabled("sheet %zu, row %d, column %d, node %zu", hit->sheet + 1,
                        static_cast<int>(site / sheet.column_count),
                        static_cast<int>(site % sheet.column_count), hit->node);
    ImGui::Text("%.0f \u00b0C, %s", sheet.temperature[hit->node] - kZeroCelsius,
                kPhases[static_cast<std::size_t>(sheet.phase[hit->node])]);
    ImGui::Text("%.0f %% of its mass", 100 * sheet.mass[hit->node] / sheet.initial_mass[hit->node]);
    if (!shot.springs.empty()) ImGui::Text("stress %.3g Pa", stress_at(shot, *hit));
    ImGui::EndTooltip();
}

void draw_overlays(const Layout& layout, Workbench& bench, const PlotData& plots) {
    const Snapshot& shot = bench.pictured();
    if (bench.both_shown()) slot_names(layout, bench);
    if (bench.settings.show_info) figures(layout, shot);
    if (bench.settings.show_profiler) profiler(layout, shot);
    if (bench.settings.show_plots) draw_plots(layout.picture, plots, shot);
    toasts(layout, bench);
    if (bench.shown.log) log_window(layout, bench);
    if (bench.shown.help) help_sheet(bench);
}

}  // namespace ember
