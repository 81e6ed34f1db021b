#include "ui/window_app.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include "render/camera.h"
#include "render/renderer.h"
#include "ui/bindings.h"
#include "ui/imgui_painter.h"
#include "ui/panels.h"
#include "ui/session.h"
#include "ui/theme.h"

namespace ember {
namespace {

constexpr int kWidth = 1280, kHeight = 720;
constexpr int kFramesAfterEvent = 3;      // ImGui needs a few to settle
constexpr double kIdleWait = 0.5;         // [s]
constexpr double kOrbitPerPixel = 0.008;  // [rad]

// GLFW for as long as it lives, with the window in it.
class Window {
  public:
    Window() {
        glfwSetErrorCallback([](int, const char* text) { last_error() = text; });
        if (glfwInit() != GLFW_TRUE) throw RenderError("no window system: " + last_error());
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
        handle_ = glfwCreateWindow(kWidth, kHeight, "emberleaf", nullptr, nullptr);
        if (handle_ == nullptr) {
            const std::string reason = last_error();
            glfwTerminate();
            throw RenderError("no window with OpenGL 3.3: " + reason);
        }
        glfwMakeContextCurrent(handle_);
        glfwSwapInterval(1);
    }
    ~Window() {
        glfwDestroyWindow(handle_);
        glfwTerminate();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    [[nodiscard]] GLFWwindow* handle() const { return handle_; }

  private:
    static std::string& last_error() {
        static std::string text = "unknown reason";
        return text;
    }
    GLFWwindow* handle_ = nullptr;
};

// ImGui for as long as it lives.
class Gui {
  public:
    explicit Gui(GLFWwindow* window) {
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;  // nothing is left lying in the current folder
        float scale_x = 1, scale_y = 1;
        glfwGetWindowContentScale(window, &scale_x, &scale_y);
        apply_theme(scale_x);
        ImGui_ImplGlfw_InitForOpenGL(window, true);
    }
    ~Gui() {
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
    }
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;
};

class App {
  public:
    App(Window& window, const WindowOptions& options)
        : window_(window.handle()),
          session_(options.params, options.threads),
          renderer_(glfwGetProcAddress) {
        model_.params = model_.preset_params = options.params;
        model_.render = model_.preset_render = options.render;
        model_.title = options.info.title;
        glfwSetWindowUserPointer(window_, this);
        session_.play();
    }

    void key(int key, int mods) {
        busy_frames_ = kFramesAfterEvent;
        if (ImGui::GetIO().WantTextInput) return;
        if (const auto action = action_of(key, (mods & GLFW_MOD_CONTROL) != 0)) act(*action);
    }

    void run() {
        double last = glfwGetTime();
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            if (session_.playing() || busy_frames_ > 0) {
                glfwPollEvents();
            } else {
                glfwWaitEventsTimeout(kIdleWait);
                busy_frames_ = kFramesAfterEvent - 1;
            }
            const double now = glfwGetTime();
            session_.advance(now - last);
            model_.frame_ms = 0.9 * model_.frame_ms + 100.0 * (now - last);
            last = now;
            frame();
            if (busy_frames_ > 0) --busy_frames_;
        }
    }

  private:
    void act(Action action) {
        ViewParams& view = model_.render.view;
        switch (action) {
            case Action::TogglePlay:
                session_.toggle();
                break;
            case Action::Step:
                session_.step_once();
                break;
            case Action::Restart:
                session_.restart();
                break;
            case Action::NextView:
                view.mode = static_cast<ViewMode>((static_cast<int>(view.mode) + 1) % 5);
                break;
            case Action::ToggleFlames:
                view.flames = !view.flames;
                break;
            case Action::HomeCamera:
                model_.render.camera = model_.preset_render.camera;
                break;
            case Action::ToggleHelp:
                model_.show_help = !model_.show_help;
                break;
            case Action::TogglePanel:
                model_.show_panel = !model_.show_panel;
                break;
            case Action::Quit:
                glfwSetWindowShouldClose(window_, GLFW_TRUE);
                break;
        }
    }

    // Where a click meets the plane of the sheet: upright through the held edge, or level with it.
    void place_lighter(double x, double y, int width, int height) {
        const Camera camera = make_camera(model_.render.camera, width, height);
        const Eigen::Vector3f ray = ray_through(camera, x, y, width, height);
        const bool upright = model_.params.sheet.pose == SheetPose::Hanging;
        const float level = upright ? 0.0f : static_cast<float>(model_.params.sheet.elevation);
        const int axis = upright ? 2 : 1;
        if (std::abs(ray[axis]) < 1e-4f) return;
        const float distance = (level - camera.eye[axis]) / ray[axis];
        if (!(distance > 0)) return;
        const Eigen::Vector3f hit = camera.eye + distance * ray;
        model_.params.lighter.x = hit.x();
        model_.params.lighter.y = hit.y();
        model_.params.lighter.z = hit.z();
        model_.params.lighter.on = true;
        // lit now, for as long as it was to burn
        model_.params.lighter.start = session_.world().state().time;
        session_.apply(model_.params);
    }

    void mouse() {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantCaptureMouse) return;
        CameraParams& camera = model_.render.camera;
        const double dx = io.MouseDelta.x, dy = io.MouseDelta.y, height = io.DisplaySize.y;
        const bool left = io.MouseDown[0];
        if (io.KeyCtrl && io.MouseClicked[0]) {
            place_lighter(io.MousePos.x, io.MousePos.y, static_cast<int>(io.DisplaySize.x),
                          static_cast<int>(io.DisplaySize.y));
        } else if (io.MouseDown[2] || (left && io.KeyShift)) {
            pan(camera, -dx / height, dy / height);
        } else if (left && !io.KeyCtrl) {
            orbit(camera, -kOrbitPerPixel * dx, kOrbitPerPixel * dy);
        }
        if (io.MouseWheel != 0) zoom(camera, std::pow(1.15, io.MouseWheel));
        const bool moving = left || io.MouseDown[1] || io.MouseDown[2] || io.MouseWheel != 0;
        if (moving) busy_frames_ = kFramesAfterEvent;
    }

    void frame() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        if (width == 0 || height == 0) return;  // minimised
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        model_.stats = session_.stats();
        model_.message = session_.message();
        model_.playing = session_.playing();
        const PanelRequests requests = draw_panels(model_);
        if (requests.params_changed) session_.apply(model_.params);
        if (requests.toggle_play) session_.toggle();
        if (requests.step) session_.step_once();
        if (requests.restart) session_.restart();
        mouse();
        draw(width, height);
        glfwSwapBuffers(window_);
        char title[64];
        std::snprintf(title, sizeof title, "emberleaf %.2f s", model_.stats.time);
        if (title_ != title) glfwSetWindowTitle(window_, title);
        title_ = title;
    }

    void draw(int width, int height) {
        const WorldView view = session_.world().view();
        std::vector<std::vector<SpringSegment>> springs;
        if (model_.render.view.mode == ViewMode::Lattice) {
            for (std::size_t s = 0; s < view.sheets.size(); ++s) {
                springs.push_back(session_.world().springs(s));
            }
        }
        renderer_.draw({&view, springs}, model_.render, width, height);
        ImGui::Render();
        painter_.draw(*ImGui::GetDrawData());
    }

    GLFWwindow* window_;
    Session session_;
    PanelModel model_;
    Renderer renderer_;
    ImguiPainter painter_;
    int busy_frames_ = kFramesAfterEvent;
    std::string title_;
};

void on_key(GLFWwindow* window, int key, int, int action, int mods) {
    auto* app = static_cast<App*>(glfwGetWindowUserPointer(window));
    if (app != nullptr && (action == GLFW_PRESS || action == GLFW_REPEAT)) app->key(key, mods);
}

}  // namespace

int run_window(const WindowOptions& options) {
    try {
        Window window;
        glfwSetKeyCallback(window.handle(), on_key);  // before ImGui, which chains to it
        const Gui gui(window.handle());
        App(window, options).run();
        return 0;
    } catch (const RenderError& e) {
        std::fprintf(stderr, "emberleaf: %s\n", e.what());
        return 1;
    }
}

}  // namespace ember
