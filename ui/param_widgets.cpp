#include "ui/param_widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "ui/param_text.h"

namespace ember {
namespace {

constexpr float kLabelWidth = 10.5f;  // [font sizes]
constexpr float kTooltipWidth = 24.0f;
constexpr float kTooltipDelay = 0.35f;  // [s]

// A slider, except that its text is ours: ImGui would show a dragged value before it is rounded.
// The value goes through `format` only where it is typed.
template <class Number>
bool slider(const ParamInfo& row, const ParamObjects& o, ImGuiDataType type, Number& value,
            Number least, Number most, ImGuiSliderFlags flags) {
    const ImGuiID id = ImGui::GetID("##value");
    const bool typing = ImGui::TempInputIsActive(id);
    if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
    const bool changed = ImGui::SliderScalar("##value", type, &value, &least, &most,
                                             value_format(row).c_str(), flags);
    if (!typing) ImGui::PopStyleColor();
    if (!changed) return false;
    const auto number = static_cast<double>(value);
    const bool dragged = !typing && row.kind == ParamKind::Real;
    const double wanted = dragged ? tidy(row, {double(least), double(most)}, number) : number;
    // a typed value may leave the slider, but never what is allowed
    row.set_shown(o.edited, std::clamp(wanted, row.hard.min, row.hard.max));
    return true;
}

void slider_text(const ParamInfo& row, const ParamObjects& o) {
    if (ImGui::TempInputIsActive(ImGui::GetID("##value"))) return;
    const std::string text = shown_value(row, o.edited);
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddText(
        ImVec2(0.5f * (least.x + most.x - size.x), 0.5f * (least.y + most.y - size.y)),
        ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
}

bool number_widget(const ParamInfo& row, const ParamObjects& o) {
    const ParamRange range = slider_range(row, row.shown(o.preset));
    bool changed = false;
    if (row.kind == ParamKind::Integer) {
        auto value = static_cast<std::int64_t>(row.get(o.edited));
        changed = slider(row, o, ImGuiDataType_S64, value, static_cast<std::int64_t>(range.min),
                         static_cast<std::int64_t>(range.max), 0);
    } else {
        double value = without_noise(row.shown(o.edited));
        const bool logarithmic = row.scale == ParamScale::Logarithmic;
        changed = slider(
            row, o, ImGuiDataType_Double, value, range.min, range.max,
            ImGuiSliderFlags_NoRoundToFormat | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0));
    }
    slider_text(row, o);
    return row.applies == ParamApplies::Live ? changed : ImGui::IsItemDeactivatedAfterEdit();
}

bool choice_widget(const ParamInfo& row, const ParamObjects& o) {
    if (!ImGui::BeginCombo("##value", shown_value(row, o.edited).c_str())) return false;
    const double before = row.get(o.edited);
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        const auto choice = static_cast<double>(i);
        ImGui::PushID(static_cast<int>(i));
        std::string name(row.choices[i]);
        std::ranges::replace(name, '_', ' ');
        if (ImGui::Selectable(name.c_str(), choice == before)) row.set(o.edited, choice);
        ImGui::PopID();
    }
    ImGui::EndCombo();
    return row.get(o.edited) != before;
}

// One box per place; names that stand for several are left out, as their parts are there.
bool set_widget(const ParamInfo& row, const ParamObjects& o) {
    if (!ImGui::BeginCombo("##value", shown_value(row, o.edited).c_str())) return false;
    const double before = row.get(o.edited);
    auto bits = static_cast<unsigned>(before);
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        if (!std::has_single_bit(row.bits[i])) continue;
        std::string name(row.choices[i]);
        std::ranges::replace(name, '_', ' ');
        ImGui::CheckboxFlags(name.c_str(), &bits, row.bits[i]);
    }
    row.set(o.edited, static_cast<double>(bits));
    ImGui::EndCombo();
    return row.get(o.edited) != before;
}

bool toggle_widget(const ParamInfo& row, const ParamObjects& o) {
    bool value = row.get(o.edited) != 0;
    if (!ImGui::Checkbox("##value", &value)) return false;
    row.set(o.edited, value ? 1.0 : 0.0);
    return true;
}

// Draws the widget of the row's kind; returns whether the copy is to be applied.
bool value_widget(const ParamInfo& row, const ParamObjects& objects) {
    switch (row.kind) {
        case ParamKind::Toggle:
            return toggle_widget(row, objects);
        case ParamKind::Choice:
            return choice_widget(row, objects);
        case ParamKind::Set:
            return set_widget(row, objects);
        case ParamKind::Integer:
        case ParamKind::Real:
            return number_widget(row, objects);
        case ParamKind::Text:
        case ParamKind::Table:
            break;
    }
    ImGui::TextUnformatted(shown_value(row, objects.edited).c_str());  // set in presets
    return false;
}

// Beside the panel, so that it hides no other row; after a moment, so that it does not flicker.
void tooltip(const ParamInfo& row, const ParamObjects& o) {
    if (!ImGui::IsItemHovered() || ImGui::IsAnyItemActive()) return;
    if (ImGui::GetCurrentContext()->HoveredIdTimer < kTooltipDelay) return;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float edge = ImGui::GetCurrentWindow()->RootWindow->Pos.x;
    const float top = ImGui::GetItemRectMin().y;
    const float height = ImGui::GetMainViewport()->Size.y;
    // rows of the lower half grow upwards
    const bool low = top > 0.6f * height;
    ImGui::SetNextWindowPos(ImVec2(edge - gap, low ? ImGui::GetItemRectMax().y : top),
                            ImGuiCond_Always, ImVec2(1.0f, low ? 1.0f : 0.0f));
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * kTooltipWidth);
    ImGui::TextUnformatted(std::string(row.help).c_str());
    const bool number = row.kind == ParamKind::Real || row.kind == ParamKind::Integer;
    if (number) {
        ImGui::TextDisabled("tried: %s", shown_range(row, row.tested).c_str());
        ImGui::TextDisabled("possible: %s", shown_range(row, row.hard).c_str());
    }
    ImGui::TextDisabled("preset: %s, default: %s", shown_value(row, o.preset).c_str(),
                        shown_value(row, o.defaults).c_str());
    std::string origin = std::string(row.key);
    if (!row.symbol.empty()) origin += ", in the paper " + std::string(row.symbol);
    origin += " (" + std::string(row.source) + ")";
    ImGui::TextDisabled("%s", origin.c_str());
    ImGui::TextUnformatted(row.applies == ParamApplies::Live ? "Acts at once."
                                                             : "Restarts the scene.");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool reset_menu(const ParamInfo& row, const ParamObjects& o) {
    if (!ImGui::BeginPopup("menu")) return false;
    bool changed = false;
    const auto offer = [&](const std::string& text, const ParamValue& value) {
        if (!ImGui::MenuItem(text.c_str(), nullptr, false, row.value(o.edited) != value)) return;
        row.assign(o.edited, value);
        changed = true;
    };
    offer("Reset to the preset: " + shown_value(row, o.preset), row.value(o.preset));
    offer("Reset to the default: " + shown_value(row, o.defaults), row.value(o.defaults));
    if (std::isinf(row.hard.max)) offer("No limit", std::numeric_limits<double>::infinity());
    ImGui::EndPopup();
    return changed;
}

// The name, with a dot when it differs from the preset, and a sign when a change restarts.
bool label(const ParamInfo& row, const ParamObjects& o) {
    const float size = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool edited = row.value(o.edited) != row.value(o.preset);
    ImGui::InvisibleButton("label", ImVec2(size * kLabelWidth, height));
    const bool reset = edited && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    if (reset) row.assign(o.edited, row.value(o.preset));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = corner.y + 0.5f * height;
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    if (edited) {
        list.AddCircleFilled(ImVec2(corner.x + 0.2f * size, middle), 0.2f * size,
                             ImGui::GetColorU32(ImGuiCol_CheckMark));
    }
    list.AddText(ImVec2(corner.x + 0.7f * size, middle - 0.5f * size),
                 ImGui::GetColorU32(ImGuiCol_Text), label_text(row).c_str());
    if (row.applies == ParamApplies::Rebuild) {
        const ImVec2 centre(corner.x + (kLabelWidth - 0.6f) * size, middle);
        list.PathArcTo(centre, 0.28f * size, -0.9f, 4.2f, 12);
        list.PathStroke(faint, 0, 0.09f * size);
        const ImVec2 tip(centre.x + 0.17f * size, centre.y - 0.22f * size);
        list.AddTriangleFilled(ImVec2(tip.x - 0.16f * size, tip.y - 0.08f * size),
                               ImVec2(tip.x + 0.16f * size, tip.y - 0.12f * size),
                               ImVec2(tip.x + 0.08f * size, tip.y + 0.2f * size), faint);
    }
    return reset;
}

}  // namespace

double seconds_until_tooltip() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const bool waiting = context.HoveredId != 0 && context.HoveredIdTimer < kTooltipDelay;
    return waiting ? double(kTooltipDelay - context.HoveredIdTimer)
                   : std::numeric_limits<double>::infinity();
}

bool param_widget(const ParamInfo& row, const ParamObjects& objects) {
    ImGui::PushID(std::string(row.key).c_str());
    bool apply = label(row, objects);
    tooltip(row, objects);
    ImGui::OpenPopupOnItemClick("menu");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-FLT_MIN);
    apply = value_widget(row, objects) || apply;
    tooltip(row, objects);
    ImGui::OpenPopupOnItemClick("menu");
    apply = reset_menu(row, objects) || apply;
    ImGui::PopID();
    return apply;
}

bool param_groups(std::span<const ParamInfo> rows, const ParamObjects& objects,
                  std::span<const std::string_view> elsewhere,
                  std::span<const std::string_view> hidden) {
    const auto shown = [&](const ParamInfo& row) {
        return std::ranges::count(hidden, row.group()) == 0 &&
               std::ranges::count(elsewhere, row.key) == 0;
    };
    const auto edited = [&](const ParamInfo& row) {
        return shown(row) && row.value(objects.edited) != row.value(objects.preset);
    };
    bool apply = false, open = false;
    std::string_view group;
    for (const ParamInfo& row : rows) {
        if (!shown(row)) continue;
        if (row.group() != group) {
            group = row.group();
            const bool marked = std::ranges::any_of(
                rows, [&](const ParamInfo& r) { return r.group() == group && edited(r); });
            ImGui::PushStyleColor(ImGuiCol_Text,
                                  ImGui::GetColorU32(marked ? ImGuiCol_CheckMark : ImGuiCol_Text));
            open = ImGui::CollapsingHeader(group_text(group).c_str());
            ImGui::PopStyleColor();
        }
        if (open) apply = param_widget(row, objects) || apply;
    }
    return apply;
}

}  // namespace ember
