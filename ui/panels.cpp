#include "ui/panels.h"

#include <imgui.h>

#include "sim/param_table.h"
#include "ui/bindings.h"
#include "ui/param_widgets.h"

namespace ember {
namespace {

// The parameters that the design of the program puts first.
constexpr const char* kFirst[] = {"paper.grammage", "paper.density", "paper.c_s",
                                  "shrinkage.factor"};
constexpr const char* kLighter[] = {"lighter.on", "lighter.x", "lighter.y", "lighter.z"};

void transport(const PanelModel& model, PanelRequests& requests) {
    const float width =
        (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
    requests.toggle_play = ImGui::Button(model.playing ? "Pause" : "Play", ImVec2(width, 0));
    ImGui::SameLine();
    requests.step = ImGui::Button("Step", ImVec2(width, 0));
    ImGui::SameLine();
    requests.restart = ImGui::Button("Restart", ImVec2(width, 0));
}

// Puts the lighter below a lower corner of the hanging sheet, or below the middle of its edge.
bool lighter_buttons(Params& params) {
    const SheetParams& sheet = params.sheet;
    const bool hanging = sheet.pose == SheetPose::Hanging;
    const double below = sheet.elevation - (hanging ? sheet.height : 0.0) - 0.02;
    const double half = 0.5 * (hanging ? sheet.width : sheet.height);
    bool moved = false;
    const auto offer = [&](const char* text, double x) {
        if (!ImGui::SmallButton(text)) return;
        params.lighter.x = x;
        params.lighter.y = below;
        params.lighter.z = 0;
        moved = true;
    };
    offer("left corner", -half + 0.005);
    ImGui::SameLine();
    offer("middle", 0.0);
    ImGui::SameLine();
    offer("right corner", half - 0.005);
    return moved;
}

void statistics(const PanelModel& model) {
    const SessionStats& s = model.stats;
    ImGui::Text("t = %.2f s   tick %llu", s.time, static_cast<unsigned long long>(s.tick));
    ImGui::Text("unburnt %lld  burning %lld  burnt %lld", static_cast<long long>(s.unburnt),
                static_cast<long long>(s.burning), static_cast<long long>(s.burnt_out));
    ImGui::Text("particles %zu  cuts %lld  hottest %.0f degC", s.particles,
                static_cast<long long>(s.cuts), s.hottest - 273.15);
    ImGui::Text("caliper %.0f um  sub-steps %lld", 1e6 * caliper(model.params.paper),
                static_cast<long long>(s.substeps));
    ImGui::Text("%.0f ms per picture", model.frame_ms);
    if (s.dropped > 0) ImGui::TextDisabled("%.1f s slower than real time", s.dropped);
    if (s.retries > 0) ImGui::TextDisabled("%lld ticks retried", static_cast<long long>(s.retries));
}

bool rows_by_key(std::span<const char* const> keys, PanelModel& model, const Params& defaults) {
    bool changed = false;
    for (const char* key : keys) {
        const ParamInfo& row = *find_param(sim_param_rows(), key);
        changed = param_widget(row, &model.params, &model.preset_params, &defaults) || changed;
    }
    return changed;
}

void main_panel(PanelModel& model, PanelRequests& requests) {
    static const Params kDefaults;
    static const RenderParams kRenderDefaults;
    ImGui::TextWrapped("%s", model.title.c_str());
    transport(model, requests);
    if (!model.message.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.45f, 0.35f, 1.0f));
        ImGui::TextWrapped("%s", model.message.c_str());
        ImGui::PopStyleColor();
    }
    ImGui::Separator();
    bool changed = rows_by_key(kFirst, model, kDefaults);
    ImGui::TextDisabled("lighter");
    changed = rows_by_key(kLighter, model, kDefaults) || changed;
    changed = lighter_buttons(model.params) || changed;
    ImGui::Separator();
    statistics(model);
    ImGui::Separator();
    ImGui::TextDisabled("everything");
    changed = param_groups(bind(model.params), &model.preset_params, &kDefaults) || changed;
    param_groups(bind(model.render), &model.preset_render, &kRenderDefaults);
    ImGui::TextDisabled("F1 shows all keys");
    requests.params_changed = changed;
}

void help_sheet(bool& open) {
    const ImVec2 centre = ImGui::GetMainViewport()->GetCenter();
    ImGui::SetNextWindowPos(centre, ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("Keys and mouse", &open, flags)) {
        const float column = ImGui::GetFontSize() * 15.0f;
        for (const Binding& binding : bindings()) {
            ImGui::TextUnformatted(binding.keys);
            ImGui::SameLine(column);
            ImGui::TextUnformatted(binding.text);
        }
        ImGui::Separator();
        for (const MouseHint& hint : mouse_hints()) {
            ImGui::TextUnformatted(hint.gesture);
            ImGui::SameLine(column);
            ImGui::TextUnformatted(hint.text);
        }
    }
    ImGui::End();
}

}  // namespace

PanelRequests draw_panels(PanelModel& model) {
    PanelRequests requests;
    if (model.show_panel) {
        const ImVec2 display = ImGui::GetIO().DisplaySize;
        ImGui::SetNextWindowPos(ImVec2(0, 0));
        ImGui::SetNextWindowSize(ImVec2(ImGui::GetFontSize() * 22.0f, display.y));
        const ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;
        if (ImGui::Begin("emberleaf", nullptr, flags)) main_panel(model, requests);
        ImGui::End();
    }
    if (model.show_help) help_sheet(model.show_help);
    return requests;
}

}  // namespace ember
