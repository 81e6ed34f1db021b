#include "ui/param_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/preset_io/parameter_value.h"

namespace ember {
namespace {

constexpr int kCleanDigits = 12;  // of 15 that a double holds for certain
constexpr int kHandDigits = 3;    // that a hand on a logarithmic slider can mean

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from)) {
        text.replace(at, from.size(), to);
    }
    return text;
}

double rounded_to_digits(double value, int digits) {
    if (!std::isfinite(value)) return value;
    char text[40];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    return std::strtod(text, nullptr);
}

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.15g", without_noise(value));
    return text;
}

std::string set_text(const ParamInfo& row, unsigned bits) {
    std::string list;
    for (const std::string_view name : names_in_set(row, bits))
        list += (list.empty() ? "" : ", ") + replaced(std::string(name), "_", " ");
    return list;
}

std::string with_unit(std::string text, const ParamInfo& row) {
    if (!row.unit.name.empty()) text += ' ' + unit_text(row.unit.name);
    return text;
}

}  // namespace

std::string label_text(const ParamInfo& row) {
    const std::string name(row.name());
    return row.symbol == row.name() ? name : replaced(name, "_", " ");
}

std::string symbol_text(const ParamInfo& row) {
    return replaced(replaced(std::string(row.symbol), "rho", "\u03c1"), "nu", "\u03bd");
}

std::string group_text(std::string_view group) {
    std::string text(group);
    if (!text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string unit_text(std::string_view unit) {
    std::string text = replaced(std::string(unit), "^2", "\u00b2");
    text = replaced(text, "^3", "\u00b3");
    text = replaced(text, "degC", "\u00b0C");
    return replaced(text, "deg", "\u00b0");
}

std::string value_format(const ParamInfo& row) {
    const std::string number = row.kind == ParamKind::Integer ? "%lld" : "%.15g";
    std::string unit = unit_text(row.unit.name);
    if (unit == "%") unit = "%%";  // ImGui takes the whole text for a format
    return unit.empty() ? number : number + ' ' + unit;
}

std::string shown_range(const ParamInfo& row, ParamRange range) {
    return with_unit(number(range.min) + " to " + number(range.max), row);
}

std::string shown_value(const ParamInfo& row, const void* object) {
    if (row.kind == ParamKind::Text) return std::get<std::string>(row.value(object));
    if (row.kind == ParamKind::Table) {
        const auto numbers = std::get<std::vector<double>>(row.value(object)).size();
        return std::to_string(numbers / row.columns.size()) + " rows";
    }
    const double value = row.get(object);
    switch (row.kind) {
        case ParamKind::Toggle:
            return value != 0 ? "on" : "off";
        case ParamKind::Choice:
            return replaced(std::string(row.choices[static_cast<std::size_t>(value)]), "_", " ");
        case ParamKind::Set:
            return set_text(row, static_cast<unsigned>(value));
        case ParamKind::Integer:
        case ParamKind::Real:
        case ParamKind::Text:
        case ParamKind::Table:
            break;
    }
    return with_unit(number(row.shown(object)), row);
}

ParamRange slider_range(const ParamInfo& row, double preset) {
    const ParamRange tried = row.tested;
    const bool logarithmic = row.scale == ParamScale::Logarithmic;
    const bool point = !(tried.min < tried.max);
    ParamRange range = tried;
    if (logarithmic) {
        const double beyond = point ? 10.0 : 3.0;
        range = {tried.min / beyond, tried.max * beyond};
    } else {
        const double beyond = point ? std::abs(tried.max) : 0.25 * (tried.max - tried.min);
        range = {tried.min - beyond, tried.max + beyond};
        // what has been tried from 0 on starts there for a reason
        if (tried.min == 0) range.min = 0;
    }
    if (row.kind == ParamKind::Integer) range = {std::floor(range.min), std::ceil(range.max)};
    if (std::isfinite(preset) && (preset > 0 || !logarithmic)) {
        range.min = std::min(range.min, preset);
        range.max = std::max(range.max, preset);
    }
    return {std::max(range.min, row.hard.min), std::min(range.max, row.hard.max)};
}

double tidy(const ParamInfo& row, ParamRange slider, double shown) {
    if (row.scale == ParamScale::Logarithmic) return rounded_to_digits(shown, kHandDigits);
    const double step = std::pow(10.0, std::floor(std::log10((slider.max - slider.min) / 200.0)));
    return without_noise(std::round(shown / step) * step) + 0.0;  // never -0
}

double without_noise(double value) {
    return rounded_to_digits(value, kCleanDigits);
}

}  // namespace ember
