// Keys and mouse: one table for the program, the help sheet and the tests.
#pragma once

#include <optional>
#include <span>

namespace ember {

/// What a key, or the button that stands for it, does.
enum class Action {
    TogglePlay,
    Step,
    Restart,
    NextView,
    ToggleFlames,
    PlaceLighter,
    HomeCamera,
    ToggleStatistics,
    ToggleHelp,
    TogglePanel,
    Cancel,
    Quit
};

struct KeyBinding {
    int key;       ///< GLFW_KEY_*
    bool control;  ///< together with Ctrl
    bool repeats;  ///< acts again and again while the key is held down
    Action action;
    const char* name;  ///< the key as people call it
    const char* text;  ///< what it does
};

[[nodiscard]] std::span<const KeyBinding> key_bindings();

/// The binding of a key, or null. A key that is held down repeats only where the table says so.
[[nodiscard]] const KeyBinding* find_binding(int key, bool control, bool repeated = false);

/// What dragging the mouse over the picture does.
enum class Drag { Orbit, Pan, PlaceLighter };

struct DragBinding {
    int button;  ///< GLFW_MOUSE_BUTTON_*
    bool shift, control;
    Drag drag;
    const char* name;
    const char* text;
};

[[nodiscard]] std::span<const DragBinding> drag_bindings();
[[nodiscard]] std::optional<Drag> find_drag(int button, bool shift, bool control);

/// What else the mouse does; for the help sheet.
struct MouseHint {
    const char* name;
    const char* text;
};
[[nodiscard]] std::span<const MouseHint> mouse_hints();

}  // namespace ember
