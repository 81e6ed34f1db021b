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
    return {0, "expected " + expected(row) + ", got " + shown_value(value) + more, {}};
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
    const auto* flag = std::get_if<bool>(&value);
    if (row.kind != ParamKind::Toggle && flag != nullptr) return refuse(row, value);
    if (row.kind == ParamKind::Toggle) {
        return flag != nullptr ? ParsedValue{*flag ? 1.0 : 0.0, {}, {}} : refuse(row, value);
    }
    ParsedValue result;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        result.si = row.unit.to_si(static_cast<double>(*whole));
    } else if (const auto* real = std::get_if<double>(&value)) {
        result.si = row.unit.to_si(*real);
    } else {
        const auto* text = std::get_if<std::string>(&value);
        if (text == nullptr) return refuse(row, value);
        result = parse_quantity(row, *text);
        if (!result.error.empty()) return result;
    }
    // 15 digits: the conversion leaves noise in the last ones, which could miss the range's end
    const double shown = rounded(row.unit.from_si(result.si));
    const bool whole = row.kind != ParamKind::Integer || result.si == std::floor(result.si);
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

std::string value_text(const ParamInfo& row, const void* object) {
    const double si = row.get(object);
    switch (row.kind) {
        case ParamKind::Toggle:
            return si != 0 ? "true" : "false";
        case ParamKind::Choice:
            return '"' + std::string(row.choices[static_cast<std::size_t>(si)]) + '"';
        case ParamKind::Set:
            return set_text(names_in_set(row, static_cast<unsigned>(si)));
        case ParamKind::Integer:
            return std::to_string(static_cast<std::int64_t>(si));
        case ParamKind::Real:
            break;
    }
    if (!std::isfinite(si)) return number_text(si);
    const std::string in_shown_unit = exact_quantity(row.unit, si);
    return in_shown_unit.empty() ? si_quantity(row.unit.dimension, si) : in_shown_unit;
}

}  // namespace ember
