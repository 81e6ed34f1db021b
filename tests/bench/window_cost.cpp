// What a frame of the window costs on the software rasteriser: panels and picture, milliseconds.
//
//   window_cost [PRESET]      after 2 s of the burn, at 1280x720
//
// The median of several turns counts, so that a busy machine matters little.
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <vector>

#include "render/offscreen_context.h"
#include "ui/dialogs.h"
#include "ui/imgui_painter.h"
#include "ui/overlays.h"
#include "ui/speedometer.h"
#include "ui/theme.h"

namespace {

using namespace ember;

constexpr int kTurns = 15, kTicks = 120;

double median_ms(const std::function<void()>& work) {
    std::vector<double> turns;
    for (int i = 0; i < kTurns; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        work();
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - begin;
        turns.push_back(spent.count());
    }
    std::nth_element(turns.begin(), turns.begin() + kTurns / 2, turns.end());
    return turns[kTurns / 2];
}

}  // namespace

int main(int argc, char** argv) {
    const auto context = OffscreenContext::create(GlBackend::OsMesa);
    Renderer renderer(context->loader());
    ImGui::CreateContext();
    apply_theme(1.0f);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = ImVec2(1280, 720);
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    {
        ImguiPainter painter;
        const auto preset = find_preset(argc > 1 ? argv[1] : "paper/corner", "");
        Workbench bench(open_document(preset), {}, Settings(), 1);
        bench.settings.show_profiler = bench.settings.show_plots = true;
        bench.act(Action::TogglePlay);
        for (int i = 0; i < kTicks; ++i)
            bench.act(Action::Step);
        do {
            bench.begin_frame(0, false);
        } while (!bench.caught_up());
        PlotData plots;
        Dialogs dialogs;
        const double panels = median_ms([&] {
            bench.begin_frame(0, false);
            ImGui::NewFrame();
            const Layout layout = layout_of(bench);
            plots.add(bench.snapshot());
            draw_menu_bar(layout, bench);
            draw_main_panel(layout, bench);
            draw_timeline(layout, bench);
            draw_status_bar(layout, bench, FrameTimes{});
            draw_overlays(layout, bench, plots);
            dialogs.draw(bench);
            bench.end_frame(false);
            ImGui::Render();
        });
        const double painted = median_ms([&] {
            painter.draw(*ImGui::GetDrawData());
            glFinish();
        });
        const PictureRect picture = layout_of(bench).picture;
        const auto width = static_cast<int>(picture.width),
                   height = static_cast<int>(picture.height);
        const double drawn = median_ms([&] {
            const Image image = renderer.draw_image({&bench.snapshot().view, {}},
                                                    bench.values.render, width, height);
            static_cast<void>(image);
        });
        std::printf("panels: %.2f ms to lay out, %.2f ms to paint\npicture of %dx%d: %.1f ms\n",
                    panels, painted, width, height, drawn);
    }
    ImGui::DestroyContext();
    return 0;
}
