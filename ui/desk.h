// What the window shows and what its events do: panels, picture, keys and mouse. Knows no window
// system: whoever has one passes its events on, so that a test can play them in.
#pragma once

#include <string>
#include <vector>

#include "ui/dialogs.h"
#include "ui/lighter_handles.h"
#include "ui/overlays.h"
#include "ui/preset_browser.h"
#include "ui/scene_view.h"
#include "ui/speedometer.h"

namespace ember {

/// Lives between ImGui::CreateContext() and DestroyContext(); its GL context is current in every
/// call.
class Desk {
  public:
    /// `wake`: called from another thread when there is news of the burn. `shaders`: see SceneView.
    Desk(GlLoader loader, const std::string& version, Document document, const UserFolders& folders,
         const Settings& settings, int threads, std::function<void()> wake = {},
         const std::filesystem::path& shaders = {});

    // ---- events; they act with the next frame
    /// A key, named as GLFW does by what is printed on it, has gone down.
    void press(int key, bool control, bool shift, bool repeated);
    void release(int key);
    /// A file was dropped on the window.
    void drop(const std::string& path) { dropped_ = path; }
    /// The window was asked to close.
    void close() { bench_.act(Action::Quit); }

    /// Takes in what has happened until `now` [s]; whether there is anything new to draw.
    [[nodiscard]] bool begin(double now);
    /// Lays out everything and lets the mouse act on it. Call within an ImGui frame, which it ends.
    void lay_out();
    /// Draws what was laid out into framebuffer `target` of that size [pixels].
    void draw(int width, int height, unsigned target = 0);
    /// `seconds` went into the last picture.
    void drawn(double seconds) { speed_.drawn(seconds); }

    [[nodiscard]] Workbench& bench() { return bench_; }
    [[nodiscard]] const Layout& layout() const { return layout_; }
    /// "corner* - 1.25 s, paused - emberleaf"
    [[nodiscard]] std::string title() const;
    /// A child process draws or burns; it is asked how far it is.
    [[nodiscard]] bool working() const;

  private:
    void obey();
    void use_mouse();
    [[nodiscard]] bool changed();
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
    std::string dropped_;
    bool busy_ = false;
    std::uint64_t tick_ = 0, seen_ = 0;
    double last_ = -1;  // [s]
    Workbench bench_;   // the last: its thread calls `wake`, and ends first
};

}  // namespace ember
