#include "ui/window_app.h"

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <exception>

#include "ui/camera_text.h"
#include "ui/dialogs.h"
#include "ui/lighter_handles.h"
#include "ui/overlays.h"
#include "ui/param_widgets.h"
#include "ui/preset_browser.h"
#include "ui/scene_view.h"
#include "ui/speedometer.h"
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
          scene_(glfwGetProcAddress, options.version),
          browser_(folders.cache),
          bench_(options.document, folders, settings, options.threads,
                 [] { glfwPostEmptyEvent(); }) {}

    /// A key has gone down; it acts with the next frame.
    void press(int key, bool control, bool shift, bool repeated) {
        input();
        if (ImGui::GetIO().WantTextInput) return;
        if (const KeyBinding* binding = find_binding(key, control, shift, repeated))
            pressed_.push_back(binding->action);
    }
    /// A key of the keyboard, whatever is printed on it, has gone down.
    void tap(int key) { tapped_.push_back(key); }
    void release(int key) {
        input();
        if (key == binding_of(Action::Compare).key) bench_.shown.comparing = false;
    }
    void drop(const char* path) {
        input();
        dropped_ = path;
    }
    void input() { frames_due_ = kFramesAfterEvent; }

    void run() {
        double last = glfwGetTime();
        for (;;) {
            wait();
            const double now = glfwGetTime();
            bench_.begin_frame(now, busy_);
            for (const Action action : std::exchange(pressed_, {}))
                bench_.act(action);
            if (!dropped_.empty()) bench_.open(std::exchange(dropped_, {}));
            if (glfwWindowShouldClose(window_.handle()) == GLFW_TRUE) {
                glfwSetWindowShouldClose(window_.handle(), GLFW_FALSE);
                bench_.act(Action::Quit);
            }
            const Snapshot& shot = bench_.snapshot();
            const bool playing = shot.playing;
            const auto ticks = static_cast<int>(shot.stats.tick - std::min(tick_, shot.stats.tick));
            tick_ = shot.stats.tick;
            speed_.simulated(ticks, shot.timeline.tick_duration, shot.stats.tick_seconds * ticks);
            speed_.passed(now - last, playing);
            last = now;
            obey();
            if (bench_.requests.quit) return;
            const bool news = changed();
            // ImGui fits a window to what is new in it a frame later
            if (news && !playing) frames_due_ = std::max(frames_due_, 2);
            if (!news && frames_due_ == 0) continue;
            frames_due_ = std::max(0, frames_due_ - 1);
            frame();
            speed_.drawn(glfwGetTime() - now);
            show_title();
        }
    }

    [[nodiscard]] Settings settings() const {
        Settings settings = bench_.settings;
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
        const bool work =
            bench_.recording.state() == Recording::State::Running || browser_.working();
        double sleep = work ? kSleepWhileWork : kLongestSleep;
        const double due =
            std::min(seconds_until_tooltip(), bench_.notices.until_change(glfwGetTime()));
        sleep = std::min(sleep, due);
        const double before = glfwGetTime();
        glfwWaitEventsTimeout(std::max(0.001, sleep));
        if (due <= sleep && glfwGetTime() - before >= 0.95 * sleep) frames_due_ = 2;
    }

    // Whether anything but the mouse asks for another picture.
    bool changed() {
        const Snapshot& shot = bench_.snapshot();
        const std::uint64_t now = shot.revision + (shot.beside ? shot.beside->revision : 0) +
                                  shot.commands + bench_.notices.all().size() +
                                  static_cast<std::uint64_t>(bench_.recording.done()) +
                                  static_cast<std::uint64_t>(bench_.recording.state());
        return browser_.poll() || std::exchange(seen_, now) != now;
    }

    void obey() {
        WindowRequests& asked = bench_.requests;
        if (asked.full_screen) window_.toggle_full_screen();
        if (asked.copy) glfwSetClipboardString(window_.handle(), asked.copy->c_str());
        if (asked.paste_camera) {
            const char* text = glfwGetClipboardString(window_.handle());
            const auto camera = camera_from_text(text == nullptr ? "" : text);
            if (camera) bench_.values.render.camera = *camera;
            if (!camera) bench_.say(Severity::Warning, "the clipboard holds no camera");
        }
        if (asked.screenshot || asked.screenshot_clear)
            scene_.screenshot(bench_, layout_.picture, pixels_per_point(), asked.screenshot_clear);
        const bool quit = asked.quit;
        asked = {};
        asked.quit = quit;
    }

    [[nodiscard]] double pixels_per_point() const {
        return std::max(0.1, double(ImGui::GetIO().DisplayFramebufferScale.x));
    }

    void frame() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_.handle(), &width, &height);
        if (width == 0 || height == 0) return;  // minimised
        Gui::begin_frame(tapped_);
        tapped_.clear();
        layout_ = layout_of(bench_);
        plots_.add(bench_.pictured());
        draw_menu_bar(layout_, bench_);
        draw_main_panel(layout_, bench_);
        draw_timeline(layout_, bench_);
        draw_status_bar(layout_, bench_, speed_.times());
        use_mouse();
        draw_overlays(layout_, bench_, plots_);
        browser_.draw(layout_, bench_);
        dialogs_.draw(bench_);
        busy_ = ImGui::IsAnyItemActive() || controls_.dragging() || handles_.dragging();
        bench_.end_frame(busy_);
        ImGui::Render();
        scene_.draw(bench_, layout_.picture, pixels_per_point(), width, height);
        glfwSwapBuffers(window_.handle());
    }

    void use_mouse() {
        PictureRect tools = layout_.picture;
        if (bench_.both_shown()) tools.width /= 2;
        const PictureCamera picture = camera_of(tools, bench_.values.render.camera);
        const bool taken = handles_.update(picture, bench_);
        const auto drag = controls_.update(bench_.values.render.camera, bench_.settings.scheme,
                                           layout_.picture, bench_.shown.placing, taken);
        if (drag) tools_.use(*drag, picture, bench_);
        if (!taken && !drag && !controls_.dragging()) draw_probe(picture, bench_.pictured());
    }

    void show_title() {
        const double now = glfwGetTime();
        if (bench_.snapshot().playing && now - title_shown_ < kTitleEvery) return;
        title_shown_ = now;
        char time[40];
        std::snprintf(time, sizeof time, " - %.2f s%s", bench_.snapshot().stats.time,
                      bench_.snapshot().playing ? "" : ", paused");
        std::string title =
            bench_.document().title() + (bench_.dirty() ? "*" : "") + time + " - emberleaf";
        if (title == title_) return;  // setting it is an event, which would wake the loop again
        title_ = std::move(title);
        glfwSetWindowTitle(window_.handle(), title_.c_str());
    }

    Window& window_;
    SceneView scene_;
    PresetBrowser browser_;
    Dialogs dialogs_;
    PlotData plots_;
    PictureControls controls_;
    LighterHandles handles_;
    PaperTools tools_;
    Speedometer speed_;
    Layout layout_;
    std::vector<Action> pressed_;
    std::vector<int> tapped_;  // since the last frame
    std::string dropped_, title_;
    bool busy_ = false;
    int frames_due_ = kFramesAfterEvent;
    std::uint64_t tick_ = 0, seen_ = 0;
    double title_shown_ = -kTitleEvery;  // [s]
    Workbench bench_;                    // the last: its thread wakes the loop, and ends first
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
        if (action == GLFW_RELEASE) return app_of(w)->release(printed);
        app_of(w)->tap(key);
        app_of(w)->press(printed, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0,
                         action == GLFW_REPEAT);
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
        if (app_of(w) != nullptr && count > 0) app_of(w)->drop(paths[0]);
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
