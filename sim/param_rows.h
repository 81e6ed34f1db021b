// How to write a row of the parameter table.
#pragma once

#include "sim/param_info.h"

namespace ember::param_rows {

using enum ParamScale;
using enum ParamApplies;
using detail::Access;

inline constexpr ParamRange kFar = {-10000, 10000};  // [mm] how far anything may be away

struct Text {
    std::string_view help, source;
};

template <auto Group, auto Field>
constexpr ParamInfo real(std::string_view key, std::string_view symbol, Unit unit, ParamRange hard,
                         ParamRange tested, ParamScale scale, ParamApplies applies, Text text) {
    return {key,
            symbol,
            unit,
            ParamKind::Real,
            hard,
            tested,
            scale,
            applies,
            text.help,
            text.source,
            {},
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo integer(std::string_view key, std::string_view symbol, ParamRange hard,
                            ParamRange tested, ParamApplies applies, Text text) {
    return {key,
            symbol,
            unit::one,
            ParamKind::Integer,
            hard,
            tested,
            Linear,
            applies,
            text.help,
            text.source,
            {},
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo toggle(std::string_view key, ParamApplies applies, Text text) {
    return {key,
            "",
            unit::one,
            ParamKind::Toggle,
            {0, 1},
            {0, 1},
            Linear,
            applies,
            text.help,
            text.source,
            {},
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo choice(std::string_view key, std::span<const std::string_view> names,
                           ParamApplies applies, Text text) {
    const ParamRange all{0, static_cast<double>(names.size() - 1)};
    return {key,
            "",
            unit::one,
            ParamKind::Choice,
            all,
            all,
            Linear,
            applies,
            text.help,
            text.source,
            names,
            &Access<Group, Field>::get,
            &Access<Group, Field>::set};
}

// Any of `names` together; `bits` says what each stands for.
template <auto Group, auto Field>
constexpr ParamInfo set_of(std::string_view key, std::span<const std::string_view> names,
                           std::span<const unsigned> bits, ParamApplies applies, Text text) {
    unsigned all = 0;
    for (const unsigned b : bits)
        all |= b;
    ParamInfo row = choice<Group, Field>(key, names, applies, text);
    row.kind = ParamKind::Set;
    row.hard = row.tested = {0, static_cast<double>(all)};
    row.bits = bits;
    return row;
}

template <auto Group, auto Field>
constexpr ParamInfo other(std::string_view key, ParamKind kind, ParamApplies applies, Text text) {
    return {.key = key,
            .symbol = "",
            .unit = unit::one,
            .kind = kind,
            .hard = {},
            .tested = {},
            .scale = Linear,
            .applies = applies,
            .help = text.help,
            .source = text.source,
            .choices = {},
            .get = nullptr,
            .set = nullptr,
            .get_other = &detail::OtherAccess<Group, Field>::get,
            .set_other = &detail::OtherAccess<Group, Field>::set};
}

template <auto Group, auto Field>
constexpr ParamInfo text(std::string_view key, ParamApplies applies, Text text) {
    return other<Group, Field>(key, ParamKind::Text, applies, text);
}

template <auto Group, auto Field>
constexpr ParamInfo table(std::string_view key, std::span<const ParamColumn> columns,
                          ParamApplies applies, Text text) {
    ParamInfo row = other<Group, Field>(key, ParamKind::Table, applies, text);
    row.columns = columns;
    return row;
}

}  // namespace ember::param_rows
