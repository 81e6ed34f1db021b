#include "app/preset_io/preset_io.h"

// toml++ 3.3 asserts that a table's name begins well, and reports it otherwise a line later: a bad
// preset must be an error in debug builds too
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <tuple>

#include "app/preset_io/parameter_value.h"

namespace ember {
namespace {

constexpr std::int64_t kSchema = 1;
constexpr std::uintmax_t kLargestFile = 1 << 20;  // [bytes]
constexpr std::size_t kDeepestChain = 32;

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

std::string unknown_key(const std::string& key, std::span<const ParamBinding> bindings) {
    const std::string near = nearest_key(key, bindings);
    return "unknown key" + (near.empty() ? "" : "; did you mean " + near + "?");
}

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
        if (size > kLargestFile) {
            report({}, "", "larger than 1 MiB, which no preset is");
            return std::nullopt;
        }
        std::ifstream in(path, std::ios::binary);
        std::ostringstream text;
        text << in.rdbuf();
        try {
            return toml::parse(text.str(), path.string());
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
        const toml::table* group = node.as_table();
        if (group == nullptr) {
            unknown(key.source(), name);
            return;
        }
        if (group->empty() && !is_group(name)) unknown(key.source(), name);
        for (const auto& [inner, value] : *group) {
            apply(name + '.' + std::string(inner.str()), inner.source(), value);
        }
    }

    void unknown(const toml::source_region& at, const std::string& key) {
        report(at, key, unknown_key(key, bindings_));
    }

    void apply(const std::string& key, const toml::source_region& at, const toml::node& node) {
        const ParamInfo* row = nullptr;
        void* object = nullptr;
        for (const ParamBinding& binding : bindings_) {
            if ((row = find_param(binding.rows, key)) != nullptr) {
                object = binding.object;
                break;
            }
        }
        if (row == nullptr) {
            unknown(at, key);
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
        row->set(object, parsed.si);
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

// Text as TOML would read it; what is no TOML value is a string that lacks its quotes.
PresetValue override_value(const std::string& text) {
    try {
        const toml::table table = toml::parse("v = " + text);
        if (table.size() == 1) return value_of(*table.get("v")).value_or(text);
    } catch (const toml::parse_error&) {
        // falls through to the bare string
    }
    return text;
}

}  // namespace

std::filesystem::path find_preset(const std::string& name, const std::filesystem::path& beside) {
    std::vector<std::filesystem::path> places{beside};
    const std::vector<std::filesystem::path> built_in = preset_folders();
    places.insert(places.end(), built_in.begin(), built_in.end());
    for (const std::filesystem::path& place : places) {
        for (const std::string& file : {name, name + ".toml"}) {
            const std::filesystem::path path = place / file;
            if (std::filesystem::is_regular_file(path)) return path;
        }
    }
    return {};
}

std::vector<std::filesystem::path> preset_folders() {
    std::vector<std::filesystem::path> folders{EMBERLEAF_PRESET_FOLDER};
    std::error_code error;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
    if (!error) folders.push_back(program.parent_path() / "../share/emberleaf/presets");
    return folders;
}

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

std::vector<Diagnostic> apply_override(const std::string& assignment,
                                       std::span<const ParamBinding> bindings,
                                       const std::string& origin) {
    using Severity = Diagnostic::Severity;
    const auto diagnostic = [&](Severity severity, const std::string& key,
                                const std::string& message) {
        return std::vector<Diagnostic>{{severity, origin, 0, 0, key, message}};
    };
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
        return diagnostic(Severity::Error, assignment, "expected key=value");
    }
    const std::string key = assignment.substr(0, equals), text = assignment.substr(equals + 1);
    for (const ParamBinding& binding : bindings) {
        const ParamInfo* row = find_param(binding.rows, key);
        if (row == nullptr) continue;
        const ParsedValue parsed = parse_value(*row, override_value(text));
        if (!parsed.error.empty()) return diagnostic(Severity::Error, key, parsed.error);
        row->set(binding.object, parsed.si);
        if (parsed.warning.empty()) return {};
        return diagnostic(Severity::Warning, key, parsed.warning);
    }
    return diagnostic(Severity::Error, key, unknown_key(key, bindings));
}

}  // namespace ember
