#include "ui/window_app.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <exception>
#include <utility>

#include "ui/desk.h"
#include "ui/param_widgets.h"
#include "ui/window.h"

namespace ember {
namespace {

constexpr int kFramesAfterEvent = 3;      // ImGui needs a few to settle
constexpr double kLongestSleep = 1.0;     // [s] between looks at files
constexpr double kSleepWhileWork = 0.25;  // [s] while a child draws
constexpr double kTitleEvery = 0.25;      // [s]

class App {
  public:
    App(Window& window, const WindowOptions& options, const UserFolders& folders,
        const Settings& settings)
        : window_(window),
          desk_(
              glfwGetProcAddress, options.version, options.document, folders, settings,
              options.threads, [] { glfwPostEmptyEvent(); }, options.shaders) {}

    // ---- what the callbacks call
    void input() { frames_due_ = kFramesAfterEvent; }
    /// A key of the keyboard, whatever is printed on it, has gone down.
    void tap(int key) { tapped_.push_back(key); }
    [[nodiscard]] Desk& desk() { return desk_; }

    void run() {
        while (!desk_.bench().requests.quit) {
            wait();
            const double now = glfwGetTime();
            if (glfwWindowShouldClose(window_.handle()) == GLFW_TRUE) {
                glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
                desk_.close();
            }
            const bool news = desk_.begin(now);
            if (std::exchange(desk_.bench().requests.full_screen, false))
                window_.toggle_full_screen();
            // ImGui fits a window to what is new in it a frame later
            if (news && !desk_.bench().snapshot().playing) frames_due_ = std::max(frames_due_, 2);
            if (!news && frames_due_ == 0) continue;
            frames_due_ = std::max(0, frames_due_ - 1);
            frame();
            desk_.drawn(glfwGetTime() - now);
            show_title();
        }
    }

    [[nodiscard]] Settings settings() {
        Settings settings = desk_.bench().settings;
        if (!window_.full_screen()) {
            glfwGetWindowSize(window_.handle(), &settings.width, &settings.height);
            settings.maximised = glfwGetWindowAttrib(window_.handle(), GLFW_MAXIMIZED) == GLFW_TRUE;
        }
        return settings;
    }

  private:
    // Sleeps until something happens: a paused window costs nothing.
    void wait() {
        if (frames_due_ > 0) return glfwPollEvents();
        double sleep = desk_.working() ? kSleepWhileWork : kLongestSleep;
        const double due =
            std::min(seconds_until_tooltip(), desk_.bench().notices.until_change(glfwGetTime()));
        sleep = std::min(sleep, due);
        const double before = glfwGetTime();
        glfwWaitEventsTimeout(std::max(0.001, sleep));
        if (due <= sleep && glfwGetTime() - before >= 0.95 * sleep) frames_due_ = 2;
    }

    void frame() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_.handle(), &width, &height);
        if (width == 0 || height == 0) return;  // minimised
        Gui::begin_frame(tapped_);
        tapped_.clear();
        desk_.lay_out();
        desk_.draw(width, height);
        glfwSwapBuffers(window_.handle());
    }

    void show_title() {
        const double now = glfwGetTime();
        if (desk_.bench().snapshot().playing && now - title_shown_ < kTitleEvery) return;
        title_shown_ = now;
        // setting it is an event, which would wake the loop again
        if (std::string title = desk_.title(); title != title_) {
            title_ = std::move(title);
            glfwSetWindowTitle(window_.handle(), title_.c_str());
        }
    }

    Window& window_;
    std::vector<int> tapped_;  // since the last frame
    std::string title_;
    int frames_due_ = kFramesAfterEvent;
    double title_shown_ = -kTitleEvery;  // [s]
    Desk desk_;
};

App* app_of(GLFWwindow* window) {
    return static_cast<App*>(glfwGetWindowUserPointer(window));
}

// A letter means what is printed on the key, wherever the keyboard's layout puts it.
int printed_key(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
    const auto letter = static_cast<unsigned char>(name[0]);
    return std::isalpha(letter) != 0 ? std::toupper(letter) : key;
}

// Before ImGui, which goes on calling them.
void listen(GLFWwindow* window) {
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int scancode, int action, int mods) {
        if (app_of(w) == nullptr) return;
        const int printed = printed_key(key, scancode);
        app_of(w)->input();
        if (action == GLFW_RELEASE) return app_of(w)->desk().release(printed);
        app_of(w)->tap(key);
        app_of(w)->desk().press(printed, (mods & GLFW_MOD_CONTROL) != 0,
                                (mods & GLFW_MOD_SHIFT) != 0, action == GLFW_REPEAT);
    });
    const auto wake = [](GLFWwindow* w) {
        if (app_of(w) != nullptr) app_of(w)->input();
    };
    static void (*const woken)(GLFWwindow*) = wake;
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { woken(w); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { woken(w); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { woken(w); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { woken(w); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { woken(w); });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { woken(w); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { woken(w); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { woken(w); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { woken(w); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        if (app_of(w) == nullptr || count == 0) return;
        app_of(w)->input();
        app_of(w)->desk().drop(paths[0]);
    });
}

}  // namespace

int run_window(const WindowOptions& options) {
    try {
        const UserFolders folders = user_folders();
        const std::filesystem::path file = folders.config / "settings";
        const bool first_time = !std::filesystem::exists(file);
        const Settings settings = read_settings(file);
        Window window(settings, options.ui_scale, "emberleaf");
        if (first_time) window.enlarge_by_scale();
        listen(window.handle());
        const Gui gui(window);
        App app(window, options, folders, settings);
        glfwSetWindowUserPointer(window.handle(), &app);
        app.run();
        glfwSetWindowUserPointer(window.handle(), nullptr);
        write_settings(file, app.settings());
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "emberleaf: %s\n", e.what());
        return 1;
    }
}

}  // namespace ember
