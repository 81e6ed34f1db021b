// The panels without a window: laid out and painted on an off-screen context, with played-in mouse
// and keys.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <memory>
#include <vector>

#include "desk_rig.h"
#include "ui/imgui_painter.h"

namespace ember {
namespace {

class Panels : public DeskRig {
  protected:
    void open(int width, int height, float scale) {
        DeskRig::open(width, height, scale, find_preset("paper/corner", ""));
        painter_ = std::make_unique<ImguiPainter>();
    }
    void TearDown() override {
        painter_.reset();
        close();
    }
    // The pixels of the last frame without the picture, rows from the bottom.
    std::vector<unsigned char> paint() {
        glBindFramebuffer(GL_FRAMEBUFFER, target_->name());
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        painter_->draw(*ImGui::GetDrawData(), target_->name());
        return pixels();
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

    std::unique_ptr<ImguiPainter> painter_;
};

TEST_F(Panels, LeaveThePictureFreeAndGoAwayTogether) {
    open(1280, 720, 1);
    bench().settings.show_info = false;
    bench().notices.dismiss();
    frames(2);
    const int edge = width_ - static_cast<int>(layout().panel);
    EXPECT_GT(lit(edge, width_), 2000u);
    bench().act(Action::TogglePanel);
    frames(2);
    EXPECT_EQ(layout().panel, 0);
    EXPECT_EQ(layout().picture.height, height_);
    EXPECT_EQ(lit(0, width_), 0u);
    bench().act(Action::ToggleHelp);
    frames(2);
    EXPECT_GT(lit(0, width_), 2000u);
}

TEST_F(Panels, NothingIsCutOffAtBothSizes) {
    for (const int scale : {1, 2}) {
        open(1280 * scale, 720 * scale, static_cast<float>(scale));
        bench().settings.show_profiler = bench().settings.show_plots = true;
        for (const Action action : {Action::Step, Action::ToggleHelp, Action::ToggleHelp,
                                    Action::SaveAs, Action::Cancel, Action::Record, Action::Cancel,
                                    Action::ToggleLog, Action::Cancel, Action::OpenPath}) {
            bench().act(action);
            frames(3);
            expect_everything_fits(binding_of(action).text);
        }
        TearDown();
    }
}

TEST_F(Panels, GrammageActsWhileItIsDraggedAndIsOneEntryToUndo) {
    open(1280, 720, 1);
    for (int i = 0; i < 10; ++i)
        bench().act(Action::Step);
    frames(3);
    const double before = bench().values.params.paper.grammage;
    const auto edited = [&] { return bench().values.params.paper.grammage != before; };
    const double x = width_ - 0.3 * double(layout().panel);
    ImGuiIO& io = ImGui::GetIO();
    for (double y = double(layout().menu) + 20; y < 400 && !edited(); y += 4) {
        point(x, y);
        io.MouseDown[0] = true;
        frame();
        point(x + 30, y);
        if (edited()) break;
        io.MouseDown[0] = false;
        frames(3);
    }
    ASSERT_TRUE(edited()) << "while it is held";
    point(io.MousePos.x + 10, io.MousePos.y);
    io.MouseDown[0] = false;
    frames(3);
    EXPECT_GT(bench().snapshot().params.paper.grammage, before);
    EXPECT_EQ(bench().snapshot().stats.tick, 10u);
    EXPECT_EQ(bench().history().size(), 1u);
    bench().act(Action::Undo);
    frames(3);
    EXPECT_EQ(bench().snapshot().params.paper.grammage, before);
}

TEST_F(Panels, TypingIntoAFieldIsNoShortcut) {
    open(1280, 720, 1);
    bench().act(Action::SaveAs);
    frames(3);
    EXPECT_TRUE(ImGui::GetIO().WantTextInput) << "keys go to the field";
    ImGui::GetIO().AddInputCharacter('q');
    frames(2);
    bench().act(Action::Cancel);
    frames(3);
    EXPECT_FALSE(ImGui::GetIO().WantTextInput);
}

}  // namespace
}  // namespace ember
