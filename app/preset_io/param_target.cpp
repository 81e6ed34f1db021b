#include "app/preset_io/param_target.h"

#include <charconv>

#include "app/preset_io/preset_io.h"

namespace ember {
namespace {

Target find_row(const std::string& key, std::span<const ParamBinding> bindings) {
    for (const ParamBinding& binding : bindings) {
        if (const ParamInfo* row = find_param(binding.rows, key)) return {row, binding.object};
    }
    return {};
}

// "2" of "sheets.2.width"; 0 where there is no number.
std::size_t element_number(std::string_view text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

// `rest` is "2.width".
Target find_in_list(const ParamList& list, const std::string& rest,
                    std::span<const ParamBinding> bindings, std::string& error) {
    const std::string start(list.name);
    const std::size_t dot = rest.find('.');
    const std::size_t number = element_number(std::string_view(rest).substr(0, dot));
    if (dot == std::string::npos || number == 0) {
        error = "expected " + start + ".NUMBER.KEY, such as " + start + ".1.x";
        return {};
    }
    if (number > list.elements->size()) {
        error = "there are " + std::to_string(list.elements->size()) + " tables [[" + start + "]]";
        return {};
    }
    const std::string key = std::string(list.group) + rest.substr(dot);
    Target target = find_row(key, bindings);
    if (target.row == nullptr) {
        error = unknown_key(key, bindings);
    } else {
        target.element = &(*list.elements)[number - 1];
    }
    return target;
}

}  // namespace

Target find_target(const std::string& key, std::span<const ParamBinding> bindings,
                   std::string& error) {
    const std::size_t dot = key.find('.');
    if (const ParamList* list = find_list(std::string_view(key).substr(0, dot), bindings)) {
        const std::string rest = dot == std::string::npos ? "" : key.substr(dot + 1);
        return find_in_list(*list, rest, bindings, error);
    }
    const Target target = find_row(key, bindings);
    if (target.row == nullptr) error = unknown_key(key, bindings);
    return target;
}

const ParamList* find_list(std::string_view name, std::span<const ParamBinding> bindings) {
    for (const ParamBinding& binding : bindings) {
        for (const ParamList& list : binding.lists) {
            if (list.name == name) return &list;
        }
    }
    return nullptr;
}

std::string unknown_key(const std::string& key, std::span<const ParamBinding> bindings) {
    const std::string near = nearest_key(key, bindings);
    return "unknown key" + (near.empty() ? "" : "; did you mean " + near + "?");
}

}  // namespace ember
