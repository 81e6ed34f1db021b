#include "ui/param_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace ember {
namespace {

// What a slider covers: what has been tried, or all that is allowed where that is one value.
ParamRange slider_range(const ParamInfo& row, double value) {
    ParamRange range = row.tested.min < row.tested.max ? row.tested : row.hard;
    range.min = std::min(range.min, value);
    range.max = std::max(range.max, value);
    return range;
}

bool real_widget(const ParamInfo& row, void* object) {
    double value = row.shown(object);
    const ParamRange range = slider_range(row, value);
    // a percent sign of the unit must not be taken for a format
    std::string unit(row.unit.name);
    if (unit == "%") unit = "%%";
    const std::string format = "%.4g " + unit;
    const bool logarithmic = row.scale == ParamScale::Logarithmic;
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_NoRoundToFormat | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    if (!ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &range.min, &range.max,
                             format.c_str(), flags)) {
        return false;
    }
    // a typed value may leave the slider, but never what is allowed
    row.set_shown(object, std::clamp(value, row.hard.min, row.hard.max));
    return true;
}

bool integer_widget(const ParamInfo& row, void* object) {
    int value = static_cast<int>(row.get(object));
    if (!ImGui::InputInt("##value", &value, 1, 8, ImGuiInputTextFlags_EnterReturnsTrue)) {
        return false;
    }
    row.set(object, std::clamp(static_cast<double>(value), row.hard.min, row.hard.max));
    return true;
}

bool choice_widget(const ParamInfo& row, void* object) {
    const auto present = static_cast<std::size_t>(row.get(object));
    bool changed = false;
    if (!ImGui::BeginCombo("##value", std::string(row.choices[present]).c_str())) return false;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        if (ImGui::Selectable(std::string(row.choices[i]).c_str(), i == present) && i != present) {
            row.set(object, static_cast<double>(i));
            changed = true;
        }
    }
    ImGui::EndCombo();
    return changed;
}

bool toggle_widget(const ParamInfo& row, void* object) {
    bool value = row.get(object) != 0;
    if (!ImGui::Checkbox("##value", &value)) return false;
    row.set(object, value ? 1.0 : 0.0);
    return true;
}

bool value_widget(const ParamInfo& row, void* object) {
    switch (row.kind) {
        case ParamKind::Real:
            return real_widget(row, object);
        case ParamKind::Integer:
            return integer_widget(row, object);
        case ParamKind::Choice:
            return choice_widget(row, object);
        case ParamKind::Toggle:
            return toggle_widget(row, object);
    }
    return false;
}

void tooltip(const ParamInfo& row) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24.0f);
    ImGui::TextUnformatted(std::string(row.key).c_str());
    if (!row.symbol.empty()) {
        ImGui::SameLine();
        ImGui::TextDisabled("%s in the paper", std::string(row.symbol).c_str());
    }
    ImGui::TextUnformatted(std::string(row.help).c_str());
    if (row.kind == ParamKind::Real) {
        ImGui::TextDisabled("tried from %g to %g %s", row.tested.min, row.tested.max,
                            std::string(row.unit.name).c_str());
    }
    ImGui::TextDisabled(
        "%s. %s", std::string(row.source).c_str(),
        row.applies == ParamApplies::Live ? "Acts at once." : "Restarts the scene.");
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

bool reset_menu(const ParamInfo& row, void* object, const void* preset, const void* defaults) {
    bool changed = false;
    if (!ImGui::BeginPopupContextItem("reset")) return false;
    const auto offer = [&](const char* text, const void* from) {
        if (!ImGui::MenuItem(text, nullptr, false, row.get(object) != row.get(from))) return;
        row.set(object, row.get(from));
        changed = true;
    };
    offer("Reset to the preset", preset);
    offer("Reset to the built-in default", defaults);
    ImGui::EndPopup();
    return changed;
}

}  // namespace

bool param_widget(const ParamInfo& row, void* object, const void* preset, const void* defaults) {
    const std::string id(row.key);
    ImGui::PushID(id.c_str());
    const bool edited = row.get(object) != row.get(preset);
    std::string label(row.name());
    if (label != row.symbol) std::replace(label.begin(), label.end(), '_', ' ');  // c_s stays c_s
    if (edited) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
    }
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label.c_str());
    if (edited) ImGui::PopStyleColor();
    tooltip(row);
    bool changed = reset_menu(row, object, preset, defaults);
    ImGui::SameLine(ImGui::GetFontSize() * 8.5f);
    ImGui::SetNextItemWidth(-1.0f);
    changed = value_widget(row, object) || changed;
    tooltip(row);
    ImGui::PopID();
    return changed;
}

bool param_groups(const ParamBinding& binding, const void* preset, const void* defaults) {
    bool changed = false, open = false;
    std::string_view group;
    for (const ParamInfo& row : binding.rows) {
        if (row.group() != group) {
            group = row.group();
            open = ImGui::CollapsingHeader(std::string(group).c_str());
        }
        if (open) changed = param_widget(row, binding.object, preset, defaults) || changed;
    }
    return changed;
}

}  // namespace ember
