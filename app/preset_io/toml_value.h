// Values as TOML has them.
#pragma once

// toml++ 3.3 asserts that a table's name begins well, and reports it otherwise a line later: a bad
// preset must be an error in debug builds too
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <optional>

#include "app/preset_io/parameter_value.h"

namespace ember {

/// What a node holds; empty for what no parameter can be set to.
[[nodiscard]] std::optional<PresetValue> value_of(const toml::node& node);

/// Text as TOML would read it; what is no TOML value is a string that lacks its quotes.
[[nodiscard]] PresetValue value_of(const std::string& text);

}  // namespace ember
