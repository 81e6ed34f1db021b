#include "ui/param_marks.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <limits>
#include <string>

#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_io.h"
#include "ui/param_text.h"

namespace ember {
namespace {

constexpr float kLabelWidth = 10.5f;  // [font sizes]
constexpr float kTooltipWidth = 24.0f;
constexpr float kTooltipDelay = 0.35f;  // [s]

// Reads a value as a preset or --set has it.
bool paste(const ParamInfo& row, const ParamObjects& o) {
    const char* text = ImGui::GetClipboardText();
    if (text == nullptr) return false;
    const ParamBinding binding[] = {{std::span(&row, 1), o.edited}};
    const ParamValue before = row.value(o.edited);
    const auto problems = apply_override(std::string(row.key) + '=' + text, binding);
    return problems.empty() && row.value(o.edited) != before;
}

// An arrow that turns back.
void turn_sign(const ImVec2& centre, ImU32 colour) {
    const float size = ImGui::GetFontSize();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PathArcTo(centre, 0.28f * size, -0.9f, 4.2f, 12);
    list.PathStroke(colour, 0, 0.09f * size);
    const ImVec2 tip(centre.x + 0.17f * size, centre.y - 0.22f * size);
    list.AddTriangleFilled(ImVec2(tip.x - 0.16f * size, tip.y - 0.08f * size),
                           ImVec2(tip.x + 0.16f * size, tip.y - 0.12f * size),
                           ImVec2(tip.x + 0.08f * size, tip.y + 0.2f * size), colour);
}

}  // namespace

double seconds_until_tooltip() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    const bool waiting = context.HoveredId != 0 && context.HoveredIdTimer < kTooltipDelay;
    return waiting ? double(kTooltipDelay - context.HoveredIdTimer)
                   : std::numeric_limits<double>::infinity();
}

// Beside the panel, so that it hides no other row; after a moment, so that it does not flicker.
void param_tooltip(const ParamInfo& row, const ParamObjects& o) {
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
    ImGui::TextDisabled("preset: %s, inherited: %s, default: %s",
                        shown_value(row, o.preset).c_str(), shown_value(row, o.parent).c_str(),
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

bool param_menu(const ParamInfo& row, const ParamObjects& o) {
    if (!ImGui::BeginPopup("menu")) return false;
    bool changed = false;
    const auto offer = [&](const std::string& text, const ParamValue& value) {
        if (!ImGui::MenuItem(text.c_str(), nullptr, false, row.value(o.edited) != value)) return;
        row.assign(o.edited, value);
        changed = true;
    };
    offer("Reset to the preset: " + shown_value(row, o.preset), row.value(o.preset));
    offer("Reset to what it inherits: " + shown_value(row, o.parent), row.value(o.parent));
    offer("Reset to the default: " + shown_value(row, o.defaults), row.value(o.defaults));
    if (std::isinf(row.hard.max)) offer("No limit", std::numeric_limits<double>::infinity());
    ImGui::Separator();
    const std::string text = value_text(row, o.edited);
    if (ImGui::MenuItem("Copy")) ImGui::SetClipboardText(text.c_str());
    if (ImGui::MenuItem("Paste")) changed = paste(row, o) || changed;
    if (ImGui::MenuItem("Copy as TOML")) {
        const std::string toml =
            '[' + std::string(row.group()) + "]\n" + std::string(row.name()) + " = " + text + '\n';
        ImGui::SetClipboardText(toml.c_str());
    }
    ImGui::EndPopup();
    return changed;
}

// The name. A dot: not saved; a ring: not as in what the preset inherits; an R: restarts the scene.
bool param_label(const ParamInfo& row, const ParamObjects& o) {
    const float size = ImGui::GetFontSize(), height = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool edited = row.value(o.edited) != row.value(o.preset);
    const bool own = row.value(o.edited) != row.value(o.parent);
    ImGui::InvisibleButton("label", ImVec2(size * kLabelWidth, height));
    const bool reset = edited && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0);
    if (reset) row.assign(o.edited, row.value(o.preset));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float middle = corner.y + 0.5f * height;
    const ImVec2 mark(corner.x + 0.25f * size, middle);
    const ImU32 warm = ImGui::GetColorU32(ImGuiCol_CheckMark);
    const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
    if (edited) list.AddCircleFilled(mark, 0.2f * size, warm);
    if (own && !edited) list.AddCircle(mark, 0.18f * size, warm, 0, 0.08f * size);
    list.AddText(ImVec2(corner.x + 0.7f * size, middle - 0.5f * size),
                 ImGui::GetColorU32(ImGuiCol_Text), label_text(row).c_str());
    if (!row.symbol.empty() && row.symbol != row.name()) {
        const float width = ImGui::CalcTextSize(label_text(row).c_str()).x;
        list.AddText(ImVec2(corner.x + 1.3f * size + width, middle - 0.5f * size), faint,
                     symbol_text(row).c_str());
    }
    if (row.applies == ParamApplies::Rebuild)
        list.AddText(ImGui::GetFont(), 0.75f * size,
                     ImVec2(corner.x + (kLabelWidth - 0.8f) * size, middle - 0.35f * size), faint,
                     "R");
    return reset;
}

// Shown only where there is something to reset.
bool param_reset(const ParamInfo& row, const ParamObjects& o) {
    const float height = ImGui::GetFrameHeight();
    const bool edited = row.value(o.edited) != row.value(o.preset);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (!edited) {
        ImGui::Dummy(ImVec2(height, height));
        return false;
    }
    const bool pressed = ImGui::InvisibleButton("reset", ImVec2(height, height));
    turn_sign(ImVec2(corner.x + 0.5f * height, corner.y + 0.5f * height),
              ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_CheckMark : ImGuiCol_Text));
    if (pressed) row.assign(o.edited, row.value(o.preset));
    return pressed;
}

}  // namespace ember
