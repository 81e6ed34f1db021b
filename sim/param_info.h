// One row per parameter. The row drives preset files, --set, sliders, tooltips, validation and
// docs.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "sim/units.h"

namespace ember {

/// A Choice is one of several names, a Set is any number of them.
enum class ParamKind { Real, Integer, Toggle, Choice, Set };
enum class ParamScale { Linear, Logarithmic };
enum class ParamApplies { Live, Rebuild };  ///< acts on the next step, or restarts the scene

/// An interval in the row's shown unit; both ends belong to it.
struct ParamRange {
    double min, max;
    [[nodiscard]] constexpr bool contains(double shown) const {
        return shown >= min && shown <= max;
    }
};

/// Everything that is known about one parameter except its default, which is the member
/// initialiser of the field and is read from a default-constructed object.
struct ParamInfo {
    std::string_view key;     ///< "group.name", as in a preset
    std::string_view symbol;  ///< as the paper writes it, or empty
    Unit unit;                ///< shown unit; the field itself is SI
    ParamKind kind;
    ParamRange hard;    ///< outside: an error [shown unit]
    ParamRange tested;  ///< the range that the paper or our calibration covers [shown unit]
    ParamScale scale;
    ParamApplies applies;
    std::string_view help;                      ///< what it means and which way it acts
    std::string_view source;                    ///< paper section, or "our choice"
    std::span<const std::string_view> choices;  ///< names of a Choice, in the order of its enum
    double (*get)(const void* object);          ///< value in SI (integers, toggles, choices as is)
    void (*set)(void* object, double si);
    std::span<const unsigned> bits = {};  ///< of a Set: what each name in `choices` stands for

    [[nodiscard]] double shown(const void* object) const { return unit.from_si(get(object)); }
    void set_shown(void* object, double value) const { set(object, unit.to_si(value)); }
    [[nodiscard]] constexpr std::string_view group() const { return key.substr(0, key.find('.')); }
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

/// A table of rows together with the object that they read and write.
struct ParamBinding {
    std::span<const ParamInfo> rows;
    void* object;
};

namespace detail {

template <auto Member>
struct MemberOf;
template <class Class, class Field, Field Class::*Member>
struct MemberOf<Member> {
    using Owner = Class;
    using Type = Field;
};

/// Getter and setter of Root::group.field for the type-erased row.
template <auto Group, auto Field>
struct Access {
    using Root = typename MemberOf<Group>::Owner;
    using Type = typename MemberOf<Field>::Type;
    static double get(const void* object) {
        return static_cast<double>((static_cast<const Root*>(object)->*Group).*Field);
    }
    static void set(void* object, double value) {
        (static_cast<Root*>(object)->*Group).*Field = static_cast<Type>(value);
    }
};

struct AnyField {
    template <class T>
    constexpr operator T() const;
};
template <class T, class... Fields>
consteval std::size_t count_fields() {
    if constexpr (requires { T{Fields{}..., AnyField{}}; }) {
        return count_fields<T, Fields..., AnyField>();
    } else {
        return sizeof...(Fields);
    }
}

}  // namespace detail

/// Number of members of a plain parameter group; a static_assert compares it with the rows.
template <class Group>
inline constexpr std::size_t field_count = detail::count_fields<Group>();

/// Number of rows whose key starts with "group.".
consteval std::size_t row_count(std::span<const ParamInfo> rows, std::string_view group) {
    std::size_t count = 0;
    for (const ParamInfo& row : rows)
        count += row.group() == group ? 1u : 0u;
    return count;
}

/// The row of `key`, or null.
constexpr const ParamInfo* find_param(std::span<const ParamInfo> rows, std::string_view key) {
    for (const ParamInfo& row : rows) {
        if (row.key == key) return &row;
    }
    return nullptr;
}

}  // namespace ember
