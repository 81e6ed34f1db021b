// How the window is divided, and the panel of parameters.
#pragma once

#include "ui/picture_controls.h"
#include "ui/workbench.h"

namespace ember {

/// The parts of the window [points]; the picture has what the others leave.
struct Layout {
    float menu = 0;    ///< height at the top
    float panel = 0;   ///< width at the right
    float bottom = 0;  ///< height of timeline and status bar below the picture
    PictureRect picture;
};
/// Of the present ImGui display and font.
[[nodiscard]] Layout layout_of(const Workbench& bench);

/// The panel at the right: first parameters, read-outs, lighter, everything else.
void draw_main_panel(const Layout& layout, Workbench& bench);

/// The menus at the top, from the table of keys, with the preset's name.
void draw_menu_bar(const Layout& layout, Workbench& bench);

/// Buttons of time, and the burn so far to drag along.
void draw_timeline(const Layout& layout, Workbench& bench);

/// One line of figures at the bottom.
void draw_status_bar(const Layout& layout, const Workbench& bench, const struct FrameTimes& times);

/// A button that stands for a key, which its tooltip tells. An empty label is the action's text.
void action_button(Workbench& bench, Action action, const char* label, float width = 0,
                   bool pressed = false);

}  // namespace ember
