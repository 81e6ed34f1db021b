#include "app/preset_io/preset_io.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <tuple>

#include "app/preset_io/own_folder.h"
#include "app/preset_io/param_target.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/png_text.h"
#include "app/preset_io/toml_letters.h"
#include "app/preset_io/toml_value.h"

namespace ember {
namespace {

constexpr std::int64_t kSchema = 1;
constexpr std::uintmax_t kLargestFile = 1 << 20;  // [bytes]
constexpr std::size_t kDeepestChain = 32;

// Reads one preset and what it inherits, collecting every problem.
class Reader {
  public:
    Reader(std::span<const ParamBinding> bindings, PresetResult& result)
        : bindings_(bindings), result_(result) {}

    void read(const std::filesystem::path& path) {
        file_ = path.string();
        const std::optional<toml::table> table = parse(path);
        if (!table) return;
        result_.info.chain.push_back(path);
        check_schema(*table);
        inherit(*table, path);
        file_ = path.string();  // inherited files have come first
        for (const auto& [key, node] : *table)
            apply_top(key, node);
    }

  private:
    using Severity = Diagnostic::Severity;

    void report(const toml::source_region& at, std::string key, std::string message,
                Severity severity = Severity::Error) {
        result_.diagnostics.push_back({severity, file_, static_cast<int>(at.begin.line),
                                       static_cast<int>(at.begin.column), std::move(key),
                                       std::move(message)});
    }

    std::optional<toml::table> parse(const std::filesystem::path& path) {
        std::error_code error;
        const auto size = std::filesystem::file_size(path, error);
        if (error || !std::filesystem::is_regular_file(path)) {
            report({}, "", error ? error.message() : "not a file");
            return std::nullopt;
        }
        if (is_png(path)) return parse_picture(path);
        if (size > kLargestFile) {
            report({}, "", "larger than 1 MiB, which no preset is");
            return std::nullopt;
        }
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        return parse(text.str(), path);
    }

    // The preset that a picture of ours was made from stands in it.
    std::optional<toml::table> parse_picture(const std::filesystem::path& path) {
        try {
            const ImageText text = read_png_text(path);
            if (const std::string* preset = find_text(text, "Preset")) return parse(*preset, path);
            report({}, "", "no preset in this picture; those that emberleaf draws have one");
        } catch (const std::runtime_error& e) {
            report({}, "", std::string(e.what()).substr(path.string().size() + 2));
        }
        return std::nullopt;
    }

    std::optional<toml::table> parse(const std::string& text, const std::filesystem::path& path) {
        if (const auto foreign = foreign_letter(text)) {
            result_.diagnostics.push_back({Severity::Error, file_, foreign->line, foreign->column,
                                           "", foreign_letter_text(*foreign)});
            return std::nullopt;
        }
        try {
            return toml::parse(text, path.string());
        } catch (const toml::parse_error& e) {
            report(e.source(), "", std::string(e.description()));
            return std::nullopt;
        }
    }

    void check_schema(const toml::table& table) {
        const toml::node* node = table.get("schema");
        if (node == nullptr) {
            toml::source_region top;
            top.begin = {1, 1};
            report(top, "schema", "missing; write 'schema = 1' at the top");
        } else if (const auto version = node->value<std::int64_t>(); version != kSchema) {
            report(node->source(), "schema",
                   version && *version > kSchema
                       ? "this preset is newer than this program, which reads schema 1"
                       : "expected 1");
        }
    }

    void inherit(const toml::table& table, const std::filesystem::path& path) {
        const toml::node* node = table.get("inherits");
        if (node == nullptr) return;
        const auto name = node->value<std::string>();
        if (!name) {
            report(node->source(), "inherits", "expected the name of a preset as a string");
            return;
        }
        const std::filesystem::path parent = find_preset(*name, path.parent_path());
        const auto& chain = result_.info.chain;
        const auto same = [&](const std::filesystem::path& p) {
            std::error_code ignored;
            return std::filesystem::equivalent(p, parent, ignored);
        };
        if (parent.empty()) {
            report(node->source(), "inherits", "no preset \"" + *name + "\"");
        } else if ((leads_out(*name) || linked_out(parent, path)) &&
                   parent.extension() != ".toml") {
            // nothing but presets is read from elsewhere, and no line of it shown in a message
            report(node->source(), "inherits",
                   "outside of the preset's own folder only a .toml file can be inherited, got \"" +
                       *name + '"');
        } else if (chain.size() >= kDeepestChain || std::any_of(chain.begin(), chain.end(), same)) {
            report(node->source(), "inherits", "\"" + *name + "\" leads back to itself");
        } else {
            read(parent);
        }
    }

    void apply_top(const toml::key& key, const toml::node& node) {
        const std::string name(key.str());
        if (name == "schema" || name == "inherits") return;
        if (name == "title" || name == "description") {
            const auto text = node.value<std::string>();
            if (!text) {
                report(node.source(), name, "expected a string");
                return;
            }
            (name == "title" ? result_.info.title : result_.info.description) = *text;
            return;
        }
        if (name == "events") return read_events(node);
        if (const ParamList* list = find_list(name, bindings_)) {
            read_list(*list, node);
            return;
        }
        const toml::table* group = node.as_table();
        if (group == nullptr) {
            unknown(key.source(), name);
            return;
        }
        if (group->empty() && !is_group(name)) unknown(key.source(), name);
        for (const auto& [inner, value] : *group)
            apply(name + '.' + std::string(inner.str()), inner.source(), value);
    }

    // [[sheets]] and the like replace the whole list of what is inherited.
    void read_list(const ParamList& list, const toml::node& node) {
        const std::string name(list.name);
        const toml::array* array = node.as_array();
        if (array == nullptr || !(array->empty() || array->is_array_of_tables())) {
            report(node.source(), name, "expected tables [[" + name + "]], one for each");
            return;
        }
        list.elements->assign(array->size(), {});
        std::erase_if(result_.info.places,
                      [&](const auto& place) { return place.first.starts_with(name + '.'); });
        for (std::size_t i = 0; i < array->size(); ++i) {
            const std::string element = name + '.' + std::to_string(i + 1);
            const toml::table& table = *array->get(i)->as_table();
            remember(element, table.source());
            for (const auto& [inner, value] : table) {
                apply(element + '.' + std::string(inner.str()), inner.source(), value);
            }
        }
    }

    // [[events]] replace those of what is inherited.
    void read_events(const toml::node& node) {
        result_.info.events.clear();
        const toml::array* array = node.as_array();
        if (array == nullptr || !array->is_array_of_tables())
            return report(node.source(), "events", "expected tables [[events]], one for each");
        for (const toml::node& element : *array) {
            const toml::table& table = *element.as_table();
            const auto tick = table["tick"].value<std::int64_t>();
            const toml::array* set = table["set"].as_array();
            const bool texts = set != nullptr && set->is_homogeneous(toml::node_type::string);
            if (!tick || *tick < 0 || !texts || table.size() != 2) {
                report(table.source(), "events",
                       "expected tick = 120 and set = [\"wind.x=2\", ...], and nothing else");
                continue;
            }
            const toml::source_position at = table.source().begin;
            PresetEvent event{static_cast<std::uint64_t>(*tick), {}, {file_}};
            event.place.line = static_cast<int>(at.line);
            event.place.column = static_cast<int>(at.column);
            for (const toml::node& text : *set)
                event.set.push_back(*text.value<std::string>());
            result_.info.events.push_back(std::move(event));
        }
    }

    void remember(const std::string& key, const toml::source_region& at) {
        result_.info.places[key] = {file_, static_cast<int>(at.begin.line),
                                    static_cast<int>(at.begin.column)};
    }

    void unknown(const toml::source_region& at, const std::string& key) {
        report(at, key, unknown_key(key, bindings_));
    }

    void apply(const std::string& key, const toml::source_region& at, const toml::node& node) {
        std::string error;
        const Target target = find_target(key, bindings_, error);
        const ParamInfo* row = target.row;
        if (row == nullptr) {
            report(at, key, error);
            return;
        }
        const std::optional<PresetValue> value = value_of(node);
        if (!value) {
            std::ostringstream type;
            type << node.type();
            report(node.source(), key, "expected " + expected(*row) + ", got " + type.str());
            return;
        }
        const ParsedValue parsed = parse_value(*row, *value);
        if (!parsed.error.empty()) {
            report(node.source(), key, parsed.error);
            return;
        }
        target.assign(parsed.value);
        remember(key, node.source());
        if (!parsed.warning.empty()) {
            report(node.source(), key, parsed.warning, Severity::Warning);
        }
    }

    bool is_group(std::string_view name) const {
        for (const ParamBinding& binding : bindings_) {
            for (const ParamInfo& row : binding.rows) {
                if (row.group() == name) return true;
            }
        }
        return false;
    }

    std::span<const ParamBinding> bindings_;
    PresetResult& result_;
    std::string file_;
};

}  // namespace

PresetResult load_preset(const std::filesystem::path& path,
                         std::span<const ParamBinding> bindings) {
    PresetResult result;
    result.info.path = path;
    Reader(bindings, result).read(path);
    // TOML hands out keys by the alphabet; people read from top to bottom
    std::stable_sort(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                         return std::tie(a.file, a.line, a.column) <
                                std::tie(b.file, b.line, b.column);
                     });
    return result;
}

}  // namespace ember
