// Keys, menus and mouse: one table for the program, its help sheet, its manual and the tests.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "ui/settings.h"

namespace ember {

/// What a key, a menu entry, or the button that stands for it, does.
enum class Action {
    OpenBrowser,
    OpenPath,
    Save,
    SaveAs,
    Reload,
    SaveTake,
    Screenshot,
    ScreenshotClear,
    Record,
    CopyCommand,
    Quit,
    Undo,
    Redo,
    CopyCamera,
    PasteCamera,
    SwapSlots,
    StoreSlot,
    TogglePlay,
    Step,
    StepBack,
    StepTen,
    StepBackTen,
    ToStart,
    ToEnd,
    Restart,
    Slower,
    Faster,
    ToggleLoop,
    Retry,
    NextView,
    ToggleLegend,
    ToggleFlames,
    HomeCamera,
    CameraFront,
    CameraSide,
    CameraTop,
    CameraThreeQuarter,
    CameraFlat,
    PreviousCamera,
    NextCamera,
    SideBySide,
    Compare,
    FullScreen,
    PlaceLighter,
    LightNow,
    RecordPath,
    AddLighter,
    RemoveLighter,
    ToggleHelp,
    ToggleInfo,
    ToggleProfiler,
    TogglePlots,
    ToggleLog,
    TogglePanel,
    Cancel
};

struct KeyBinding {
    int key;              ///< GLFW_KEY_*; 0: in the menu only
    bool control, shift;  ///< together with these
    bool repeats;         ///< acts again and again while the key is held down
    Action action;
    const char* menu;  ///< it is in; empty: in none
    const char* name;  ///< the key as people call it
    const char* text;  ///< what it does
};

[[nodiscard]] std::span<const KeyBinding> key_bindings();

/// The binding of a key, or null. A key that is held down repeats only where the table says so.
[[nodiscard]] const KeyBinding* find_binding(int key, bool control, bool shift,
                                             bool repeated = false);

/// The first row of an action, for buttons and menus.
[[nodiscard]] const KeyBinding& binding_of(Action action);

/// What dragging the mouse over the picture does.
enum class Drag { Orbit, Pan, Zoom, PlaceLighter, Ignite, Touch, Blow, TurnLight };

struct DragBinding {
    unsigned schemes;  ///< bit per CameraScheme
    int button;        ///< GLFW_MOUSE_BUTTON_*
    bool shift, control, alt;
    Drag drag;
    const char* name;
    const char* text;
};

[[nodiscard]] std::span<const DragBinding> drag_bindings();
[[nodiscard]] std::optional<Drag> find_drag(CameraScheme scheme, int button, bool shift,
                                            bool control, bool alt);
/// Whether the drag is one of that scheme.
[[nodiscard]] bool in_scheme(const DragBinding& drag, CameraScheme scheme);

/// What else the mouse does.
struct MouseHint {
    const char* name;
    const char* text;
};
[[nodiscard]] std::span<const MouseHint> mouse_hints();

/// docs/WINDOW.md, generated from the tables.
[[nodiscard]] std::string bindings_markdown();

}  // namespace ember
