#include <imgui.h>

#include <string>

#include "sim/param_table.h"
#include "ui/panels.h"
#include "ui/theme.h"

namespace ember {
namespace {

constexpr const char* kMenus[] = {"File", "Edit", "Time", "View", "Lighter", "Help"};

bool checked(const Workbench& bench, Action action) {
    switch (action) {
        case Action::ToggleLoop:
            return bench.loop();
        case Action::ToggleLegend:
            return bench.values.render.view.legend;
        case Action::ToggleFlames:
            return bench.values.render.view.flames;
        case Action::SideBySide:
            return bench.shown.side_by_side;
        case Action::PlaceLighter:
            return bench.shown.placing;
        case Action::RecordPath:
            return bench.shown.recording_path;
        case Action::ToggleHelp:
            return bench.shown.help;
        case Action::ToggleInfo:
            return bench.settings.show_info;
        case Action::ToggleProfiler:
            return bench.settings.show_profiler;
        case Action::TogglePlots:
            return bench.settings.show_plots;
        case Action::ToggleLog:
            return bench.shown.log;
        default:
            return false;
    }
}

// What an entry would undo or redo says so in the menu.
std::string entry_text(const Workbench& bench, const KeyBinding& binding) {
    std::string text = binding.text;
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    const std::string what = binding.action == Action::Undo   ? bench.history().undo_text()
                             : binding.action == Action::Redo ? bench.history().redo_text()
                                                              : "";
    return what.empty() ? text : text + "   " + what;
}

bool possible(const Workbench& bench, Action action) {
    if (action == Action::Undo) return !bench.history().undo_text().empty();
    if (action == Action::Redo) return !bench.history().redo_text().empty();
    if (action == Action::Retry) return bench.snapshot().stopped;
    return true;
}

void entries(Workbench& bench, std::string_view menu) {
    Action last = Action::Cancel;
    for (const KeyBinding& binding : key_bindings()) {
        if (binding.menu != menu || binding.action == last) continue;
        last = binding.action;
        if (ImGui::MenuItem(entry_text(bench, binding).c_str(), binding.name,
                            checked(bench, binding.action), possible(bench, binding.action)))
            bench.act(binding.action);
    }
}

void recent(Workbench& bench) {
    if (!ImGui::BeginMenu("Recent presets", !bench.settings.recent.empty())) return;
    const std::vector<std::string> paths = bench.settings.recent;  // opening changes the list
    for (const std::string& path : paths) {
        if (ImGui::MenuItem(path.c_str())) bench.open(path);
    }
    ImGui::EndMenu();
}

void views(Workbench& bench) {
    if (!ImGui::BeginMenu("Show")) return;
    const ParamInfo& row = *find_param(render_param_rows(), "view.mode");
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const auto mode = static_cast<double>(i);
        if (ImGui::MenuItem(std::string(row.choices[i]).c_str(), nullptr,
                            row.get(&bench.values.render) == mode))
            row.set(&bench.values.render, mode);
    }
    ImGui::EndMenu();
}

void schemes(Workbench& bench) {
    if (!ImGui::BeginMenu("Camera as in")) return;
    constexpr const char* kNames[] = {"viewers", "Blender", "Maya"};
    for (int i = 0; i < 3; ++i) {
        const auto scheme = static_cast<CameraScheme>(i);
        if (ImGui::MenuItem(kNames[i], nullptr, bench.settings.scheme == scheme))
            bench.settings.scheme = scheme;
    }
    ImGui::EndMenu();
}

}  // namespace

void action_button(Workbench& bench, Action action, const char* label, float width, bool pressed) {
    const KeyBinding& binding = binding_of(action);
    const ImVec4 colour =
        ImGui::GetStyleColorVec4(pressed ? ImGuiCol_ButtonActive : ImGuiCol_Button);
    ImGui::PushStyleColor(ImGuiCol_Button, colour);
    if (ImGui::Button(label, ImVec2(width, 0))) bench.act(action);
    ImGui::PopStyleColor();
    if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
    if (binding.name[0] == '\0') ImGui::SetTooltip("%s", binding.text);
    if (binding.name[0] != '\0') ImGui::SetTooltip("%s (%s)", binding.text, binding.name);
}

void draw_menu_bar(const Layout& layout, Workbench& bench) {
    if (layout.menu <= 0 || !ImGui::BeginMainMenuBar()) return;
    for (const char* menu : kMenus) {
        if (!ImGui::BeginMenu(menu)) continue;
        entries(bench, menu);
        if (std::string_view(menu) == "File") recent(bench);
        if (std::string_view(menu) == "View") {
            views(bench);
            schemes(bench);
        }
        ImGui::EndMenu();
    }
    const std::string title = bench.document().title() + (bench.dirty() ? " (modified)" : "");
    const float width = ImGui::CalcTextSize(title.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width - ImGui::GetFontSize());
    if (bench.dirty()) ImGui::TextColored(warning_colour(), "%s", title.c_str());
    if (!bench.dirty()) ImGui::TextDisabled("%s", title.c_str());
    ImGui::EndMainMenuBar();
}

}  // namespace ember
