// From a row of the parameter table to a widget: the only such mapping.
#pragma once

#include <span>
#include <string_view>

#include "sim/param_info.h"

namespace ember {

/// Draws the widget of `row` on `object` (a copy that the caller applies). `preset` and `defaults`
/// are objects of the same kind to compare with and to reset to. Returns whether it was changed.
bool param_widget(const ParamInfo& row, void* object, const void* preset, const void* defaults);

/// Widgets of every row of a table, a collapsing header for each group.
bool param_groups(const ParamBinding& binding, const void* preset, const void* defaults);

}  // namespace ember
