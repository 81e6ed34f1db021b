// The keyboard: one table for the program, the help sheet and the tests.
#pragma once

#include <optional>
#include <span>

namespace ember {

enum class Action {
    TogglePlay,
    Step,
    Restart,
    NextView,
    ToggleFlames,
    HomeCamera,
    ToggleHelp,
    TogglePanel,
    Quit
};

struct Binding {
    int key;  ///< GLFW_KEY_*
    bool control;
    Action action;
    const char* keys;  ///< as people read it
    const char* text;
};

[[nodiscard]] std::span<const Binding> bindings();

/// The action of a key, if it has one.
[[nodiscard]] std::optional<Action> action_of(int key, bool control);

/// What the mouse does, for the help sheet.
struct MouseHint {
    const char* gesture;
    const char* text;
};
[[nodiscard]] std::span<const MouseHint> mouse_hints();

}  // namespace ember
