#include "ui/bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace ember {
namespace {

using enum Action;

// The order is that of menus and of the help sheet. Keys that do the same stand together.
constexpr KeyBinding kKeys[] = {
    {GLFW_KEY_O, true, false, false, OpenBrowser, "File", "Ctrl+O", "open a preset"},
    {0, false, false, false, OpenPath, "File", "", "open a file by its path"},
    {GLFW_KEY_S, true, false, false, Save, "File", "Ctrl+S", "save the preset"},
    {GLFW_KEY_S, true, true, false, SaveAs, "File", "Ctrl+Shift+S", "save as"},
    {GLFW_KEY_R, true, false, false, Reload, "File", "Ctrl+R", "read the preset again"},
    {GLFW_KEY_F5, false, false, false, Reload, "File", "F5", "read the preset again"},
    {GLFW_KEY_T, true, false, false, SaveTake, "File", "Ctrl+T", "save what was done as a take"},
    {GLFW_KEY_F12, false, false, false, Screenshot, "File", "F12", "screenshot"},
    {GLFW_KEY_F12, true, false, false, ScreenshotClear, "File", "Ctrl+F12",
     "screenshot, transparent"},
    {GLFW_KEY_E, true, false, false, Record, "File", "Ctrl+E", "record frames or a film"},
    {GLFW_KEY_C, true, true, false, CopyCommand, "File", "Ctrl+Shift+C", "copy as command line"},
    {GLFW_KEY_Q, true, false, false, Quit, "File", "Ctrl+Q", "quit"},
    {GLFW_KEY_Z, true, false, true, Undo, "Edit", "Ctrl+Z", "undo"},
    {GLFW_KEY_Z, true, true, true, Redo, "Edit", "Ctrl+Shift+Z", "redo"},
    {GLFW_KEY_Y, true, false, true, Redo, "Edit", "Ctrl+Y", "redo"},
    {GLFW_KEY_C, true, false, false, CopyCamera, "Edit", "Ctrl+C", "copy the camera"},
    {GLFW_KEY_V, true, false, false, PasteCamera, "Edit", "Ctrl+V", "paste a camera"},
    {GLFW_KEY_X, false, false, false, SwapSlots, "Edit", "X", "change to the other slot, A or B"},
    {GLFW_KEY_D, true, false, false, StoreSlot, "Edit", "Ctrl+D", "copy this slot to the other"},
    {GLFW_KEY_SPACE, false, false, false, TogglePlay, "Time", "Space", "play or pause"},
    {GLFW_KEY_RIGHT, false, false, true, Step, "Time", "Right", "one tick forward"},
    {GLFW_KEY_PERIOD, false, false, true, Step, "Time", ".", "one tick forward"},
    {GLFW_KEY_LEFT, false, false, true, StepBack, "Time", "Left", "one tick back"},
    {GLFW_KEY_COMMA, false, false, true, StepBack, "Time", ",", "one tick back"},
    {GLFW_KEY_RIGHT, false, true, true, StepTen, "Time", "Shift+Right", "ten ticks forward"},
    {GLFW_KEY_LEFT, false, true, true, StepBackTen, "Time", "Shift+Left", "ten ticks back"},
    {GLFW_KEY_LEFT, true, false, false, ToStart, "Time", "Ctrl+Left", "to the start"},
    {GLFW_KEY_RIGHT, true, false, false, ToEnd, "Time", "Ctrl+Right",
     "to the end of the burn so far"},
    {GLFW_KEY_R, false, false, false, Restart, "Time", "R", "burn anew from the start"},
    {GLFW_KEY_MINUS, false, false, true, Slower, "Time", "-", "slower"},
    {GLFW_KEY_EQUAL, false, false, true, Faster, "Time", "=", "faster"},
    {GLFW_KEY_EQUAL, false, true, true, Faster, "Time", "+", "faster"},
    {GLFW_KEY_O, false, false, false, ToggleLoop, "Time", "O", "loop the burn so far"},
    {GLFW_KEY_T, false, false, false, Retry, "Time", "T", "after a stop: retry with smaller step"},
    {GLFW_KEY_V, false, false, false, NextView, "View", "V", "next view"},
    {GLFW_KEY_S, false, false, false, NextView, "View", "S", "next view"},
    {GLFW_KEY_B, false, false, false, ToggleLegend, "View", "B", "scalar bar on or off"},
    {GLFW_KEY_L, false, false, false, ToggleFlames, "View", "L", "flames on or off"},
    {GLFW_KEY_F, false, false, false, HomeCamera, "View", "F", "camera as in the preset"},
    {GLFW_KEY_HOME, false, false, false, HomeCamera, "View", "Home", "camera as in the preset"},
    {GLFW_KEY_1, false, false, false, CameraFront, "View", "1", "from the front"},
    {GLFW_KEY_3, false, false, false, CameraSide, "View", "3", "from the side"},
    {GLFW_KEY_7, false, false, false, CameraTop, "View", "7", "from above"},
    {GLFW_KEY_9, false, false, false, CameraThreeQuarter, "View", "9", "from three quarters"},
    {GLFW_KEY_5, false, false, false, CameraFlat, "View", "5", "flat, from far away, or as before"},
    {GLFW_KEY_LEFT_BRACKET, false, false, false, PreviousCamera, "View", "[", "previous camera"},
    {GLFW_KEY_RIGHT_BRACKET, false, false, false, NextCamera, "View", "]", "next camera"},
    {GLFW_KEY_D, false, false, false, SideBySide, "View", "D", "slots A and B side by side"},
    {GLFW_KEY_TAB, false, false, false, Compare, "", "hold Tab", "look at the other slot"},
    {GLFW_KEY_F11, false, false, false, FullScreen, "View", "F11", "full screen"},
    {GLFW_KEY_P, false, false, false, PlaceLighter, "Lighter", "P", "place the lighter by a click"},
    {GLFW_KEY_I, false, false, false, LightNow, "Lighter", "I", "light it now"},
    {GLFW_KEY_K, false, false, false, RecordPath, "Lighter", "K", "its movements become its path"},
    {GLFW_KEY_N, false, false, false, AddLighter, "Lighter", "N", "another lighter"},
    {GLFW_KEY_DELETE, false, false, false, RemoveLighter, "Lighter", "Del", "remove the lighter"},
    {GLFW_KEY_F1, false, false, false, ToggleHelp, "Help", "F1", "keys and mouse"},
    {GLFW_KEY_H, false, false, false, ToggleHelp, "Help", "H", "keys and mouse"},
    {GLFW_KEY_SLASH, false, true, false, ToggleHelp, "Help", "?", "keys and mouse"},
    {GLFW_KEY_F2, false, false, false, ToggleInfo, "Help", "F2", "figures of the burn"},
    {GLFW_KEY_F3, false, false, false, ToggleProfiler, "Help", "F3", "where the time goes"},
    {GLFW_KEY_F4, false, false, false, TogglePlots, "Help", "F4", "plots over time"},
    {GLFW_KEY_F6, false, false, false, ToggleLog, "Help", "F6", "messages so far"},
    {GLFW_KEY_B, true, false, false, TogglePanel, "View", "Ctrl+B", "only the picture"},
    {GLFW_KEY_ESCAPE, false, false, false, Cancel, "", "Esc", "close what is open, stop placing"},
};

constexpr unsigned kViewer = 1, kBlender = 2, kMaya = 4, kAll = 7;

constexpr DragBinding kDrags[] = {
    {kViewer, GLFW_MOUSE_BUTTON_LEFT, false, false, false, Drag::Orbit, "drag",
     "turn around the paper"},
    {kViewer, GLFW_MOUSE_BUTTON_LEFT, true, false, false, Drag::Pan, "Shift + drag",
     "move the picture"},
    {kViewer, GLFW_MOUSE_BUTTON_MIDDLE, false, false, false, Drag::Pan, "middle drag",
     "move the picture"},
    {kBlender, GLFW_MOUSE_BUTTON_MIDDLE, false, false, false, Drag::Orbit, "middle drag",
     "turn around the paper"},
    {kBlender, GLFW_MOUSE_BUTTON_MIDDLE, true, false, false, Drag::Pan, "Shift + middle drag",
     "move the picture"},
    {kBlender, GLFW_MOUSE_BUTTON_MIDDLE, false, true, false, Drag::Zoom, "Ctrl + middle drag",
     "nearer or farther away"},
    {kMaya, GLFW_MOUSE_BUTTON_LEFT, false, false, true, Drag::Orbit, "Alt + drag",
     "turn around the paper"},
    {kMaya, GLFW_MOUSE_BUTTON_MIDDLE, false, false, true, Drag::Pan, "Alt + middle drag",
     "move the picture"},
    {kMaya, GLFW_MOUSE_BUTTON_RIGHT, false, false, true, Drag::Zoom, "Alt + right drag",
     "nearer or farther away"},
    {kAll, GLFW_MOUSE_BUTTON_LEFT, false, true, false, Drag::PlaceLighter, "Ctrl + click or drag",
     "put the lighter there"},
    {kAll, GLFW_MOUSE_BUTTON_LEFT, true, true, false, Drag::Ignite, "Ctrl + Shift + drag",
     "set fire to the paper"},
    {kAll, GLFW_MOUSE_BUTTON_RIGHT, false, false, false, Drag::Touch, "right drag",
     "touch the paper and pull"},
    {kAll, GLFW_MOUSE_BUTTON_RIGHT, true, false, false, Drag::Blow, "Shift + right drag", "blow"},
    {kAll, GLFW_MOUSE_BUTTON_RIGHT, false, true, false, Drag::TurnLight, "Ctrl + right drag",
     "turn the lamp around the paper"},
};

constexpr MouseHint kHints[] = {
    {"wheel", "nearer or farther away"},
    {"Ctrl + wheel", "the same, towards what is under the mouse"},
    {"drag a lighter's handles", "move it, its height, its nozzle; Ctrl snaps to 5 mm"},
    {"rest on the paper", "what is there: temperature, mass, stress"},
    {"Ctrl + click on a value", "type it"},
    {"right click on a value", "reset it, copy it, paste it"},
    {"double click on a name", "reset it to the preset"},
    {"drop a file on the window", "open a preset, a take, or the settings of a picture"},
};

// A table cell: '|' would end it.
std::string cell(const std::string& text) {
    return text == "|" ? "\\|" : text;
}

}  // namespace

std::span<const KeyBinding> key_bindings() {
    return kKeys;
}

const KeyBinding* find_binding(int key, bool control, bool shift, bool repeated) {
    const auto found = std::ranges::find_if(kKeys, [&](const KeyBinding& b) {
        return b.key != 0 && b.key == key && b.control == control && b.shift == shift &&
               (b.repeats || !repeated);
    });
    return found == std::end(kKeys) ? nullptr : &*found;
}

const KeyBinding& binding_of(Action action) {
    return *std::ranges::find(kKeys, action, &KeyBinding::action);
}

std::span<const DragBinding> drag_bindings() {
    return kDrags;
}

bool in_scheme(const DragBinding& drag, CameraScheme scheme) {
    return (drag.schemes >> static_cast<unsigned>(scheme) & 1u) != 0;
}

std::optional<Drag> find_drag(CameraScheme scheme, int button, bool shift, bool control, bool alt) {
    for (const DragBinding& b : kDrags) {
        const bool same = b.shift == shift && b.control == control && b.alt == alt;
        if (in_scheme(b, scheme) && b.button == button && same) return b.drag;
    }
    return std::nullopt;
}

std::span<const MouseHint> mouse_hints() {
    return kHints;
}

std::string bindings_markdown() {
    std::string out =
        "# The window: keys and mouse\n\nGenerated from the table that the program obeys "
        "(`ui/bindings.cpp`) by `emberleaf --list-bindings`; a test keeps it fresh. Keys act when "
        "no text is being typed.\n\n| key | what it does | menu |\n|---|---|---|\n";
    for (const KeyBinding& b : kKeys)
        out += "| " + cell(b.name) + " | " + b.text + " | " + b.menu + " |\n";
    out += "\n| mouse on the picture | what it does | camera scheme |\n|---|---|---|\n";
    for (const DragBinding& b : kDrags) {
        const char* scheme = b.schemes == kAll       ? "all"
                             : b.schemes == kViewer  ? "Viewer"
                             : b.schemes == kBlender ? "Blender"
                                                     : "Maya";
        out += std::string("| ") + b.name + " | " + b.text + " | " + scheme + " |\n";
    }
    out += "\n| mouse elsewhere | what it does |\n|---|---|\n";
    for (const MouseHint& hint : kHints)
        out += std::string("| ") + hint.name + " | " + hint.text + " |\n";
    return out;
}

}  // namespace ember
