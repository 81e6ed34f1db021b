// Preset files: TOML to parameters, with every problem reported where it stands.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/param_info.h"

namespace ember {

/// One problem of an input, printed as "file:line:column: error: key: message".
struct Diagnostic {
    enum class Severity { Error, Warning } severity = Severity::Error;
    std::string file;      ///< path, or "--set" and the like
    int line = 0, column = 0;  ///< 1-based; 0 when there is none
    std::string key;
    std::string message;   ///< what was expected, what was found, nearest valid key

    [[nodiscard]] std::string text() const;
};

struct PresetInfo {
    std::string title, description;
    std::filesystem::path path;
    std::vector<std::filesystem::path> chain;  ///< the file and what it inherits, nearest first
};

struct PresetResult {
    PresetInfo info;
    std::vector<Diagnostic> diagnostics;
    [[nodiscard]] bool ok() const;             ///< no errors (warnings do not count)
};

/// Reads `path` with everything it inherits into the objects of `bindings` (which start out with
/// their defaults). All problems are reported at once; on any error the objects are unspecified.
[[nodiscard]] PresetResult load_preset(const std::filesystem::path& path,
                                       std::span<const ParamBinding> bindings);

/// Applies "key=value" (the value as in a preset; bare words are strings).
[[nodiscard]] std::vector<Diagnostic> apply_override(const std::string& assignment,
                                                     std::span<const ParamBinding> bindings);

/// A complete preset text that holds every value that differs from its default, in shown units.
[[nodiscard]] std::string preset_text(std::span<const ParamBinding> bindings,
                                      const PresetInfo& info);

/// docs/PARAMETERS.md, generated from the tables.
[[nodiscard]] std::string parameters_markdown(std::span<const ParamBinding> bindings);

/// The key among `bindings` that is nearest to `key`, or empty when none is near.
[[nodiscard]] std::string nearest_key(std::string_view key, std::span<const ParamBinding> bindings);

}  // namespace ember
