// A window with a current OpenGL 3.3 core context.
#pragma once

#include <string>

struct GLFWwindow;

namespace ember {

/// One per program: GLFW lives and dies with it.
class Window {
  public:
    /// Sizes are in points and scale with the monitor. Throws RenderError with the reason where
    /// there is no display or no OpenGL 3.3.
    Window(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    [[nodiscard]] GLFWwindow* handle() const { return handle_; }
    /// Points per font point: 1 at 96 dpi.
    [[nodiscard]] float scale() const;

  private:
    GLFWwindow* handle_ = nullptr;
};

/// Dear ImGui's context, fed by a window's events. Keeps nothing on disk.
class Gui {
  public:
    /// Callbacks that the window already has go on being called.
    explicit Gui(const Window& window);
    ~Gui();
    /// Takes in what has happened since the last frame; ImGui::Render() ends it.
    static void begin_frame();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
};

}  // namespace ember
