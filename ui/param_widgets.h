// From a row of the parameter table to a widget: the only such mapping.
#pragma once

#include <span>
#include <string_view>

#include "sim/param_info.h"

namespace ember {

/// What a widget edits, and what it is compared with and reset to; four objects of one kind.
struct ParamObjects {
    void* edited;        ///< a copy that the caller applies
    const void* preset;  ///< as it is saved
    const void* parent;  ///< what the preset inherits
    const void* defaults;
};

/// Whether the edited copy is to be applied: live rows with every movement of the hand, rows that
/// restart the scene when the hand lets go.
[[nodiscard]] bool param_widget(const ParamInfo& row, const ParamObjects& objects);

/// Widgets of every row of a table but those whose keys are in `elsewhere`, under a collapsing
/// header for each group; groups in `hidden` are left out. With a `filter`, those whose key or
/// help holds it, the rest being out of sight. Returns whether to apply the copy.
[[nodiscard]] bool param_groups(std::span<const ParamInfo> rows, const ParamObjects& objects,
                                std::span<const std::string_view> elsewhere,
                                std::span<const std::string_view> hidden,
                                std::string_view filter = {});

/// Time until a tooltip is due under the resting mouse [s], +inf when none is: a window that sleeps
/// while nothing moves must wake up for it.
[[nodiscard]] double seconds_until_tooltip();

}  // namespace ember
