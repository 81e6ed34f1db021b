#include "ui/window_app.h"

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <exception>

#include "render/camera.h"
#include "render/renderer.h"
#include "sim/lighter.h"
#include "sim/param_table.h"
#include "ui/imgui_painter.h"
#include "ui/kept_picture.h"
#include "ui/panels.h"
#include "ui/param_widgets.h"
#include "ui/picture_controls.h"
#include "ui/window.h"

namespace ember {
namespace {

constexpr int kWidth = 1280, kHeight = 720;  // [points]
constexpr int kFramesAfterEvent = 3;         // ImGui needs a few to settle
constexpr double kLongestSleep = 10.0;       // [s]
constexpr double kTickBudget = 0.012;        // [s] of a picture's time that ticks may take
constexpr double kTitleEvery = 0.25;         // [s]

// The part of the window that shows the paper, in points from the upper left corner.
struct Picture {
    double width = 1, height = 1;
    [[nodiscard]] int columns() const { return static_cast<int>(width); }
    [[nodiscard]] int rows() const { return static_cast<int>(height); }
};

class App {
  public:
    App(const Window& window, const WindowOptions& options)
        : window_(window.handle()),
          session_(options.params, options.threads),
          renderer_(glfwGetProcAddress) {
        model_.params = model_.preset_params = options.params;
        model_.render = model_.preset_render = options.render;
        model_.title = options.info.title;
        if (model_.title.empty()) model_.title = options.info.path.stem().string();
        model_.warnings = plausibility_warnings(options.params);
        session_.play();
    }

    /// A key has gone down; it acts with the next frame.
    void press(int key, bool control, bool repeated) {
        if (ImGui::GetIO().WantTextInput) return;
        if (const KeyBinding* binding = find_binding(key, control, repeated)) {
            pressed_.push_back(binding->action);
        }
    }

    void run() {
        double last = glfwGetTime();
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            wait();
            const double now = glfwGetTime();
            const int ticks = simulate(now - last);
            last = now;
            const double simulated = glfwGetTime();
            for (const Action action : std::exchange(pressed_, {}))
                act(action);
            if (ticks == 0 && frames_due_ == 0) continue;
            frames_due_ = std::max(0, frames_due_ - 1);
            frame();
            speed_.drawn(glfwGetTime() - simulated);
            show_title();
        }
    }

  private:
    // Sleeps until something happens or a tick is due: a paused window costs nothing.
    void wait() {
        if (frames_due_ > 0) return glfwPollEvents();
        double sleep = std::min(kLongestSleep, seconds_until_tooltip());
        if (session_.playing()) sleep = std::min(sleep, session_.until_next_tick());
        if (sleep <= 0) return glfwPollEvents();
        const double before = glfwGetTime();
        glfwWaitEventsTimeout(sleep);
        const bool event = glfwGetTime() - before < 0.95 * sleep;
        const bool tooltip = !session_.playing() && sleep < kLongestSleep;
        if (event || tooltip) frames_due_ = kFramesAfterEvent;
    }

    int simulate(double seconds) {
        const double begin = glfwGetTime();
        const double budget = std::max(kTickBudget, 1e-3 * speed_.times().picture_ms);
        const auto time_left = [&] { return glfwGetTime() - begin < budget; };
        const int ticks = session_.advance(seconds, time_left);
        speed_.simulated(ticks, session_.world().tick_duration(), glfwGetTime() - begin);
        speed_.passed(seconds, session_.playing());
        return ticks;
    }

    void act(Action action) {
        frames_due_ = kFramesAfterEvent;
        ViewParams& view = model_.render.view;
        switch (action) {
            case Action::TogglePlay:
                return session_.toggle();
            case Action::Step:
                return session_.step_once();
            case Action::Restart:
                return restart();
            case Action::NextView:
                return next_view();
            case Action::ToggleFlames:
                view.flames = !view.flames;
                return;
            case Action::PlaceLighter:
                model_.placing = !model_.placing;
                return;
            case Action::HomeCamera:
                model_.render.camera = model_.preset_render.camera;
                return;
            case Action::ToggleStatistics:
                model_.show_statistics = !model_.show_statistics;
                return;
            case Action::ToggleHelp:
                model_.show_help = !model_.show_help;
                return;
            case Action::TogglePanel:
                model_.show_panel = !model_.show_panel;
                return;
            case Action::Cancel:
                model_.show_help = model_.placing = false;
                return;
            case Action::Quit:
                return glfwSetWindowShouldClose(window_, GLFW_TRUE);
        }
    }

    void next_view() {
        const ParamInfo& row = *find_param(render_param_rows(), "view.mode");
        const double next = row.get(&model_.render) + 1;
        row.set(&model_.render, next < static_cast<double>(row.choices.size()) ? next : 0);
    }

    // A lighter that was lit by hand in mid-burn would leave the next burn waiting for it.
    void restart() {
        if (lit_by_hand_) {
            LighterParams lighter = lighters_of(model_.params).front();
            lighter.start = lighters_of(model_.preset_params).front().start;
            set_lighter(model_.params, 0, lighter);
        }
        lit_by_hand_ = false;
        apply();
        session_.restart();
    }

    void apply() {
        if (session_.apply(model_.params) == EditOutcome::Refused) {
            model_.params = session_.params();  // show what there is
        }
        model_.warnings = plausibility_warnings(model_.params);
    }

    void place_lighter(const Vector3& place) {
        const WorldView view = session_.world().view();
        const bool lit = view.lighters.front().lit;
        lit_by_hand_ = lit_by_hand_ || !lit;
        LighterParams lighter = lighters_of(model_.params).front();
        move_lighter(lighter, place, lit, view.time);
        set_lighter(model_.params, 0, lighter);
        apply();
    }

    void place_lighter_at(const PicturePoint& place, const Picture& picture) {
        const int width = picture.columns(), height = picture.rows();
        const Camera camera = make_camera(model_.render.camera, width, height);
        const Vector3 ray = ray_through(camera, place.x, place.y, width, height).cast<double>();
        const auto hit =
            pick(session_.world().view(), model_.params, camera.eye.cast<double>(), ray);
        if (hit) place_lighter(*hit);
    }

    void obey(const PanelRequests& requests) {
        if (requests.apply_params) apply();
        if (requests.action) act(*requests.action);
        if (requests.light_now) place_lighter(session_.world().view().lighters.front().position);
        if (requests.lighter_spot) {
            const WorldView view = session_.world().view();
            const auto place = lighter_below(view.sheets.front(), *requests.lighter_spot);
            if (place) place_lighter(*place);
        }
    }

    void frame() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_, &width, &height);
        if (width == 0 || height == 0) return;  // minimised
        Gui::begin_frame();
        model_.stats = session_.stats();
        model_.times = speed_.times();
        model_.message = session_.message();
        model_.playing = session_.playing();
        obey(draw_panels(model_));
        const ImGuiIO& io = ImGui::GetIO();
        const Picture picture{std::max(1.0, double(io.DisplaySize.x - panel_width(model_))),
                              double(io.DisplaySize.y)};
        const auto place = controls_.update(model_.render.camera, picture.height, model_.placing);
        if (place) place_lighter_at(*place, picture);
        ImGui::Render();
        const double scale = double(io.DisplayFramebufferScale.x);
        draw(static_cast<int>(std::ceil(picture.width * scale)), height);
        painter_.draw(*ImGui::GetDrawData());
        glfwSwapBuffers(window_);
    }

    // The panel is at the right, so that the picture fills the framebuffer from its origin.
    void draw(int width, int height) {
        if (!kept_.holds({session_.revision(), model_.render, width, height})) {
            const WorldView view = session_.world().view();
            std::vector<std::vector<SpringSegment>> springs;
            if (needs_springs(model_.render.view.mode)) {
                for (std::size_t s = 0; s < view.sheets.size(); ++s) {
                    springs.push_back(session_.world().springs(s));
                }
            }
            renderer_.draw({&view, springs}, model_.render, width, height, kept_.framebuffer());
        }
        kept_.show();
    }

    void show_title() {
        const double now = glfwGetTime();
        if (session_.playing() && now - title_shown_ < kTitleEvery) return;
        title_shown_ = now;
        char time[40];
        std::snprintf(time, sizeof time, " - %.2f s%s", session_.world().state().time,
                      session_.playing() ? "" : ", paused");
        std::string title = model_.title + time + " - emberleaf";
        if (title == title_) return;  // setting it is an event, which would wake the loop again
        title_ = std::move(title);
        glfwSetWindowTitle(window_, title_.c_str());
    }

    GLFWwindow* window_;
    Session session_;
    PanelModel model_;
    Renderer renderer_;
    KeptPicture kept_;
    ImguiPainter painter_;
    Speedometer speed_;
    std::vector<Action> pressed_;
    PictureControls controls_;
    bool lit_by_hand_ = false;
    int frames_due_ = kFramesAfterEvent;
    std::string title_;
    double title_shown_ = -kTitleEvery;  // [s]
};

// A letter means what is printed on the key, wherever the keyboard's layout puts it.
int printed_key(int key, int scancode) {
    const char* name = glfwGetKeyName(key, scancode);
    if (name == nullptr || name[0] == '\0' || name[1] != '\0') return key;
    const auto letter = static_cast<unsigned char>(name[0]);
    return std::isalpha(letter) != 0 ? std::toupper(letter) : key;
}

void on_key(GLFWwindow* window, int key, int scancode, int action, int mods) {
    auto* app = static_cast<App*>(glfwGetWindowUserPointer(window));
    if (app == nullptr || action == GLFW_RELEASE) return;
    app->press(printed_key(key, scancode), (mods & GLFW_MOD_CONTROL) != 0, action == GLFW_REPEAT);
}

}  // namespace

int run_window(const WindowOptions& options) {
    try {
        const Window window(kWidth, kHeight, "emberleaf");
        glfwSetKeyCallback(window.handle(), on_key);  // before ImGui, which goes on calling it
        const Gui gui(window);
        App app(window, options);
        glfwSetWindowUserPointer(window.handle(), &app);
        app.run();
        glfwSetWindowUserPointer(window.handle(), nullptr);
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "emberleaf: %s\n", e.what());
        return 1;
    }
}

}  // namespace ember
