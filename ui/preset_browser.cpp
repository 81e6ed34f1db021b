#include "ui/preset_browser.h"

#include <imgui.h>

#include <algorithm>
#include <exception>

#include "render/image.h"

namespace ember {
namespace {

constexpr float kCard = 12.0f;  // [font sizes] least width

}  // namespace

bool PresetBrowser::poll() {
    thumbnails_.poll();
    const auto missing = std::ranges::count_if(
        presets_, [&](const ListedPreset& p) { return thumbnails_.file_of(p.path).empty(); });
    return std::exchange(waiting_, missing) != missing;
}

const Texture* PresetBrowser::picture_of(const ListedPreset& preset) {
    const std::filesystem::path file = thumbnails_.file_of(preset.path);
    if (file.empty()) return nullptr;
    const auto known = pictures_.find(file);
    if (known != pictures_.end()) return &known->second;
    try {
        const Image image = read_image(file);
        Texture& texture = pictures_[file];
        allocate(texture, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, image.width, image.height);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, image.width, image.height, GL_RGBA,
                        GL_UNSIGNED_BYTE, image.rgba.data());
        return &texture;
    } catch (const std::exception&) {
        return nullptr;  // it is being written
    }
}

void PresetBrowser::card(const ListedPreset& preset, float width, Workbench& bench) {
    const float font = ImGui::GetFontSize(), height = width * 9 / 16;
    ImGui::PushID(preset.path.c_str());
    ImGui::BeginGroup();
    const ImVec2 from = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton("open", ImVec2(width, height + 2.6f * font));
    const bool hovered = ImGui::IsItemHovered();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to(from.x + width, from.y + height);
    if (const Texture* picture = picture_of(preset)) {
        list.AddImageRounded(
            reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(picture->name())), from, to,
            ImVec2(0, 0), ImVec2(1, 1), IM_COL32_WHITE, 4);
    } else {
        list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
        list.AddText(ImVec2(from.x + font, from.y + 0.5f * height - 0.5f * font),
                     ImGui::GetColorU32(ImGuiCol_TextDisabled), "being drawn ...");
    }
    const bool open = preset.path == bench.document().info.path;
    if (hovered || open)
        list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_CheckMark), 4, 0, 0.12f * font);
    list.PushClipRect(from, ImVec2(to.x, to.y + 2.6f * font), true);
    list.AddText(ImVec2(from.x, to.y + 0.2f * font), ImGui::GetColorU32(ImGuiCol_Text),
                 preset.name.c_str());
    list.AddText(ImVec2(from.x, to.y + 1.3f * font), ImGui::GetColorU32(ImGuiCol_TextDisabled),
                 preset.title.c_str());
    list.PopClipRect();
    ImGui::EndGroup();
    if (pressed) bench.open(preset.path);
    if (ImGui::BeginPopupContextItem("more")) {
        if (ImGui::MenuItem("Open")) bench.open(preset.path);
        if (ImGui::MenuItem("Open beside what there is")) bench.open_beside(preset.path);
        ImGui::EndPopup();
    }
    if (hovered && !preset.title.empty()) ImGui::SetTooltip("%s", preset.title.c_str());
    ImGui::PopID();
}

void PresetBrowser::draw(const Layout& layout, Workbench& bench) {
    const bool opens = bench.shown.browser && !was_open_;
    was_open_ = bench.shown.browser;
    if (!bench.shown.browser) return thumbnails_.stop();
    if (opens) {
        presets_ = list_presets(bench.folders().presets);
        thumbnails_.want(presets_);
    }
    const PictureRect& r = layout.picture;
    const float gap = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(gap, static_cast<float>(r.y) + gap));
    ImGui::SetNextWindowSize(
        ImVec2(static_cast<float>(r.width) - 2 * gap, static_cast<float>(r.height) - 2 * gap));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings;
    bool open = true;
    if (ImGui::Begin("Presets", &open, flags)) {
        ImGui::TextDisabled("Yours are in %s", bench.folders().presets.string().c_str());
        const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
        const float space = ImGui::GetStyle().ItemSpacing.x;
        const int columns = std::max(1, static_cast<int>((room + space) / (kCard * gap + space)));
        const float width =
            (room - static_cast<float>(columns - 1) * space) / static_cast<float>(columns);
        ImGui::BeginChild("cards");
        for (std::size_t i = 0; i < presets_.size(); ++i) {
            if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
            card(presets_[i], width, bench);
        }
        ImGui::EndChild();
    }
    ImGui::End();
    if (!open) bench.shown.browser = false;
}

}  // namespace ember
