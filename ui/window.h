// A window with a current OpenGL 3.3 core context.
#pragma once

#include <string>
#include <vector>

#include "ui/settings.h"

struct GLFWwindow;

namespace ember {

/// One per program: GLFW lives and dies with it.
class Window {
  public:
    /// Of the remembered size. `ui_scale` 0: as the monitor says. Throws RenderError with the
    /// reason where there is no display or no OpenGL 3.3.
    Window(const Settings& settings, double ui_scale, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return handle_; }
    /// Points per font point: 1 at 96 dpi.
    [[nodiscard]] float scale() const;
    /// Makes room for text of that scale, as far as the screen has it.
    void enlarge_by_scale();
    [[nodiscard]] bool full_screen() const;
    void toggle_full_screen();

  private:
    GLFWwindow* handle_ = nullptr;
    double ui_scale_;
    int x_ = 0, y_ = 0, width_ = 0, height_ = 0;  // before it filled the screen
};

/// Dear ImGui's context, fed by a window's events. Keeps nothing on disk.
class Gui {
  public:
    /// Callbacks that the window already has go on being called.
    explicit Gui(const Window& window);
    ~Gui();
    /// Takes in what has happened since the last frame; ImGui::Render() ends it. `tapped` are the
    /// keys that have gone down since: one that is up again counts as down for this frame, because
    /// a tap is shorter than a frame may be.
    static void begin_frame(const std::vector<int>& tapped);
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
};

}  // namespace ember
