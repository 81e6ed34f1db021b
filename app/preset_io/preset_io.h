// Preset files: TOML to parameters, with every problem reported where it stands.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/preset_io/preset_folders.h"
#include "sim/param_info.h"
#include "sim/scene.h"

namespace ember {

/// One problem of an input, printed as "file:line:column: error: key: message".
struct Diagnostic {
    enum class Severity { Error, Warning } severity = Severity::Error;
    std::string file;          ///< path, or "--set" and the like
    int line = 0, column = 0;  ///< 1-based; 0 when there is none
    std::string key;
    std::string message;  ///< what was expected, what was found, nearest valid key

    [[nodiscard]] std::string text() const;
    /// The line of the file and a caret below the place; empty when there is none.
    [[nodiscard]] std::string excerpt() const;
};

/// Where something was said.
struct PresetPlace {
    std::string file;
    int line = 0, column = 0;
};

/// Edits in mid-burn: [[events]] with `tick = 120` and `set = ["wind.x=2", ...]`, each as after
/// --set. "lighters=2" makes so many of them.
struct PresetEvent {
    std::uint64_t tick = 0;
    std::vector<std::string> set;
    PresetPlace place;
};

struct PresetInfo {
    std::string title, description;
    std::filesystem::path path;
    std::vector<std::filesystem::path> chain;  ///< the file and what it inherits, nearest first
    /// Of the value of every key that was set last: "sheet.rows", "sheets.2.rows", and "sheets.2"
    /// for the element itself.
    std::map<std::string, PresetPlace> places = {};
    std::vector<PresetEvent> events = {};  ///< as written; steering.h makes them a script
};

struct PresetResult {
    PresetInfo info;
    std::vector<Diagnostic> diagnostics;
    [[nodiscard]] bool ok() const;  ///< no errors (warnings do not count)
};

/// Reads `path`, a preset or a picture that carries one, with everything it inherits into the
/// objects of `bindings` (which start out with their defaults). All problems are reported at once;
/// on any error the objects are unspecified.
[[nodiscard]] PresetResult load_preset(const std::filesystem::path& path,
                                       std::span<const ParamBinding> bindings);

/// Applies "key=value" (the value as in a preset; bare words are strings). Problems are said to be
/// in `origin`, the name of the flag that the assignment comes from.
[[nodiscard]] std::vector<Diagnostic> apply_override(const std::string& assignment,
                                                     std::span<const ParamBinding> bindings,
                                                     const std::string& origin = "--set");
/// The same, and says in `info` where the value comes from.
[[nodiscard]] std::vector<Diagnostic> apply_override(const std::string& assignment,
                                                     std::span<const ParamBinding> bindings,
                                                     const std::string& origin, PresetInfo& info);

/// What cannot be built, where the preset says it: at the key, failing that at the group's key or
/// the element.
[[nodiscard]] Diagnostic place_error(const PresetInfo& info, const SceneError& error);

/// A complete preset that holds every value, in shown units: reads back to the same parameters
/// whatever the defaults of a later version are.
[[nodiscard]] std::string preset_text(std::span<const ParamBinding> bindings,
                                      const PresetInfo& info);

/// Events as they stand at the end of a preset.
[[nodiscard]] std::string events_text(std::span<const PresetEvent> events);

/// docs/PARAMETERS.md, generated from the tables; the bound objects must hold the defaults.
[[nodiscard]] std::string parameters_markdown(std::span<const ParamBinding> bindings);

/// The key among `bindings` that is nearest to `key`, or empty when none is near.
[[nodiscard]] std::string nearest_key(std::string_view key, std::span<const ParamBinding> bindings);

}  // namespace ember
