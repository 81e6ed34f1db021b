#include "ui/bindings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ember {
namespace {

constexpr Binding kBindings[] = {
    {GLFW_KEY_SPACE, false, Action::TogglePlay, "Space", "play, pause"},
    {GLFW_KEY_RIGHT, false, Action::Step, "Right", "one tick"},
    {GLFW_KEY_PERIOD, false, Action::Step, ".", "one tick"},
    {GLFW_KEY_R, false, Action::Restart, "R", "restart"},
    {GLFW_KEY_V, false, Action::NextView, "V", "next view"},
    {GLFW_KEY_L, false, Action::ToggleFlames, "L", "flames on, off"},
    {GLFW_KEY_F, false, Action::HomeCamera, "F", "camera home"},
    {GLFW_KEY_HOME, false, Action::HomeCamera, "Home", "camera home"},
    {GLFW_KEY_F1, false, Action::ToggleHelp, "F1", "this sheet"},
    {GLFW_KEY_B, true, Action::TogglePanel, "Ctrl+B", "panel on, off"},
    {GLFW_KEY_Q, true, Action::Quit, "Ctrl+Q", "quit"},
};

constexpr MouseHint kMouse[] = {
    {"left drag", "orbit"},
    {"middle drag, Shift + left drag", "pan"},
    {"wheel", "zoom"},
    {"Ctrl + click", "put the lighter there"},
    {"Ctrl + click on a slider", "type a value"},
    {"right click on a slider", "reset it"},
};

}  // namespace

std::span<const Binding> bindings() {
    return kBindings;
}

std::optional<Action> action_of(int key, bool control) {
    for (const Binding& binding : kBindings) {
        if (binding.key == key && binding.control == control) return binding.action;
    }
    return std::nullopt;
}

std::span<const MouseHint> mouse_hints() {
    return kMouse;
}

}  // namespace ember
