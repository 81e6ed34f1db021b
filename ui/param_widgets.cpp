#include "ui/param_widgets.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <string>

#include "ui/param_marks.h"
#include "ui/param_text.h"

namespace ember {
namespace {

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

bool holds(std::string_view text, std::string_view part) {
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return !std::ranges::search(text, part, same).empty();
}

}  // namespace

bool param_widget(const ParamInfo& row, const ParamObjects& objects) {
    ImGui::PushID(std::string(row.key).c_str());
    bool apply = param_label(row, objects);
    param_tooltip(row, objects);
    ImGui::OpenPopupOnItemClick("menu");
    ImGui::SameLine();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    ImGui::SetNextItemWidth(-ImGui::GetFrameHeight() - gap);
    apply = value_widget(row, objects) || apply;
    param_tooltip(row, objects);
    ImGui::OpenPopupOnItemClick("menu");
    apply = param_menu(row, objects) || apply;
    ImGui::SameLine(0, gap);
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - ImGui::GetFrameHeight());
    apply = param_reset(row, objects) || apply;
    ImGui::PopID();
    return apply;
}

bool param_groups(std::span<const ParamInfo> rows, const ParamObjects& objects,
                  std::span<const std::string_view> elsewhere,
                  std::span<const std::string_view> hidden, std::string_view filter) {
    const auto shown = [&](const ParamInfo& row) {
        if (std::ranges::count(hidden, row.group()) != 0) return false;
        if (!filter.empty()) return holds(row.key, filter) || holds(row.help, filter);
        return std::ranges::count(elsewhere, row.key) == 0;
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
            if (!filter.empty()) ImGui::SetNextItemOpen(true);
            ImGui::PushID(filter.empty() ? "all" : "found");
            open = ImGui::CollapsingHeader(group_text(group).c_str());
            ImGui::PopID();
            ImGui::PopStyleColor();
        }
        if (open) apply = param_widget(row, objects) || apply;
    }
    return apply;
}

}  // namespace ember
