#include "ui/plots.h"

#include <imgui.h>

#include <algorithm>
#include <cstdio>

namespace ember {
namespace {

constexpr double kZeroCelsius = 273.15;        // [K]
constexpr float kWidth = 15.0f, kHigh = 3.4f;  // [font sizes] of a curve

void curve(const PlotData& data, std::size_t number, const TimelineSpan& time) {
    const float font = ImGui::GetFontSize();
    const ImVec2 from = ImGui::GetCursorScreenPos(), size(kWidth * font, kHigh * font);
    ImGui::Dummy(size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 to(from.x + size.x, from.y + size.y);
    list.AddRectFilled(from, to, IM_COL32(0, 0, 0, 110), 3);
    const auto& samples = data.samples();
    float low = 0, high = 0;
    for (const PlotData::Sample& s : samples)
        low = std::min(low, s.values[number]), high = std::max(high, s.values[number]);
    const float range = high > low ? high - low : 1;
    const auto last = static_cast<float>(std::max<std::uint64_t>(1, time.end));
    const auto place = [&](const PlotData::Sample& s) {
        return ImVec2(from.x + size.x * static_cast<float>(s.tick) / last,
                      to.y - 2 - (size.y - 1.3f * font) * (s.values[number] - low) / range);
    };
    std::vector<ImVec2> line;
    const std::size_t step = 1 + samples.size() / 600;
    for (std::size_t i = 0; i < samples.size(); i += step)
        line.push_back(place(samples[i]));
    list.AddPolyline(line.data(), static_cast<int>(line.size()),
                     ImGui::GetColorU32(ImGuiCol_PlotLines), 0, 0.09f * font);
    const float x = from.x + size.x * static_cast<float>(time.cursor) / last;
    list.AddLine(ImVec2(x, from.y), ImVec2(x, to.y), IM_COL32(255, 255, 255, 90));
    const auto now = std::ranges::find_if(
        samples, [&](const PlotData::Sample& s) { return s.tick >= time.cursor; });
    char text[96];
    const PlotData::Curve& c = PlotData::kNames[number];
    std::snprintf(text, sizeof text, "%s  %.4g %s   0 to %.3g", c.name.data(),
                  double(now == samples.end() ? 0 : now->values[number]), c.unit.data(),
                  double(high));
    list.AddText(ImVec2(from.x + 0.3f * font, from.y + 0.1f * font),
                 ImGui::GetColorU32(ImGuiCol_Text), text);
}

}  // namespace

void PlotData::add(const Snapshot& shot) {
    const SessionStats& s = shot.stats;
    const auto later = std::ranges::find_if(
        samples_, [&](const Sample& sample) { return sample.tick > shot.timeline.end; });
    samples_.erase(later, samples_.end());
    if (!samples_.empty() && samples_.back().tick == s.tick) samples_.pop_back();  // edited there
    if (!samples_.empty() && samples_.back().tick > s.tick) return;
    samples_.push_back(
        {s.tick,
         {static_cast<float>(s.hottest - kZeroCelsius), static_cast<float>(1e3 * s.mass),
          static_cast<float>(s.heat), static_cast<float>(s.burning), static_cast<float>(s.cuts),
          static_cast<float>(1e3 * s.tick_seconds)}});
    if (samples_.size() <= kMostSamples) return;
    std::size_t kept = 0;  // every second one is enough for a curve of some hundred points
    for (std::size_t i = 0; i < samples_.size(); i += 2)
        samples_[kept++] = samples_[i];
    samples_.resize(kept);
}

void draw_plots(const PictureRect& picture, const PlotData& data, const Snapshot& shot) {
    const float gap = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImVec2(gap, static_cast<float>(picture.y) + gap));
    ImGui::SetNextWindowBgAlpha(0.5f);
    const ImGuiWindowFlags flags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
        ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs;
    if (ImGui::Begin("plots", nullptr, flags)) {
        for (std::size_t i = 0; i < PlotData::kCurves; ++i)
            curve(data, i, shot.timeline);
    }
    ImGui::End();
}

}  // namespace ember
