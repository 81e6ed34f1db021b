#include "ui/window.h"

#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "render/renderer.h"
#include "ui/theme.h"

namespace ember {
namespace {

std::string last_error() {
    const char* text = nullptr;
    return glfwGetError(&text) != GLFW_NO_ERROR && text != nullptr ? text : "unknown reason";
}

}  // namespace

Window::Window(const Settings& settings, double ui_scale, const std::string& title)
    : ui_scale_(ui_scale) {
    if (glfwInit() != GLFW_TRUE) throw RenderError("no window can be opened: " + last_error());
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, settings.maximised ? GLFW_TRUE : GLFW_FALSE);
    handle_ = glfwCreateWindow(settings.width, settings.height, title.c_str(), nullptr, nullptr);
    if (handle_ == nullptr) {
        const std::string reason = last_error();
        glfwTerminate();
        throw RenderError("no window with OpenGL 3.3 can be opened: " + reason);
    }
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
}

Window::~Window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::enlarge_by_scale() {
    int width = 0, height = 0;
    glfwGetWindowSize(handle_, &width, &height);
    const auto scaled = [this](int size) {
        return static_cast<int>(static_cast<float>(size) * scale());
    };
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwSetWindowSize(handle_, std::min(scaled(width), mode->width),
                      std::min(scaled(height), mode->height));
}

bool Window::full_screen() const {
    return glfwGetWindowMonitor(handle_) != nullptr;
}

void Window::toggle_full_screen() {
    if (full_screen()) {
        glfwSetWindowMonitor(handle_, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwGetWindowPos(handle_, &x_, &y_);
    glfwGetWindowSize(handle_, &width_, &height_);
    glfwSetWindowMonitor(handle_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

float Window::scale() const {
    if (ui_scale_ > 0) return static_cast<float>(ui_scale_);
    float content = 1, vertical = 1;
    glfwGetWindowContentScale(handle_, &content, &vertical);
    int points = 0, pixels = 0, height = 0;
    glfwGetWindowSize(handle_, &points, &height);
    glfwGetFramebufferSize(handle_, &pixels, &height);
    // some systems scale points, others only say how dense the pixels are
    const bool known = points > 0 && pixels > 0;
    return known ? content * static_cast<float>(points) / static_cast<float>(pixels) : content;
}

Gui::Gui(const Window& window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;               // nothing is left lying in the current folder
    io.ConfigInputTextCursorBlink = false;  // a window where nothing moves may sleep
    apply_theme(window.scale());
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
}

void Gui::begin_frame(const std::vector<int>& tapped) {
    ImGui_ImplGlfw_NewFrame();
    bool* down = ImGui::GetIO().KeysDown;
    std::vector<int> over;
    for (const int key : tapped) {
        if (key < 0 || key > GLFW_KEY_LAST || down[key]) continue;
        down[key] = true;
        over.push_back(key);
    }
    ImGui::NewFrame();
    for (const int key : over)
        down[key] = false;
}

Gui::~Gui() {
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

}  // namespace ember
