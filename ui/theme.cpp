#include "ui/theme.h"

#include <imgui.h>

#include <cmath>
#include <filesystem>

namespace ember {
namespace {

void load_font(float scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const float size = std::round(15.0f * scale);
    // Latin, Greek symbols, punctuation, arrows
    static constexpr ImWchar kGlyphs[] = {0x20,   0x17f,  0x370,  0x3ff, 0x2010,
                                          0x2027, 0x2190, 0x2199, 0};
    for (const char* path : {"/usr/share/fonts/opentype/inter/Inter-Medium.otf",
                             "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"}) {
        if (!std::filesystem::exists(path)) continue;
        if (io.Fonts->AddFontFromFileTTF(path, size, nullptr, kGlyphs) != nullptr) return;
    }
    ImFontConfig config;
    config.SizePixels = std::round(13.0f * scale);
    io.Fonts->AddFontDefault(&config);
}

}  // namespace

void apply_theme(float scale) {
    load_font(scale);
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowRounding = 0.0f;
    style.FrameRounding = 3.0f;
    style.GrabRounding = 3.0f;
    style.WindowBorderSize = 0.0f;
    style.WindowPadding = ImVec2(12, 12);
    style.WindowMinSize = ImVec2(8, 8);
    style.ItemSpacing = ImVec2(8, 6);
    style.FramePadding = ImVec2(6, 3);
    style.ScaleAllSizes(scale);
    // charcoal, and one warm accent
    const ImVec4 accent(0.90f, 0.45f, 0.15f, 1.0f);
    const auto grey = [](float v, float a = 1.0f) { return ImVec4(v, v, v * 1.05f, a); };
    const auto with_alpha = [&](float a) { return ImVec4(accent.x, accent.y, accent.z, a); };
    ImVec4* c = style.Colors;
    c[ImGuiCol_WindowBg] = grey(0.085f);
    c[ImGuiCol_PopupBg] = grey(0.11f, 0.98f);
    c[ImGuiCol_FrameBg] = grey(0.16f);
    c[ImGuiCol_FrameBgHovered] = grey(0.21f);
    c[ImGuiCol_FrameBgActive] = grey(0.24f);
    c[ImGuiCol_Header] = grey(0.15f);
    c[ImGuiCol_HeaderHovered] = grey(0.20f);
    c[ImGuiCol_HeaderActive] = grey(0.24f);
    c[ImGuiCol_Button] = grey(0.18f);
    c[ImGuiCol_ButtonHovered] = with_alpha(0.55f);
    c[ImGuiCol_ButtonActive] = with_alpha(0.85f);
    c[ImGuiCol_SliderGrab] = with_alpha(0.80f);
    c[ImGuiCol_SliderGrabActive] = accent;
    c[ImGuiCol_CheckMark] = accent;
    c[ImGuiCol_Text] = grey(0.88f);
    c[ImGuiCol_TextDisabled] = grey(0.50f);
    c[ImGuiCol_Separator] = grey(0.22f);
    c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = grey(0.15f);
    c[ImGuiCol_MenuBarBg] = grey(0.11f);
    c[ImGuiCol_PlotLines] = c[ImGuiCol_PlotHistogram] = with_alpha(0.9f);
    c[ImGuiCol_TableHeaderBg] = grey(0.13f);
    c[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
    c[ImGuiCol_TextSelectedBg] = with_alpha(0.35f);
}

unsigned handle_colour(bool edited, bool lit) {
    if (edited) return lit ? IM_COL32(255, 170, 80, 255) : IM_COL32(255, 255, 255, 220);
    return lit ? IM_COL32(255, 170, 80, 150) : IM_COL32(255, 255, 255, 110);
}

ImVec4 error_colour() {
    return {1.0f, 0.45f, 0.35f, 1.0f};
}

ImVec4 warning_colour() {
    return {0.95f, 0.78f, 0.40f, 1.0f};
}

}  // namespace ember
