// The preset that is open: what its file says, what it inherits, how an edit of it is saved.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember {

/// Everything that a preset sets.
struct PresetValues {
    Params params;
    RenderParams render;
    /// Both tables, for preset_io.
    [[nodiscard]] std::vector<ParamBinding> bindings() { return {bind(params), bind(render)}; }
};

/// One value that differs, as people read it.
struct ShownChange {
    std::string key, from, to;
};

/// In what `now` differs from `before`; how it is looked at (camera, view,
/// shot) only `with_camera`.
[[nodiscard]] std::vector<ShownChange> shown_changes(const PresetValues& before,
                                                     const PresetValues& now, bool with_camera);

/// A preset file as it was last read or written.
struct Document {
    PresetInfo info;
    PresetValues saved;      ///< what the file says
    PresetValues parent;     ///< what it inherits; the same as `saved` where it inherits nothing
    bool read_only = false;  ///< comes with the program, or is a picture
    std::vector<TimedParams> script;                                         ///< its [[events]]
    std::map<std::filesystem::path, std::filesystem::file_time_type> times;  ///< when it was read

    [[nodiscard]] std::string title() const;
    /// Whether a file that it was read from has changed since.
    [[nodiscard]] bool changed_on_disk() const;
};

/// Reads a preset, or a picture that carries one. Throws std::runtime_error with all problems, one
/// a line.
[[nodiscard]] Document open_document(const std::filesystem::path& path);

/// Writes `values` to `path`. Into a preset's own file they are edited in place; elsewhere goes a
/// preset that inherits what the document does, or the document itself where it is read only, and
/// says only what differs. Where that would not read back to the same values, a complete preset is
/// written. Returns the document that the file now is. Throws std::runtime_error.
[[nodiscard]] Document save_document(const Document& document, const PresetValues& values,
                                     const std::filesystem::path& path);

/// A complete preset with what a person did in mid-burn: a take. Where pictures belong to it, one
/// that inherits the document instead, beside which they are.
[[nodiscard]] std::string take_text(const Document& document, const PresetValues& base,
                                    const std::vector<TimedParams>& script);

}  // namespace ember
