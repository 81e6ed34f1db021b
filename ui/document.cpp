#include "ui/document.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "app/preset_io/atomic_file.h"
#include "app/preset_io/mask_file.h"
#include "app/preset_io/memory_limit.h"
#include "app/preset_io/parameter_value.h"
#include "app/preset_io/preset_edit.h"
#include "app/preset_io/steering.h"
#include "sim/lighter.h"
#include "sim/param_table.h"
#include "sim/scene_check.h"
#include "ui/param_text.h"

namespace ember {
namespace {

std::string read_file(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) throw std::runtime_error(path.string() + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string text_of(const std::vector<Diagnostic>& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics) {
        if (d.severity == Diagnostic::Severity::Error)
            text += (text.empty() ? "" : "\n") + d.text();
    }
    return text;
}

bool built_in(const std::filesystem::path& path) {
    std::error_code ignored;
    const auto real = std::filesystem::weakly_canonical(path, ignored);
    return std::ranges::any_of(preset_folders(), [&](const std::filesystem::path& folder) {
        const auto inside = real.lexically_relative(std::filesystem::weakly_canonical(folder));
        return !inside.empty() && *inside.begin() != "..";
    });
}

void append_changes(std::span<const ParamInfo> rows, const void* before, const void* now,
                    bool with_camera, std::vector<ShownChange>& changes) {
    for (const ParamInfo& row : rows) {
        const std::string_view group = row.group();
        const bool looking = group == "camera" || group == "shot" || group == "view";
        if (looking && !with_camera) continue;
        if (row.value(before) == row.value(now)) continue;
        changes.push_back({std::string(row.key), shown_value(row, before), shown_value(row, now)});
    }
}

// A name by which a preset can be inherited from a file anywhere.
std::string name_of(const std::filesystem::path& path) {
    for (const std::filesystem::path& folder : preset_folders()) {
        std::filesystem::path inside = std::filesystem::weakly_canonical(path).lexically_relative(
            std::filesystem::weakly_canonical(folder));
        if (!inside.empty() && *inside.begin() != "..")
            return inside.replace_extension().generic_string();
    }
    return std::filesystem::absolute(path).string();
}

std::string child_text(const Document& document, const PresetValues& values,
                       const std::filesystem::path& path) {
    const auto& chain = document.info.chain;
    const bool from_parent = !document.read_only && chain.size() > 1;
    PresetValues base = from_parent ? document.parent : document.saved, now = values;
    const auto ancestor = from_parent ? chain[1] : document.info.path;
    bool complete = false;
    const auto changes = changes_between(base.bindings(), now.bindings(), complete);
    const std::string start = "schema = 1\ntitle = " + quoted(path.stem().string()) +
                              "\ninherits = " + quoted(name_of(ancestor)) + '\n';
    return edited_preset(start, changes);
}

bool reads_back(const Document& document, const PresetValues& values) {
    PresetValues saved = document.saved, wanted = values;
    bool complete = false;
    return changes_between(saved.bindings(), wanted.bindings(), complete).empty() && complete;
}

}  // namespace

std::vector<ShownChange> shown_changes(const PresetValues& before, const PresetValues& now,
                                       bool with_camera) {
    std::vector<ShownChange> changes;
    append_changes(sim_param_rows(), &before.params, &now.params, with_camera, changes);
    append_changes(render_param_rows(), &before.render, &now.render, with_camera, changes);
    const auto old = lighters_of(before.params), fresh = lighters_of(now.params);
    if (old.size() != fresh.size())
        changes.push_back({"lighters", std::to_string(old.size()), std::to_string(fresh.size())});
    for (std::size_t i = 0; i < std::min(old.size(), fresh.size()); ++i) {
        if (now.params.lighters.empty() && before.params.lighters.empty()) break;
        Params a, b;
        a.lighter = old[i], b.lighter = fresh[i];
        for (const std::string& text : assignments_between(a, b)) {
            const std::string key = "lighters." + std::to_string(i + 1) + text.substr(7);
            changes.push_back({key.substr(0, key.find('=')), "", key.substr(key.find('=') + 1)});
        }
    }
    return changes;
}

std::string Document::title() const {
    return info.title.empty() ? info.path.stem().string() : info.title;
}

bool Document::changed_on_disk() const {
    return std::ranges::any_of(times, [](const auto& entry) {
        std::error_code gone;
        const auto now = std::filesystem::last_write_time(entry.first, gone);
        return !gone && now != entry.second;
    });
}

Document open_document(const std::filesystem::path& path) {
    Document document;
    const std::vector<ParamBinding> bindings = document.saved.bindings();
    PresetResult result = load_preset(path, bindings);
    std::vector<Diagnostic>& problems = result.diagnostics;
    if (result.ok()) {
        for (Diagnostic& d : read_masks(document.saved.params, result.info))
            problems.push_back(std::move(d));
        for (Diagnostic& d : read_prints(document.saved.render, result.info))
            problems.push_back(std::move(d));
    }
    if (result.ok()) {
        try {
            check_memory(document.saved.params);
            validate(make_scene(document.saved.params), caliper(document.saved.params.paper));
        } catch (const SceneError& e) {
            problems.push_back(place_error(result.info, e));
        }
        document.script = script_of(document.saved.params, result.info, problems);
    }
    if (!result.ok()) throw std::runtime_error(text_of(problems));
    document.info = result.info;
    document.parent = document.saved;
    const auto& chain = document.info.chain;
    if (chain.size() > 1) {
        PresetValues parent;
        if (load_preset(chain[1], parent.bindings()).ok()) document.parent = parent;
    }
    document.read_only = path.extension() != ".toml" || built_in(path);
    for (const std::filesystem::path& file : chain) {
        std::error_code gone;
        document.times[file] = std::filesystem::last_write_time(file, gone);
    }
    return document;
}

Document save_document(const Document& document, const PresetValues& values,
                       const std::filesystem::path& path) {
    std::error_code none;
    const bool own =
        !document.read_only && std::filesystem::equivalent(path, document.info.path, none);
    const auto attempt = [&](const std::string& text) {
        write_file(path, text);
        return open_document(path);
    };
    PresetValues saved = document.saved, now = values;
    try {
        bool complete = false;
        const auto changes = changes_between(saved.bindings(), now.bindings(), complete);
        const Document written = attempt(own ? edited_preset(read_file(path), changes)
                                             : child_text(document, values, path));
        if (reads_back(written, values)) return written;
    } catch (const std::runtime_error&) {  // then all of it is written
    }
    PresetInfo info = document.info;
    info.events.clear();
    if (!own) info.title = path.stem().string();
    return attempt(preset_text(now.bindings(), info));
}

std::string take_text(const Document& document, const PresetValues& base,
                      const std::vector<TimedParams>& script) {
    const std::vector<PresetEvent> events = events_of(base.params, script);
    PresetValues saved = document.saved, values = base;
    const PrintParams& print = base.render.print;
    // pictures are named from where the preset is: it must go on being the one that names them
    const bool pictures = !base.params.masks.empty() || !print.front.empty() || !print.back.empty();
    bool complete = false;
    const auto changes = changes_between(saved.bindings(), values.bindings(), complete);
    if (pictures && complete) {
        const std::string start = "schema = 1\ntitle = " + quoted(document.title()) +
                                  "\ninherits = " + quoted(name_of(document.info.path)) + '\n';
        return edited_preset(start, changes) + events_text(events);
    }
    PresetInfo info = document.info;
    info.events = events;
    return preset_text(values.bindings(), info);
}

}  // namespace ember
