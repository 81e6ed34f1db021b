// One row per parameter. The row drives preset files, --set, sliders, tooltips, validation and
// docs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/units.h"

namespace ember {

/// A Choice is one of several names, a Set is any number of them. A Text is free, a Table has rows
/// of numbers. All but these two are numbers.
enum class ParamKind { Real, Integer, Toggle, Choice, Set, Text, Table };
enum class ParamScale { Linear, Logarithmic };
enum class ParamApplies { Live, Rebuild };  ///< acts on the next step, or restarts the scene

/// An interval in the row's shown unit; both ends belong to it.
struct ParamRange {
    double min, max;
    [[nodiscard]] constexpr bool contains(double shown) const {
        return shown >= min && shown <= max;
    }
};

/// One column of a Table.
struct ParamColumn {
    std::string_view name;
    Unit unit;
    ParamRange range;        ///< allowed [shown unit]
    bool ascending = false;  ///< every row's number must be above the one before
};

/// A value in SI: a number (toggles, choices and sets too), a text, or the rows of a table one
/// after the other.
using ParamValue = std::variant<double, std::string, std::vector<double>>;

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
    void (*set)(void* object, double si);       ///< both null where the value is no number
    std::span<const unsigned> bits = {};  ///< of a Set: what each name in `choices` stands for
    std::span<const ParamColumn> columns = {};              ///< of a Table
    ParamValue (*get_other)(const void* object) = nullptr;  ///< of a Text or Table
    void (*set_other)(void* object, const ParamValue& value) = nullptr;

    [[nodiscard]] constexpr bool is_number() const { return get != nullptr; }
    [[nodiscard]] ParamValue value(const void* object) const {
        return is_number() ? ParamValue(get(object)) : get_other(object);
    }
    /// `value` must be of the row's type.
    void assign(void* object, const ParamValue& value) const {
        if (is_number()) return set(object, std::get<double>(value));
        set_other(object, value);
    }

    [[nodiscard]] double shown(const void* object) const { return unit.from_si(get(object)); }
    void set_shown(void* object, double value) const { set(object, unit.to_si(value)); }
    [[nodiscard]] constexpr std::string_view group() const { return key.substr(0, key.find('.')); }
    [[nodiscard]] constexpr std::string_view name() const { return key.substr(key.find('.') + 1); }
};

/// What one element of a list says differently from the group that all its elements share.
struct ParamOverride {
    const ParamInfo* row;
    ParamValue value;
    friend bool operator==(const ParamOverride&, const ParamOverride&) = default;
};
/// Of one element, ascending by row, each row at most once.
using ParamOverrides = std::vector<ParamOverride>;

/// Takes `row` = `value` into the overrides of an element.
void put_override(ParamOverrides& overrides, const ParamInfo& row, ParamValue value);

/// A list of overrides and the group whose rows its elements may set.
struct ParamList {
    std::string_view name, group;  ///< "sheets", "sheet"
    std::vector<ParamOverrides>* elements;
};

/// A table of rows together with the object that they read and write.
struct ParamBinding {
    std::span<const ParamInfo> rows;
    void* object;
    std::vector<ParamList> lists = {};
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

/// The same for texts, and for tables of rows of N numbers.
template <auto Group, auto Field>
struct OtherAccess {
    using Root = typename MemberOf<Group>::Owner;
    using Type = typename MemberOf<Field>::Type;
    static const Type& field(const void* object) {
        return (static_cast<const Root*>(object)->*Group).*Field;
    }
    static ParamValue get(const void* object) {
        if constexpr (std::is_same_v<Type, std::string>) {
            return field(object);
        } else {
            std::vector<double> numbers;
            for (const auto& row : field(object))
                numbers.insert(numbers.end(), row.begin(), row.end());
            return numbers;
        }
    }
    static void set(void* object, const ParamValue& value) {
        Type& field = (static_cast<Root*>(object)->*Group).*Field;
        if constexpr (std::is_same_v<Type, std::string>) {
            field = std::get<std::string>(value);
        } else {
            const auto& numbers = std::get<std::vector<double>>(value);
            constexpr std::size_t kColumns = std::tuple_size_v<typename Type::value_type>;
            field.resize(numbers.size() / kColumns);
            for (std::size_t i = 0; i < field.size() * kColumns; ++i)
                field[i / kColumns][i % kColumns] = numbers[i];
        }
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
