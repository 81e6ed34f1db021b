#include "app/preset_io/parameter_value.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include "app/preset_io/nearest_word.h"

namespace ember {
namespace {

std::string shown_value(const PresetValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return '"' + *text + '"';
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (std::holds_alternative<PresetArray>(value)) return "array";
    return number_text(std::get<double>(value));
}

ParsedValue refuse(const ParamInfo& row, const PresetValue& value, const std::string& more = {}) {
    return {0.0, "expected " + expected(row) + ", got " + shown_value(value) + more, {}};
}

double parsed(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::string text_of_15_digits(double value) {
    char text[64];
    const auto end =
        std::to_chars(text, text + sizeof text, value, std::chars_format::general, 15).ptr;
    return {text, end};
}

double rounded(double value) {
    return std::isfinite(value) ? parsed(text_of_15_digits(value)) : value;
}

// Shortest text that reads back to exactly this double.
std::string exact_text(double value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// The text in `unit` that reads back to exactly `si`; empty when no double in that unit does.
std::string exact_quantity(const Unit& unit, double si) {
    double below = unit.from_si(si), above = below;
    if (unit.to_si(rounded(below)) == si) return exact_text(rounded(below));
    for (int i = 0; i < 8; ++i) {
        if (unit.to_si(below) == si) return exact_text(below);
        if (unit.to_si(above) == si) return exact_text(above);
        below = std::nextafter(below, -HUGE_VAL);
        above = std::nextafter(above, HUGE_VAL);
    }
    return {};
}

std::string si_quantity(std::string_view dimension, double si) {
    for (const Unit& unit : kUnits) {
        if (unit.dimension != dimension || unit.scale != 1.0 || unit.offset != 0.0) continue;
        return '"' + exact_text(si) + ' ' + std::string(unit.name) + '"';
    }
    return {};
}

const Unit* find_unit(std::string_view name, std::string_view dimension) {
    for (const Unit& unit : kUnits) {
        if (unit.name == name && unit.dimension == dimension) return &unit;
    }
    return nullptr;
}

std::string units_of(std::string_view dimension) {
    std::string list;
    for (const Unit& unit : kUnits) {
        if (unit.dimension != dimension || unit.name.empty()) continue;
        list += (list.empty() ? "" : ", ") + std::string(unit.name);
    }
    return list.empty() ? "no unit" : list;
}

// The row that one column of a table would be, were it a parameter of its own.
ParamInfo column_row(const ParamInfo& row, const ParamColumn& column) {
    ParamInfo single = row;
    single.kind = ParamKind::Real;
    single.unit = column.unit;
    single.hard = single.tested = column.range;
    return single;
}

std::string columns_text(const ParamInfo& row) {
    std::string names, units;
    for (const ParamColumn& column : row.columns) {
        names += (names.empty() ? "" : ", ") + std::string(column.name);
        units += (units.empty() ? "" : ", ") + std::string(column.unit.name);
    }
    return '[' + names + "] (" + units + ')';
}

// [[0, 1, 2, 3], ...]
ParsedValue parse_table(const ParamInfo& row, const PresetValue& value) {
    const auto* lines = std::get_if<PresetArray>(&value);
    if (lines == nullptr) return refuse(row, value);
    std::vector<double> numbers;
    const std::size_t width = row.columns.size();
    for (const PresetValue& line : lines->items) {
        const auto* cells = std::get_if<PresetArray>(&line);
        if (cells == nullptr || cells->items.size() != width) {
            return refuse(
                row, line,
                cells == nullptr ? "" : " of " + std::to_string(cells->items.size()) + " values");
        }
        for (std::size_t i = 0; i < width; ++i) {
            const ParamColumn& column = row.columns[i];
            const ParsedValue cell = parse_value(column_row(row, column), cells->items[i]);
            if (!cell.error.empty()) return {0.0, std::string(column.name) + ": " + cell.error, {}};
            const double si = std::get<double>(cell.value);
            const bool below = numbers.size() >= width && si <= numbers[numbers.size() - width];
            if (column.ascending && below) {
                return {
                    0.0, "expected each " + std::string(column.name) + " above the one before", {}};
            }
            numbers.push_back(si);
        }
    }
    return {std::move(numbers), {}, {}};
}

std::string table_text(const ParamInfo& row, const std::vector<double>& numbers) {
    std::string text;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::size_t column = i % row.columns.size();
        text += column > 0 ? ", " : i > 0 ? "], [" : "[";
        text += value_text(column_row(row, row.columns[column]), ParamValue(numbers[i]));
    }
    return '[' + text + (numbers.empty() ? "]" : "]]");
}

// "0.08 kg/m^2" into SI.
ParsedValue parse_quantity(const ParamInfo& row, const std::string& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return refuse(row, text);
    std::string_view unit_name(end, static_cast<std::size_t>(text.data() + text.size() - end));
    while (!unit_name.empty() && unit_name.front() == ' ')
        unit_name.remove_prefix(1);
    while (!unit_name.empty() && unit_name.back() == ' ')
        unit_name.remove_suffix(1);
    const Unit* unit = find_unit(unit_name, row.unit.dimension);
    if (unit == nullptr) {
        return refuse(row, text, "; units that fit: " + units_of(row.unit.dimension));
    }
    return {unit->to_si(number), {}, {}};
}

ParsedValue parse_choice(const ParamInfo& row, const PresetValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    for (std::size_t i = 0; text != nullptr && i < row.choices.size(); ++i) {
        if (row.choices[i] == *text) return {static_cast<double>(i), {}, {}};
    }
    return refuse(row, value);
}

// One name of a set or a list of them.
ParsedValue parse_set(const ParamInfo& row, const PresetValue& value) {
    const auto* array = std::get_if<PresetArray>(&value);
    const std::vector<PresetValue> names = array != nullptr ? array->items : std::vector{value};
    unsigned bits = 0;
    for (const PresetValue& name : names) {
        const auto* text = std::get_if<std::string>(&name);
        if (text == nullptr) return refuse(row, name);
        const auto found = std::find(row.choices.begin(), row.choices.end(), *text);
        if (found == row.choices.end()) {
            const std::string near = nearest_word(*text, row.choices);
            return refuse(row, name, near.empty() ? "" : "; did you mean " + near + '?');
        }
        bits |= row.bits[static_cast<std::size_t>(found - row.choices.begin())];
    }
    return {static_cast<double>(bits), {}, {}};
}

std::string set_text(const std::vector<std::string_view>& names) {
    std::string list;
    for (const std::string_view name : names)
        list += (list.empty() ? "\"" : ", \"") + std::string(name) + '"';
    return names.size() == 1 ? list : '[' + list + ']';
}

}  // namespace

ParsedValue parse_value(const ParamInfo& row, const PresetValue& value) {
    if (row.kind == ParamKind::Choice) return parse_choice(row, value);
    if (row.kind == ParamKind::Set) return parse_set(row, value);
    if (row.kind == ParamKind::Table) return parse_table(row, value);
    if (row.kind == ParamKind::Text) {
        const auto* words = std::get_if<std::string>(&value);
        return words != nullptr ? ParsedValue{*words, {}, {}} : refuse(row, value);
    }
    const auto* flag = std::get_if<bool>(&value);
    if (row.kind != ParamKind::Toggle && flag != nullptr) return refuse(row, value);
    if (row.kind == ParamKind::Toggle) {
        return flag != nullptr ? ParsedValue{*flag ? 1.0 : 0.0, {}, {}} : refuse(row, value);
    }
    ParsedValue result;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) {
        result.value = row.unit.to_si(static_cast<double>(*integer));
    } else if (const auto* real = std::get_if<double>(&value)) {
        result.value = row.unit.to_si(*real);
    } else {
        const auto* text = std::get_if<std::string>(&value);
        if (text == nullptr) return refuse(row, value);
        result = parse_quantity(row, *text);
        if (!result.error.empty()) return result;
    }
    // 15 digits: the conversion leaves noise in the last ones, which could miss the range's end
    const double si = std::get<double>(result.value);
    const double shown = rounded(row.unit.from_si(si));
    const bool whole = row.kind != ParamKind::Integer || si == std::floor(si);
    if (!whole || !row.hard.contains(shown)) return refuse(row, value);
    if (!row.tested.contains(shown)) {
        result.warning = "outside what has been tried: " + range_text(row, row.tested);
    }
    return result;
}

std::string expected(const ParamInfo& row) {
    if (row.kind == ParamKind::Toggle) return "true or false";
    if (row.kind == ParamKind::Choice) return "one of " + names_text(row);
    if (row.kind == ParamKind::Set) return "one or a list of " + names_text(row);
    if (row.kind == ParamKind::Text) return "a text";
    if (row.kind == ParamKind::Table) return "a list of " + columns_text(row);
    return (row.kind == ParamKind::Integer ? "a whole number from " : "a number from ") +
           range_text(row, row.hard);
}

std::string names_text(const ParamInfo& row) {
    std::string list;
    for (const std::string_view name : row.choices)
        list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
}

std::vector<std::string_view> names_in_set(const ParamInfo& row, unsigned bits) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < row.choices.size(); ++i) {
        if (row.bits[i] == bits) return {row.choices[i]};
        const bool part = std::has_single_bit(row.bits[i]) && (row.bits[i] & bits) != 0;
        if (part) names.push_back(row.choices[i]);
    }
    return names;
}

std::string range_text(const ParamInfo& row, ParamRange range) {
    std::string text = number_text(range.min) + " to " + number_text(range.max);
    return row.unit.name.empty() ? text : text + ' ' + std::string(row.unit.name);
}

std::string number_text(double value) {
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (std::isnan(value)) return "nan";
    if (value == std::floor(value) && std::abs(value) < 1e16) return exact_text(value);
    return exact_text(rounded(value));
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + '"';
}

std::string value_text(const ParamInfo& row, const ParamValue& value) {
    if (row.kind == ParamKind::Text) return quoted(std::get<std::string>(value));
    if (row.kind == ParamKind::Table) {
        return table_text(row, std::get<std::vector<double>>(value));
    }
    const double si = std::get<double>(value);
    if (row.kind == ParamKind::Toggle) return si != 0 ? "true" : "false";
    if (row.kind == ParamKind::Choice)
        return quoted(std::string(row.choices[static_cast<std::size_t>(si)]));
    if (row.kind == ParamKind::Set) return set_text(names_in_set(row, static_cast<unsigned>(si)));
    if (row.kind == ParamKind::Integer) return std::to_string(static_cast<std::int64_t>(si));
    if (!std::isfinite(si)) return number_text(si);
    const std::string in_shown_unit = exact_quantity(row.unit, si);
    return in_shown_unit.empty() ? si_quantity(row.unit.dimension, si) : in_shown_unit;
}

std::string value_text(const ParamInfo& row, const void* object) {
    return value_text(row, row.value(object));
}

}  // namespace ember
