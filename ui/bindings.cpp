#include "ui/bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ember {
namespace {

constexpr KeyBinding kKeys[] = {
    {GLFW_KEY_SPACE, false, false, Action::TogglePlay, "Space", "play or pause"},
    {GLFW_KEY_RIGHT, false, true, Action::Step, "Right", "one tick forward"},
    {GLFW_KEY_PERIOD, false, true, Action::Step, ".", "one tick forward"},
    {GLFW_KEY_R, false, false, Action::Restart, "R", "restart"},
    {GLFW_KEY_P, false, false, Action::PlaceLighter, "P", "place the lighter by a click"},
    {GLFW_KEY_V, false, false, Action::NextView, "V", "next view"},
    {GLFW_KEY_L, false, false, Action::ToggleFlames, "L", "flames on or off"},
    {GLFW_KEY_F, false, false, Action::HomeCamera, "F", "camera as in the preset"},
    {GLFW_KEY_HOME, false, false, Action::HomeCamera, "Home", "camera as in the preset"},
    {GLFW_KEY_F1, false, false, Action::ToggleHelp, "F1", "this sheet"},
    {GLFW_KEY_F2, false, false, Action::ToggleStatistics, "F2", "statistics on or off"},
    {GLFW_KEY_B, true, false, Action::TogglePanel, "Ctrl+B", "panel on or off"},
    {GLFW_KEY_ESCAPE, false, false, Action::Cancel, "Esc", "close this sheet, stop placing"},
    {GLFW_KEY_Q, true, false, Action::Quit, "Ctrl+Q", "quit"},
};

constexpr DragBinding kDrags[] = {
    {GLFW_MOUSE_BUTTON_LEFT, false, false, Drag::Orbit, "drag the picture",
     "turn around the paper"},
    {GLFW_MOUSE_BUTTON_LEFT, true, false, Drag::Pan, "Shift + drag", "move the picture"},
    {GLFW_MOUSE_BUTTON_MIDDLE, false, false, Drag::Pan, "middle drag", "move the picture"},
    {GLFW_MOUSE_BUTTON_LEFT, false, true, Drag::PlaceLighter, "Ctrl + click or drag",
     "put the lighter there"},
};

constexpr MouseHint kHints[] = {
    {"wheel", "nearer or farther away"},
    {"Ctrl + click on a value", "type it"},
    {"right click on a value", "reset it"},
    {"double click on a name", "reset it to the preset"},
};

}  // namespace

std::span<const KeyBinding> key_bindings() {
    return kKeys;
}

const KeyBinding* find_binding(int key, bool control, bool repeated) {
    for (const KeyBinding& binding : kKeys) {
        if (binding.key == key && binding.control == control && (binding.repeats || !repeated)) {
            return &binding;
        }
    }
    return nullptr;
}

std::span<const DragBinding> drag_bindings() {
    return kDrags;
}

std::optional<Drag> find_drag(int button, bool shift, bool control) {
    for (const DragBinding& binding : kDrags) {
        if (binding.button == button && binding.shift == shift && binding.control == control) {
            return binding.drag;
        }
    }
    return std::nullopt;
}

std::span<const MouseHint> mouse_hints() {
    return kHints;
}

}  // namespace ember
