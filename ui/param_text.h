// What a row of the parameter table looks like on a panel: names, units, numbers, ranges. No ImGui.
#pragma once

#include <string>
#include <string_view>

#include "sim/param_info.h"

namespace ember {

/// "held gravity"; the paper's own symbol is left as it is written.
[[nodiscard]] std::string label_text(const ParamInfo& row);

/// The paper's symbol as it prints it: "\u03c1" for "rho".
[[nodiscard]] std::string symbol_text(const ParamInfo& row);

/// "Paper" for the group "paper".
[[nodiscard]] std::string group_text(std::string_view group);

/// "g/m²" for "g/m^2", "°C" for "degC".
[[nodiscard]] std::string unit_text(std::string_view unit);

/// printf format of a shown value with its unit, e.g. "%.15g g/m²".
[[nodiscard]] std::string value_format(const ParamInfo& row);

/// "25 to 400 g/m²".
[[nodiscard]] std::string shown_range(const ParamInfo& row, ParamRange range);

/// The value of `row` in `object` with its unit, or the name of the choice.
[[nodiscard]] std::string shown_value(const ParamInfo& row, const void* object);

/// What a slider covers [shown unit]: a little more than has been tried, within what is allowed,
/// and the preset's value; above 0 where the scale is logarithmic. Typing may leave it.
[[nodiscard]] ParamRange slider_range(const ParamInfo& row, double preset);

/// A dragged value, rounded to what a hand can mean on that range.
[[nodiscard]] double tidy(const ParamInfo& row, ParamRange slider, double shown);

/// `value` without the noise that unit conversion leaves in its last digits.
[[nodiscard]] double without_noise(double value);

}  // namespace ember
