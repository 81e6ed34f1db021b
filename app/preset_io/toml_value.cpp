#include "app/preset_io/toml_value.h"

#include "app/preset_io/toml_letters.h"

namespace ember {

std::optional<PresetValue> value_of(const toml::node& node) {
    if (const auto* array = node.as_array()) {
        PresetArray list;
        for (const toml::node& item : *array) {
            const std::optional<PresetValue> value = value_of(item);
            if (!value) return std::nullopt;
            list.items.push_back(*value);
        }
        return PresetValue(std::move(list));
    }
    if (const auto* v = node.as_boolean()) return PresetValue(v->get());
    if (const auto* v = node.as_integer()) return PresetValue(v->get());
    if (const auto* v = node.as_floating_point()) return PresetValue(v->get());
    if (const auto* v = node.as_string()) return PresetValue(v->get());
    return std::nullopt;
}

PresetValue value_of(const std::string& text) {
    if (foreign_letter(text)) return text;
    try {
        const toml::table table = toml::parse("v = " + text);
        if (table.size() == 1) return value_of(*table.get("v")).value_or(text);
    } catch (const toml::parse_error&) {
        // falls through to the bare string
    }
    return text;
}

}  // namespace ember
