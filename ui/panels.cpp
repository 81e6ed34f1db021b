#include <imgui.h>

#include <algorithm>
#include <string>

#include "sim/lighter.h"
#include "sim/param_table.h"
#include "ui/lighter_placement.h"
#include "ui/panels.h"
#include "ui/param_widgets.h"
#include "ui/read_outs.h"

namespace ember {
namespace {

constexpr float kLeastGroups = 9.0f;  // [font sizes] height kept for the collapsing groups

// The parameters that the design of the program puts first, always in sight.
constexpr std::string_view kFirst[] = {"paper.grammage", "paper.density", "paper.c_s",
                                       "shrinkage.factor"};
constexpr std::string_view kLighter[] = {"lighter.on", "lighter.x", "lighter.y", "lighter.z"};
constexpr std::string_view kElsewhere[] = {"paper.grammage",   "paper.density", "paper.c_s",
                                           "shrinkage.factor", "lighter.on",    "lighter.x",
                                           "lighter.y",        "lighter.z"};
constexpr std::string_view kHidden[] = {"hand"};  // the mouse sets it

// `count` buttons of equal width in one line.
float button_width(int count) {
    const float gaps = static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x;
    return (ImGui::GetContentRegionAvail().x - gaps) / static_cast<float>(count);
}

bool rows_by_key(std::span<const std::string_view> keys, const ParamObjects& objects) {
    bool apply = false;
    for (const std::string_view key : keys)
        apply = param_widget(*find_param(sim_param_rows(), key), objects) || apply;
    return apply;
}

void slots(Workbench& bench) {
    const float width = button_width(4);
    const bool a = bench.slot()[0] == 'A';
    action_button(bench, Action::SwapSlots, "A", width, a);
    ImGui::SameLine();
    action_button(bench, Action::SwapSlots, "B", width, !a);
    ImGui::SameLine();
    action_button(bench, Action::StoreSlot, a ? "A to B###copy" : "B to A###copy", width);
    ImGui::SameLine();
    action_button(bench, Action::SideBySide, "Both", width, bench.shown.side_by_side);
}

void lines(Workbench& bench) {
    const Snapshot& shot = bench.snapshot();
    if (!ImGui::BeginTable("read-outs", 2)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 7.5f * ImGui::GetFontSize());
    for (const ReadOut& line : read_outs(bench.values.params, shot.view, shot.stats.substeps)) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", line.name.c_str());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(line.value.c_str());
    }
    ImGui::EndTable();
}

void lighter_choice(Workbench& bench) {
    const auto lighters = lighters_of(bench.values.params);
    const Snapshot& shot = bench.snapshot();
    for (std::size_t i = 0; i < lighters.size(); ++i) {
        const bool lit = lighter_lit(lighters[i], shot.view.time, shot.timeline.tick_duration);
        const std::string name = "Lighter " + std::to_string(i + 1) + (lit ? ", burning" : ", out");
        ImGui::PushID(static_cast<int>(i));
        if (i % 2 == 1) ImGui::SameLine();
        if (ImGui::RadioButton((name + "###lighter").c_str(), bench.lighter == i))
            bench.lighter = i;
        ImGui::PopID();
    }
}

// The rows of the lighter that is edited, wherever it has them from.
bool lighter_rows(Workbench& bench) {
    Params shown, preset, parent;
    const Params defaults;
    const auto of = [&](const Params& params) {
        const auto all = lighters_of(params);
        return all[std::min(bench.lighter, all.size() - 1)];
    };
    shown.lighter = of(bench.values.params);
    preset.lighter = of(bench.document().saved.params);
    parent.lighter = of(bench.document().parent.params);
    const LighterParams before = shown.lighter;
    const bool apply = rows_by_key(kLighter, {&shown, &preset, &parent, &defaults});
    set_lighter(bench.values.params, bench.lighter, bench.with_path(before, shown.lighter));
    return apply;
}

void lighter_buttons(Workbench& bench) {
    const float third = button_width(3), fifth = button_width(5);
    const auto offer = [&](const char* text, LighterSpot spot) {
        if (!ImGui::Button(text, ImVec2(third, 0))) return;
        const auto place = lighter_below(bench.snapshot().view.sheets.front(), spot);
        if (place) bench.place_lighter(*place);
    };
    offer("Left corner", LighterSpot::LeftCorner);
    ImGui::SameLine();
    offer("Middle", LighterSpot::Middle);
    ImGui::SameLine();
    offer("Right corner", LighterSpot::RightCorner);
    action_button(bench, Action::PlaceLighter, bench.shown.placing ? "Click it###p" : "Place###p",
                  fifth, bench.shown.placing);
    ImGui::SameLine();
    action_button(bench, Action::LightNow, "Light", fifth);
    ImGui::SameLine();
    action_button(bench, Action::RecordPath, "Path", fifth, bench.shown.recording_path);
    ImGui::SameLine();
    action_button(bench, Action::AddLighter, "Add", fifth);
    ImGui::SameLine();
    action_button(bench, Action::RemoveLighter, "Remove", fifth);
}

bool everything_else(Workbench& bench, const ParamObjects& sim, const ParamObjects& render) {
    auto& filter = bench.shown.filter;
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputTextWithHint("##filter", "find a parameter", filter.data(), filter.size());
    const float height =
        std::max(ImGui::GetContentRegionAvail().y, kLeastGroups * ImGui::GetFontSize());
    ImGui::BeginChild("groups", ImVec2(0, height));
    const bool apply = param_groups(sim_param_rows(), sim, kElsewhere, kHidden, filter.data());
    // what is only looked at differently needs no world to agree
    static_cast<void>(
        param_groups(render_param_rows(), render, kElsewhere, kHidden, filter.data()));
    ImGui::EndChild();
    return apply;
}

void contents(Workbench& bench) {
    const Params defaults;
    const RenderParams render_defaults;
    const Document& document = bench.document();
    const ParamObjects sim{&bench.values.params, &document.saved.params, &document.parent.params,
                           &defaults};
    const ParamObjects render{&bench.values.render, &document.saved.render, &document.parent.render,
                              &render_defaults};
    slots(bench);
    ImGui::Spacing();
    bool apply = rows_by_key(kFirst, sim);
    lines(bench);
    ImGui::Spacing();
    lighter_choice(bench);
    apply = lighter_rows(bench) || apply;
    if (apply) bench.apply();
    lighter_buttons(bench);
    ImGui::Spacing();
    if (everything_else(bench, sim, render)) bench.apply();
}

}  // namespace

void draw_main_panel(const Layout& layout, Workbench& bench) {
    if (layout.panel <= 0) return;
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(display.x - layout.panel, layout.menu));
    ImGui::SetNextWindowSize(ImVec2(layout.panel, display.y - layout.menu));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("parameters", nullptr, flags)) contents(bench);
    ImGui::End();
}

}  // namespace ember
