// The window's contents without a window: laid out and painted on an off-screen context, with
// played-in mouse and keys.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "../app/temporary_folder.h"
#include "render/offscreen_context.h"
#include "ui/desk.h"
#include "ui/theme.h"

namespace ember {

class DeskRig : public ::testing::Test {
  protected:
    // Of that size, with text `scale` times as large.
    void open(int width, int height, float scale, const std::filesystem::path& preset) {
        width_ = width, height_ = height;
        context_ = OffscreenContext::create(backend_);
        ImGui::CreateContext();
        apply_theme(scale);
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = ImVec2(static_cast<float>(width), static_cast<float>(height));
        io.DeltaTime = 1.0f / 60.0f;
        io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
        const auto at = [&](const char* name) { return folder_.path() / name; };
        folders_ = {at("config"), at("presets"),  at("cache"),
                    at("state"),  at("pictures"), at("videos")};
        desk_ = std::make_unique<Desk>(context_->loader(), "test", open_document(preset), folders_,
                                       Settings(), 1);
        allocate(colour_.emplace(), GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.emplace().name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_->name(),
                               0);
        bench().act(Action::TogglePlay);
        bench().act(Action::ToStart);
        frames(3);
    }
    void close() {
        desk_.reset();
        if (ImGui::GetCurrentContext() != nullptr) ImGui::DestroyContext();
        colour_.reset();
        target_.reset();
        context_.reset();
    }
    void TearDown() override { close(); }

    [[nodiscard]] Workbench& bench() { return desk_->bench(); }
    [[nodiscard]] const Layout& layout() const { return desk_->layout(); }
    // Lays out everything for one frame.
    void frame() {
        time_ += 1.0 / 60.0;
        static_cast<void>(desk_->begin(time_));
        ImGui::NewFrame();
        desk_->lay_out();
    }
    // At least so many, and until the burn has answered.
    void frames(int count) {
        for (int i = 0; i < count || !bench().caught_up(); ++i) {
            frame();
            if (!bench().caught_up()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }
    // ---- events, as a window would pass them on
    void key(int code, bool control = false, bool shift = false) {
        desk_->press(code, control, shift, false);
        ImGui::GetIO().KeysDown[code] = true;
        frame();
        ImGui::GetIO().KeysDown[code] = false;
        desk_->release(code);
        frames(2);
    }
    void type(const char* text) {
        for (; *text != '\0'; ++text) {
            ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(*text));
            frame();
        }
    }
    void point(double x, double y) {
        ImGui::GetIO().MousePos = ImVec2(static_cast<float>(x), static_cast<float>(y));
        frame();
    }
    // Presses a mouse button at one place and lets go of it at another.
    void drag(double x, double y, double to_x, double to_y, int button = 0) {
        point(x, y);
        ImGui::GetIO().MouseDown[button] = true;
        frame();
        for (const double share : {0.25, 0.5, 0.75, 1.0})
            point(x + share * (to_x - x), y + share * (to_y - y));
        ImGui::GetIO().MouseDown[button] = false;
        frames(3);
    }
    void click(double x, double y, int button = 0) { drag(x, y, x, y, button); }

    // What `target_` holds, rows from the bottom.
    [[nodiscard]] std::vector<unsigned char> pixels() const {
        std::vector<unsigned char> pixels(static_cast<std::size_t>(width_) *
                                          static_cast<std::size_t>(height_) * 4);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, target_->name());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
        return pixels;
    }

    GlBackend backend_ = GlBackend::OsMesa;
    int width_ = 0, height_ = 0;
    double time_ = 0;
    TemporaryFolder folder_;
    UserFolders folders_;
    std::unique_ptr<OffscreenContext> context_;
    std::optional<Texture> colour_;
    std::optional<Framebuffer> target_;
    std::unique_ptr<Desk> desk_;
};

}  // namespace ember
