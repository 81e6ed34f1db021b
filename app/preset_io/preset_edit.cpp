#include "app/preset_io/preset_edit.h"

#include <algorithm>
#include <stdexcept>

#include "app/preset_io/parameter_value.h"
#include "app/preset_io/toml_letters.h"
#include "app/preset_io/toml_value.h"

namespace ember {
namespace {

// Byte of a place; columns count characters, of which UTF-8 writes some as several bytes.
std::size_t byte_of(const std::string& text, const toml::source_position& place) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < place.line; ++line)
        at = text.find('\n', at) + 1;
    for (toml::source_index column = 1; column < place.column; ++column) {
        ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xc0u) == 0x80u)
            ++at;
    }
    return std::min(at, text.size());
}

bool is_blank(const std::string& line) {
    return line.find_first_not_of(" \t\r") == std::string::npos;
}

// Whether a line is the header of a table, "[paper]" or "[[lighters]]".
bool is_header(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t");
    return first != std::string::npos && line[first] == '[';
}

// End of what belongs to the table whose header starts at `begin`: behind its last line that is
// neither blank nor a comment.
std::size_t end_of_table(const std::string& text, std::size_t begin) {
    std::size_t at = text.find('\n', begin), end = std::string::npos;
    if (at == std::string::npos) return text.size();
    end = ++at;
    int depth = 0;  // of a value over several lines
    while (at < text.size()) {
        std::size_t next = text.find('\n', at);
        next = next == std::string::npos ? text.size() : next + 1;
        const std::string line = text.substr(at, next - at);
        if (depth == 0 && is_header(line)) break;
        const std::size_t first = line.find_first_not_of(" \t\r\n");
        if (first != std::string::npos && line[first] != '#') {
            const std::string code = line.substr(0, line.find('#'));
            depth +=
                static_cast<int>(std::ranges::count(code, '[') - std::ranges::count(code, ']'));
            end = next;
        }
        at = next;
    }
    return end;
}

void insert_line(std::string& text, std::size_t at, const std::string& line) {
    const bool fresh = at == 0 || text[at - 1] == '\n';
    text.insert(at, (fresh ? "" : "\n") + line + '\n');
}

void append_table(std::string& text, const std::string& header, const std::string& line) {
    if (!text.empty() && text.back() != '\n') text += '\n';
    const std::size_t last = text.rfind('\n', text.size() < 2 ? 0 : text.size() - 2);
    const bool gap =
        text.empty() || is_blank(text.substr(last == std::string::npos ? 0 : last + 1));
    text += (gap ? "" : "\n") + header + '\n' + line + '\n';
}

void write_in(std::string& text, const toml::table* table, const std::string& header,
              const std::string& name, const std::string& value) {
    const std::string line = name + " = " + value;
    if (table == nullptr) return append_table(text, header, line);
    if (const toml::node* node = table->get(name)) {
        const std::size_t begin = byte_of(text, node->source().begin);
        const std::size_t end = byte_of(text, node->source().end);
        text.replace(begin, end - begin, value);
        return;
    }
    const std::size_t begin = byte_of(text, table->source().begin);
    if (text[begin] != '[' || table->is_inline())
        throw std::runtime_error(header + " is not written as a table of its own");
    insert_line(text, end_of_table(text, begin), line);
}

void change(std::string& text, const PresetChange& wanted) {
    if (const auto foreign = foreign_letter(text))
        throw std::runtime_error(foreign_letter_text(*foreign));
    toml::table all;
    try {
        all = toml::parse(text);
    } catch (const toml::parse_error& e) {
        throw std::runtime_error(std::string(e.description()));
    }
    const std::size_t dot = wanted.key.find('.'), second = wanted.key.find('.', dot + 1);
    const std::string group = wanted.key.substr(0, dot);
    if (second == std::string::npos) {
        return write_in(text, all[group].as_table(), '[' + group + ']', wanted.key.substr(dot + 1),
                        wanted.value);
    }
    const std::size_t number = std::stoul(wanted.key.substr(dot + 1, second - dot - 1));
    const toml::array* list = all[group].as_array();
    const std::size_t size = list == nullptr ? 0 : list->size();
    if (number > size + 1) throw std::runtime_error(wanted.key + ": there is no such element");
    write_in(text, number <= size ? list->get(number - 1)->as_table() : nullptr,
             "[[" + group + "]]", wanted.key.substr(second + 1), wanted.value);
}

void list_changes(const ParamList& saved, const ParamList& now, std::vector<PresetChange>& changes,
                  bool& complete) {
    const auto &before = *saved.elements, &after = *now.elements;
    if (after.size() < before.size()) complete = false;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const ParamOverrides old = i < before.size() ? before[i] : ParamOverrides{};
        const std::string element = std::string(now.name) + '.' + std::to_string(i + 1) + '.';
        for (const ParamOverride& o : after[i]) {
            if (std::ranges::count(old, o) == 0)
                changes.push_back(
                    {element + std::string(o.row->name()), value_text(*o.row, o.value)});
        }
        for (const ParamOverride& o : old)
            complete &= std::ranges::count(after[i], o.row, &ParamOverride::row) != 0;
        if (i >= before.size() && after[i].empty()) complete = false;  // a table without a value
    }
}

}  // namespace

std::string edited_preset(std::string text, const std::vector<PresetChange>& changes) {
    for (const PresetChange& wanted : changes)
        change(text, wanted);
    return text;
}

std::vector<PresetChange> changes_between(std::span<const ParamBinding> saved,
                                          std::span<const ParamBinding> now, bool& complete) {
    std::vector<PresetChange> changes;
    complete = true;
    for (std::size_t b = 0; b < now.size(); ++b) {
        for (const ParamInfo& row : now[b].rows) {
            if (row.value(saved[b].object) == row.value(now[b].object)) continue;
            changes.push_back({std::string(row.key), value_text(row, now[b].object)});
        }
        for (std::size_t l = 0; l < now[b].lists.size(); ++l)
            list_changes(saved[b].lists[l], now[b].lists[l], changes, complete);
    }
    return changes;
}

}  // namespace ember
