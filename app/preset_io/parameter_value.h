// One value from outside (a preset or the command line) into one parameter.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/param_info.h"

namespace ember {

/// What TOML can hold that a parameter may be set to.
struct PresetArray;
using PresetValue = std::variant<bool, std::int64_t, double, std::string, PresetArray>;
struct PresetArray {
    std::vector<PresetValue> items;
};

/// The value in SI, or why it is refused ("expected ..., got ...").
struct ParsedValue {
    ParamValue value;
    std::string error;    ///< empty: accepted
    std::string warning;  ///< accepted, but outside the range that has been tried
};
[[nodiscard]] ParsedValue parse_value(const ParamInfo& row, const PresetValue& value);

/// "a number from 5 to 5000 g/m^2", "true or false", "one of flat, cylinder".
[[nodiscard]] std::string expected(const ParamInfo& row);

/// The names of a Choice or Set: "flat, cylinder".
[[nodiscard]] std::string names_text(const ParamInfo& row);

/// The fewest names of a Set that make up `bits`: the one that stands for all, or each part's.
[[nodiscard]] std::vector<std::string_view> names_in_set(const ParamInfo& row, unsigned bits);

/// "5 to 5000 g/m^2".
[[nodiscard]] std::string range_text(const ParamInfo& row, ParamRange range);

/// A value of `row` as it would stand in a preset: the shortest text that reads back to the same
/// bits, in the shown unit, or in SI with its unit where no number in the shown unit does.
[[nodiscard]] std::string value_text(const ParamInfo& row, const ParamValue& value);
/// The present value in `object`.
[[nodiscard]] std::string value_text(const ParamInfo& row, const void* object);

/// A text as TOML writes it.
[[nodiscard]] std::string quoted(const std::string& text);

/// Shortest decimal text of a number that reads back to the same double, up to 15 digits.
[[nodiscard]] std::string number_text(double value);

}  // namespace ember
