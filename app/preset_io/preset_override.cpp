// Values from the command line, and where a value came from.
#include "app/preset_io/param_target.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_io.h"
#include "app/preset_io/toml_value.h"

namespace ember {

std::vector<Diagnostic> apply_override(const std::string& assignment,
                                       std::span<const ParamBinding> bindings,
                                       const std::string& origin, PresetInfo& info) {
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
    std::string error;
    const Target target = find_target(key, bindings, error);
    if (target.row == nullptr) return diagnostic(Severity::Error, key, error);
    const ParsedValue parsed = parse_value(*target.row, value_of(text));
    if (!parsed.error.empty()) return diagnostic(Severity::Error, key, parsed.error);
    target.assign(parsed.value);
    info.places[key] = {origin, 0, 0};
    if (parsed.warning.empty()) return {};
    return diagnostic(Severity::Warning, key, parsed.warning);
}

std::vector<Diagnostic> apply_override(const std::string& assignment,
                                       std::span<const ParamBinding> bindings,
                                       const std::string& origin) {
    PresetInfo unused;
    return apply_override(assignment, bindings, origin, unused);
}

Diagnostic place_error(const PresetInfo& info, const SceneError& error) {
    const std::string& key = error.key();
    // "sheets.2.rows" may stand in [sheet], and something else is said of the element as a whole
    const std::string element = key.substr(0, key.rfind('.'));
    std::vector<std::string> candidates{key};
    if (key.starts_with("sheets."))
        candidates.push_back(std::string("sheet").append(key, key.rfind('.')));
    candidates.push_back(element);
    PresetPlace place{info.path.string(), 0, 0};
    for (const std::string& candidate : candidates) {
        const auto found = info.places.find(candidate);
        if (found == info.places.end()) continue;
        place = found->second;
        break;
    }
    if (place.line == 0 && place.file == info.path.string()) {
        // nothing that was said is to blame: the group as a whole, where it begins
        const auto first = info.places.lower_bound("sheet.");
        if (first != info.places.end() && first->first.starts_with("sheet")) place = first->second;
    }
    return {
        Diagnostic::Severity::Error, place.file, place.line, place.column, key, error.message()};
}

}  // namespace ember
