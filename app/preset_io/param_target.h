// What a key sets: "paper.grammage", or "sheets.2.width" in a list.
#pragma once

#include <span>
#include <string>

#include "sim/param_info.h"

namespace ember {

/// A row of an object, or of one element of a list.
struct Target {
    const ParamInfo* row = nullptr;
    void* object = nullptr;
    ParamOverrides* element = nullptr;

    void assign(const ParamValue& value) const {
        if (element != nullptr) return put_override(*element, *row, value);
        row->assign(object, value);
    }
};

/// The target of `key`; without a row, and `error` says why, when there is none.
[[nodiscard]] Target find_target(const std::string& key, std::span<const ParamBinding> bindings,
                                 std::string& error);

/// The list of that name, or null.
[[nodiscard]] const ParamList* find_list(std::string_view name,
                                         std::span<const ParamBinding> bindings);

/// "unknown key; did you mean ...?"
[[nodiscard]] std::string unknown_key(const std::string& key,
                                      std::span<const ParamBinding> bindings);

}  // namespace ember
