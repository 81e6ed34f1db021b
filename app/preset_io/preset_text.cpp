#include <sstream>

#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_io.h"

namespace ember {
namespace {

// A cell of a table: '|' would end it.
std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') out += '\\';
        out += c;
    }
    return out;
}

std::string range_cell(const ParamInfo& row, ParamRange range) {
    if (row.kind == ParamKind::Toggle) return "";
    if (!row.choices.empty()) return names_text(row);
    if (row.kind == ParamKind::Text || row.kind == ParamKind::Table) return expected(row);
    return number_text(range.min) + " to " + number_text(range.max);
}

std::string row_of(const ParamInfo& row, const void* object) {
    std::ostringstream out;
    out << "| `" << row.key << "` | " << cell(row.symbol) << " | " << value_text(row, object)
        << " | " << cell(row.unit.name) << " | " << range_cell(row, row.hard) << " | "
        << (row.choices.empty() && row.is_number() ? range_cell(row, row.tested) : "") << " | "
        << (row.applies == ParamApplies::Live ? "live" : "rebuild") << " | " << cell(row.help)
        << " | " << cell(row.source) << " |\n";
    return out.str();
}

}  // namespace

std::string preset_text(std::span<const ParamBinding> bindings, const PresetInfo& info) {
    std::ostringstream out;
    out << "schema = 1\n";
    if (!info.title.empty()) out << "title = " << quoted(info.title) << '\n';
    if (!info.description.empty()) out << "description = " << quoted(info.description) << '\n';
    std::string_view group;
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            if (row.group() != group) {
                group = row.group();
                out << "\n[" << group << "]\n";
            }
            out << row.name() << " = " << value_text(row, binding.object) << '\n';
        }
    }
    for (const ParamBinding& binding : bindings) {
        for (const ParamList& list : binding.lists) {
            for (const ParamOverrides& element : *list.elements) {
                out << "\n[[" << list.name << "]]\n";
                for (const ParamOverride& o : element)
                    out << o.row->name() << " = " << value_text(*o.row, o.value) << '\n';
            }
        }
    }
    out << events_text(info.events);
    return out.str();
}

std::string events_text(std::span<const PresetEvent> events) {
    std::ostringstream out;
    for (const PresetEvent& event : events) {
        out << "\n[[events]]\ntick = " << event.tick << "\nset = [";
        for (std::size_t i = 0; i < event.set.size(); ++i)
            out << (i > 0 ? ", " : "") << quoted(event.set[i]);
        out << "]\n";
    }
    return out.str();
}

std::string parameters_markdown(std::span<const ParamBinding> bindings) {
    std::ostringstream out;
    out << "# Parameters\n\n"
           "Generated from the parameter tables by `emberleaf params --markdown`; a test keeps it "
           "fresh.\n\nA bare number in a preset is in the unit shown; a string may carry another "
           "unit of the same kind, such as `\"0.08 kg/m^2\"`. *Live* parameters act at once, "
           "*rebuild* ones restart the scene.\n\nA scene of several sheets has one table "
           "`[[sheets]]` "
           "for each, and of several lighters `[[lighters]]`: each may set any key of `sheet` or "
           "`lighter` for itself, and has the others from `[sheet]` or `[lighter]`. `--set` counts "
           "them from 1, as in `sheets.2.width`.\n";
    std::string_view group;
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            if (row.group() != group) {
                group = row.group();
                out << "\n## " << group
                    << "\n\n| key | in the paper | default | unit | allowed | tried | acts | "
                       "meaning "
                       "| source |\n|---|---|---|---|---|---|---|---|---|\n";
            }
            out << row_of(row, binding.object);
        }
    }
    return out.str();
}

}  // namespace ember
