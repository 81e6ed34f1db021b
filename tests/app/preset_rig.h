// What tests of presets share.
#pragma once

#include <gtest/gtest.h>

#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/param_table.h"
#include "temporary_folder.h"

namespace ember {

/// Both tables with the objects that they write.
struct Everything {
    Params params;
    RenderParams render;
    [[nodiscard]] std::vector<ParamBinding> bindings() { return {bind(params), bind(render)}; }
};

struct Loaded {
    Everything values;
    PresetResult result;
};

inline Loaded load(const std::filesystem::path& path) {
    Loaded loaded;
    loaded.result = load_preset(path, loaded.values.bindings());
    return loaded;
}

/// The diagnostics of a preset, one per line, without the folder in front of the file's name.
inline std::string problems(const TemporaryFolder& folder, const std::string& file) {
    std::string text;
    for (Diagnostic d : load(folder / file).result.diagnostics) {
        d.file = std::filesystem::path(d.file).lexically_relative(folder.path()).generic_string();
        text += d.text() + '\n';
    }
    return text;
}

inline std::string problems(const std::string& preset) {
    const TemporaryFolder folder;
    folder.write("p.toml", preset);
    return problems(folder, "p.toml");
}

}  // namespace ember
