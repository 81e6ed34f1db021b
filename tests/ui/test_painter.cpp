// The panels without a window: laid out and painted on an off-screen context, with played-in mouse
// and keys.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "../app/temporary_folder.h"
#include "render/offscreen_context.h"
#include "ui/dialogs.h"
#include "ui/imgui_painter.h"
#include "ui/overlays.h"
#include "ui/speedometer.h"
#include "ui/theme.h"

namespace ember {
namespace {

class Panels : public ::testing::Test {
  protected:
    // A window of that size whose text is `scale` times as large.
    void open(int width, int height, float scale) {
        width_ = width, height_ = height;
        context_ = OffscreenContext::create(GlBackend::OsMesa);
        renderer_ = std::make_unique<Renderer>(context_->loader());
        ImGui::CreateContext();
        apply_theme(scale);
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
        painter_ = std::make_unique<ImguiPainter>();
        allocate(colour_.emplace(), GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.emplace().name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_->name(),
                               0);
        const auto at = [&](const char* name) { return folder_ / name; };
        const UserFolders folders{at("config"), at("presets"),  at("cache"),
                                  at("state"),  at("pictures"), at("videos")};
        bench_ = std::make_unique<Workbench>(open_document(find_preset("paper/corner", "")),
                                             folders, Settings(), 1);
        bench_->act(Action::TogglePlay);
        bench_->act(Action::ToStart);
        frames(3);
    }
    void TearDown() override {
        bench_.reset();
        painter_.reset();
        if (ImGui::GetCurrentContext() != nullptr) ImGui::DestroyContext();
        colour_.reset();
        target_.reset();
        renderer_.reset();
    }
    // Lays out everything for one frame.
    void frame() {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        time_ += 1.0 / 60.0;
        bench_->begin_frame(time_, busy_);
        ImGui::NewFrame();
        layout_ = layout_of(*bench_);
        draw_menu_bar(layout_, *bench_);
        draw_main_panel(layout_, *bench_);
        draw_timeline(layout_, *bench_);
        draw_status_bar(layout_, *bench_, FrameTimes{});
        draw_overlays(layout_, *bench_, plots_);
        dialogs_.draw(*bench_);
        busy_ = ImGui::IsAnyItemActive();
        bench_->end_frame(busy_);
        ImGui::Render();
    }
    void frames(int count) {
        for (int i = 0; i < count || !bench_->caught_up(); ++i) {
            frame();
            if (!bench_->caught_up()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    // The pixels of the last frame, rows from the bottom.
    std::vector<unsigned char> paint() {
        glBindFramebuffer(GL_FRAMEBUFFER, target_->name());
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        painter_->draw(*ImGui::GetDrawData(), target_->name());
        std::vector<unsigned char> pixels(static_cast<std::size_t>(width_) *
                                          static_cast<std::size_t>(height_) * 4);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->name());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return pixels;
    }
    // Bright pixels in columns from_x .. to_x - 1.
    std::size_t lit(int from_x, int to_x) {
        const auto pixels = paint();
        std::size_t count = 0;
        for (int y = 0; y < height_; ++y) {
            for (int x = from_x; x < to_x; ++x) {
                const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                static_cast<std::size_t>(x);
                count += pixels[at * 4] > 100 ? 1u : 0u;
            }
        }
        return count;
    }
    // No window leaves the display, and none is too small for what it holds; lists may scroll.
    void expect_everything_fits(const char* when) {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (!window->WasActive || window->Hidden) continue;
            const std::string name = window->Name;
            if (name.find("Debug") == 0 || (window->Flags & ImGuiWindowFlags_ChildWindow) != 0)
                continue;
            EXPECT_GE(window->Pos.x, 0) << name << ' ' << when;
            EXPECT_GE(window->Pos.y, 0) << name << ' ' << when;
            EXPECT_LE(window->Pos.x + window->Size.x, static_cast<float>(width_) + 0.5f)
                << name << ' ' << when;
            EXPECT_LE(window->Pos.y + window->Size.y, static_cast<float>(height_) + 0.5f)
                << name << ' ' << when;
            EXPECT_LE(window->ContentSize.x, window->Size.x - 2 * window->WindowPadding.x + 0.5f)
                << name << " is cut off at the right " << when;
            EXPECT_LE(window->ContentSize.y, window->Size.y + 0.5f)
                << name << " is cut off below " << when;
        }
    }

    int width_ = 0, height_ = 0;
    double time_ = 0;
    bool busy_ = false;
    TemporaryFolder folder_;
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<ImguiPainter> painter_;
    std::optional<Texture> colour_;
    std::optional<Framebuffer> target_;
    std::unique_ptr<Workbench> bench_;
    PlotData plots_;
    Dialogs dialogs_;
    Layout layout_;
};

TEST_F(Panels, LeaveThePictureFreeAndGoAwayTogether) {
    open(1280, 720, 1);
    bench_->settings.show_info = false;
    bench_->notices.dismiss();
    frames(2);
    const int edge = width_ - static_cast<int>(layout_.panel);
    EXPECT_GT(lit(edge, width_), 2000u);
    bench_->act(Action::TogglePanel);
    frames(2);
    EXPECT_EQ(layout_.panel, 0);
    EXPECT_EQ(layout_.picture.height, height_);
    EXPECT_EQ(lit(0, width_), 0u);
    bench_->act(Action::ToggleHelp);
    frames(2);
    EXPECT_GT(lit(0, width_), 2000u);
}

TEST_F(Panels, NothingIsCutOffAtBothSizes) {
    for (const int scale : {1, 2}) {
        open(1280 * scale, 720 * scale, static_cast<float>(scale));
        bench_->settings.show_profiler = bench_->settings.show_plots = true;
        for (const Action action : {Action::Step, Action::ToggleHelp, Action::ToggleHelp,
                                    Action::SaveAs, Action::Cancel, Action::Record, Action::Cancel,
                                    Action::ToggleLog, Action::Cancel, Action::OpenPath}) {
            bench_->act(action);
            frames(3);
            expect_everything_fits(binding_of(action).text);
        }
        TearDown();
    }
}

// Presses the mouse on every fourth row of points and drags it.
class Dragged : public Panels {
  protected:
    template <class Edited>
    void drag(Edited&& edited) {
        ImGuiIO& io = ImGui::GetIO();
        for (float y = layout_.menu + 20; y < 400 && !edited(); y += 4) {
            io.MousePos = ImVec2(static_cast<float>(width_) - 0.3f * layout_.panel, y);
            frame();
            io.MouseDown[0] = true;
            frame();
            io.MousePos.x += 30;
            frame();
            while_held_ = edited();
            io.MousePos.x += 10;
            frame();
            io.MouseDown[0] = false;
            frames(3);
        }
    }
    bool while_held_ = false;
};

TEST_F(Dragged, GrammageActsWhileItIsDraggedAndIsOneEntryToUndo) {
    open(1280, 720, 1);
    for (int i = 0; i < 10; ++i)
        bench_->act(Action::Step);
    frames(3);
    const double before = bench_->values.params.paper.grammage;
    drag([&] { return bench_->values.params.paper.grammage != before; });
    EXPECT_TRUE(while_held_);
    EXPECT_GT(bench_->snapshot().params.paper.grammage, before);
    EXPECT_EQ(bench_->snapshot().stats.tick, 10u);
    EXPECT_EQ(bench_->history().size(), 1u);
    bench_->act(Action::Undo);
    frames(3);
    EXPECT_EQ(bench_->snapshot().params.paper.grammage, before);
}

TEST_F(Panels, TypingIntoAFieldIsNoShortcut) {
    open(1280, 720, 1);
    bench_->act(Action::SaveAs);
    frames(3);
    EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "keys go to the field";
    ImGui::GetIO().AddInputCharacter('q');
    frames(2);
    bench_->act(Action::Cancel);
    frames(3);
    EXPECT_FALSE(ImGui::GetIO().WantTextInput);
}

}  // namespace
}  // namespace ember
