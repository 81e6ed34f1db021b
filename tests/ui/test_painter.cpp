// The panels without a window: the painter on an off-screen context, with synthetic input.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "render/offscreen_context.h"
#include "ui/imgui_painter.h"
#include "ui/panels.h"
#include "ui/theme.h"

namespace ember {
namespace {

constexpr int kWidth = 640, kHeight = 480;

// An off-screen context with ImGui in it.
class Panels : public ::testing::Test {
  protected:
    void SetUp() override {
        context_ = OffscreenContext::create(GlBackend::OsMesa);
        renderer_ = std::make_unique<Renderer>(context_->loader());
        ImGui::CreateContext();
        apply_theme(1.0f);
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().DisplaySize = ImVec2(kWidth, kHeight);
        painter_ = std::make_unique<ImguiPainter>();
        allocate(colour_.emplace(), GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, kWidth, kHeight);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.emplace().name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_->name(),
                               0);
    }
    void TearDown() override {
        painter_.reset();
        ImGui::DestroyContext();
        colour_.reset();
        target_.reset();
        renderer_.reset();
    }
    // Lays out and paints one frame; returns the pixels, rows from the bottom.
    std::vector<unsigned char> paint(PanelModel& model, PanelRequests* requests = nullptr) {
        ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
        ImGui::NewFrame();
        const PanelRequests r = draw_panels(model);
        if (requests != nullptr) *requests = r;
        ImGui::Render();
        glBindFramebuffer(GL_FRAMEBUFFER, target_->name());
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        painter_->draw(*ImGui::GetDrawData(), target_->name());
        std::vector<unsigned char> pixels(std::size_t{kWidth} * kHeight * 4);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->name());
        glReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return pixels;
    }
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
    std::unique_ptr<ImguiPainter> painter_;
    std::optional<Texture> colour_;
    std::optional<Framebuffer> target_;
};

std::size_t lit_pixels(const std::vector<unsigned char>& pixels, int from_x, int to_x) {
    std::size_t count = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = from_x; x < to_x; ++x) {
            count +=
                pixels[(static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)) * 4] >
                100;
        }
    }
    return count;
}

TEST_F(Panels, ThePanelIsPaintedOnTheRightAndNowhereElse) {
    PanelModel model;
    model.title = "a title";
    model.show_statistics = false;
    paint(model);
    const auto pixels = paint(model);
    const int edge = kWidth - static_cast<int>(panel_width(model));
    EXPECT_GT(lit_pixels(pixels, edge, kWidth), 2000u);
    EXPECT_EQ(lit_pixels(pixels, 0, edge), 0u);
    model.show_panel = false;
    EXPECT_EQ(panel_width(model), 0);
    EXPECT_EQ(lit_pixels(paint(model), 0, kWidth), 0u);
    model.show_help = true;
    paint(model);
    EXPECT_GT(lit_pixels(paint(model), 0, kWidth), 500u);
}

TEST_F(Panels, StatisticsAndMessagesLieOverThePicture) {
    PanelModel model;
    model.show_panel = false;
    paint(model);
    const std::size_t statistics = lit_pixels(paint(model), 0, kWidth / 2);
    EXPECT_GT(statistics, 200u);
    model.message = "sheet.width: expected a number from 1 to 10000 mm, got 0";
    paint(model);
    EXPECT_GT(lit_pixels(paint(model), 0, kWidth), statistics + 200);
}

// Presses the mouse on every fourth row of points and drags it; says with what the panel answered.
class Dragged : public Panels {
  protected:
    struct Answer {
        bool while_held = false, when_released = false;
    };
    template <class Edited>
    Answer drag(PanelModel& model, Edited&& edited) {
        ImGuiIO& io = ImGui::GetIO();
        const float x = float{kWidth} - 0.25f * panel_width(model);
        paint(model);
        Answer answer;
        for (float y = 40; y < 320 && !edited(); y += 4) {
            PanelRequests requests;
            io.MousePos = ImVec2(x, y);
            paint(model);
            io.MouseDown[0] = true;
            paint(model, &requests);
            answer.while_held = requests.apply_params;
            io.MousePos.x += 30;
            paint(model, &requests);
            answer.while_held = answer.while_held || requests.apply_params;
            io.MouseDown[0] = false;
            paint(model, &requests);
            answer.when_released = requests.apply_params;
        }
        return answer;
    }
};

TEST_F(Dragged, ARowThatRestartsIsAppliedOnceWhenTheHandLetsGo) {
    PanelModel model;
    const Params before = model.params;
    const Answer answer =
        drag(model, [&] { return model.params.paper.grammage != before.paper.grammage; });
    EXPECT_GT(model.params.paper.grammage, before.paper.grammage);
    EXPECT_EQ(model.params.paper.density, before.paper.density);
    EXPECT_FALSE(answer.while_held);
    EXPECT_TRUE(answer.when_released);
}

TEST_F(Dragged, ALiveRowIsAppliedWhileItIsDragged) {
    PanelModel model;
    const Params before = model.params;
    const Answer answer =
        drag(model, [&] { return model.params.shrinkage.factor != before.shrinkage.factor; });
    EXPECT_GT(model.params.shrinkage.factor, before.shrinkage.factor);
    EXPECT_TRUE(answer.while_held);
}

}  // namespace
}  // namespace ember
