// What stands around a parameter's widget: its name with marks, tooltip, menu, reset.
#pragma once

#include "ui/param_widgets.h"

namespace ember {

/// The name. A dot: not saved; a ring: not as in what the preset inherits; an R: a change restarts
/// the scene. A double click resets; returns whether it did.
[[nodiscard]] bool param_label(const ParamInfo& row, const ParamObjects& objects);

/// Meaning, ranges, source, of the last item, once the mouse rests on it.
void param_tooltip(const ParamInfo& row, const ParamObjects& objects);

/// The menu of a right click: reset, copy, paste; returns whether the value has changed.
[[nodiscard]] bool param_menu(const ParamInfo& row, const ParamObjects& objects);

/// A button where there is something to reset; returns whether it was pressed.
[[nodiscard]] bool param_reset(const ParamInfo& row, const ParamObjects& objects);

}  // namespace ember
