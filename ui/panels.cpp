#include "ui/panels.h"

#include <imgui.h>

#include <algorithm>

#include "sim/lighter.h"
#include "sim/param_table.h"
#include "ui/overlays.h"
#include "ui/param_widgets.h"

namespace ember {
namespace {

constexpr float kPanelWidth = 25.0f;   // [font sizes]
constexpr float kLeastGroups = 10.0f;  // [font sizes] height kept for the collapsing groups

// The parameters that the design of the program puts first, always in sight.
constexpr std::string_view kFirst[] = {"paper.grammage", "paper.density", "paper.c_s",
                                       "shrinkage.factor"};
constexpr std::string_view kLighter[] = {"lighter.on", "lighter.x", "lighter.y", "lighter.z"};
constexpr std::string_view kElsewhere[] = {"paper.grammage",   "paper.density", "paper.c_s",
                                           "shrinkage.factor", "lighter.on",    "lighter.x",
                                           "lighter.y",        "lighter.z"};
// a shot is what `emberleaf render` draws; it changes nothing in the window
constexpr std::string_view kHidden[] = {"shot"};

// `count` buttons of equal width in one line.
ImVec2 button_size(int count) {
    const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
    return {(ImGui::GetContentRegionAvail().x - gaps) / static_cast<float>(count), 0};
}

void transport(const PanelModel& model, PanelRequests& requests) {
    const ImVec2 size = button_size(3);
    const auto button = [&](const char* text, Action action) {
        if (ImGui::Button(text, size)) requests.action = action;
    };
    button(model.playing ? "Pause###play" : "Play###play", Action::TogglePlay);
    ImGui::SameLine();
    button("Step", Action::Step);
    ImGui::SameLine();
    button("Restart", Action::Restart);
}

void lighter_buttons(const PanelModel& model, PanelRequests& requests) {
    const ImVec2 third = button_size(3), half = button_size(2);
    const auto offer = [&](const char* text, LighterSpot spot) {
        if (ImGui::Button(text, third)) requests.lighter_spot = spot;
    };
    offer("Under left", LighterSpot::LeftCorner);
    ImGui::SameLine();
    offer("Under middle", LighterSpot::Middle);
    ImGui::SameLine();
    offer("Under right", LighterSpot::RightCorner);
    const ImVec4 colour =
        ImGui::GetStyleColorVec4(model.placing ? ImGuiCol_ButtonActive : ImGuiCol_Button);
    ImGui::PushStyleColor(ImGuiCol_Button, colour);
    if (ImGui::Button(model.placing ? "Click the paper###place" : "Place by a click###place",
                      half)) {
        requests.action = Action::PlaceLighter;
    }
    ImGui::PopStyleColor();
    ImGui::SameLine();
    ImGui::BeginDisabled(model.stats.lighter_lit);
    requests.light_now = ImGui::Button("Light it now", half);
    ImGui::EndDisabled();
}

bool rows_by_key(std::span<const std::string_view> keys, const ParamObjects& objects) {
    bool apply = false;
    for (const std::string_view key : keys) {
        apply = param_widget(*find_param(sim_param_rows(), key), objects) || apply;
    }
    return apply;
}

// The rows of the first lighter, wherever it has them from.
bool first_lighter(PanelModel& model) {
    Params shown, preset;
    const Params defaults;
    shown.lighter = lighters_of(model.params).front();
    preset.lighter = lighters_of(model.preset_params).front();
    const LighterParams before = shown.lighter;
    const bool apply = rows_by_key(kLighter, {&shown, &preset, &defaults});
    const LighterParams& now = shown.lighter;
    const bool moved = now.x != before.x || now.y != before.y || now.z != before.z;
    if (moved) shown.lighter.path.clear();  // put there by hand, it stays there
    set_lighter(model.params, 0, shown.lighter);
    return apply;
}

void main_panel(PanelModel& model, PanelRequests& requests) {
    const Params defaults;
    const RenderParams render_defaults;
    const ParamObjects sim{&model.params, &model.preset_params, &defaults};
    const ParamObjects render{&model.render, &model.preset_render, &render_defaults};
    ImGui::TextWrapped("%s", model.title.c_str());
    transport(model, requests);
    ImGui::Spacing();
    bool apply = rows_by_key(kFirst, sim);
    ImGui::Spacing();
    ImGui::TextDisabled(model.stats.lighter_lit ? "Lighter, burning" : "Lighter, out");
    apply = first_lighter(model) || apply;
    lighter_buttons(model, requests);
    ImGui::Spacing();
    ImGui::TextDisabled("Everything else");
    const float height =
        std::max(ImGui::GetContentRegionAvail().y, kLeastGroups * ImGui::GetFontSize());
    ImGui::BeginChild("groups", ImVec2(0, height));
    apply = param_groups(sim_param_rows(), sim, kElsewhere, kHidden) || apply;
    // what is only looked at differently needs no world to agree
    static_cast<void>(param_groups(render_param_rows(), render, kElsewhere, kHidden));
    ImGui::EndChild();
    requests.apply_params = apply;
}

}  // namespace

float panel_width(const PanelModel& model) {
    const float size = ImGui::GetIO().Fonts->Fonts[0]->FontSize;
    return model.show_panel ? std::min(kPanelWidth * size, 0.5f * ImGui::GetIO().DisplaySize.x) : 0;
}

PanelRequests draw_panels(PanelModel& model) {
    PanelRequests requests;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float width = panel_width(model);
    if (model.show_panel) {
        ImGui::SetNextWindowPos(ImVec2(display.x - width, 0));
        ImGui::SetNextWindowSize(ImVec2(width, display.y));
        const ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;
        if (ImGui::Begin("emberleaf", nullptr, flags)) main_panel(model, requests);
        ImGui::End();
    }
    draw_overlays(model, display.x - width);
    return requests;
}

}  // namespace ember
