// Changes a preset where it stands: comments, order and spacing of everything else survive.
#pragma once

#include <string>
#include <vector>

#include "app/preset_io/preset_io.h"

namespace ember {

/// One value to write: "paper.grammage" or "lighters.2.x", and the value as TOML.
struct PresetChange {
    std::string key, value;
};

/// `text`, a preset without syntax errors, with these values. A key that it has keeps its place
/// and only the bytes of its value change; others are added at the end of their table, tables at
/// the end of the text. An element of a list must exist, or be the next one.
/// Throws std::runtime_error when the text cannot be read.
[[nodiscard]] std::string edited_preset(std::string text, const std::vector<PresetChange>& changes);

/// What leads from `saved` to `now`; both bound alike. An element that a list no longer has, or has
/// no longer a value of its own for, cannot be said as a change: then `complete` becomes false.
[[nodiscard]] std::vector<PresetChange> changes_between(std::span<const ParamBinding> saved,
                                                        std::span<const ParamBinding> now,
                                                        bool& complete);

}  // namespace ember
