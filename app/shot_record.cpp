#include "app/shot_record.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/stats_json.h"
#include "app/version.h"
#include "sim/param_table.h"

namespace ember {
namespace {

// Names and contents of all files of a folder.
std::string folder_hash(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    std::ostringstream all;
    for (const auto& file : files)
        all << file.lexically_relative(folder) << '\n'
            << std::ifstream(file, std::ios::binary).rdbuf();
    return hash_text(text_hash(all.str()));
}

// The shot's length says only how many pictures there are, unless the camera turns by it.
std::string hashed_preset(const RenderJob& job, bool turns) {
    LoadedPreset preset = job.preset;
    if (!turns) preset.render.shot.duration = ShotParams{}.duration;
    const ParamBinding bindings[] = {bind(preset.params), bind(preset.render)};
    PresetInfo info = preset.info;
    info.title.clear(), info.description.clear();  // which change no picture
    return preset_text(bindings, info);
}

// Where the preset is: built-in ones by name, wherever the program has been installed.
std::string source_of(const std::filesystem::path& preset) {
    std::error_code ignored;
    const std::filesystem::path file = std::filesystem::weakly_canonical(preset, ignored);
    for (const std::filesystem::path& folder : preset_folders()) {
        const std::filesystem::path name =
            file.lexically_relative(std::filesystem::weakly_canonical(folder, ignored));
        if (!name.empty() && *name.begin() != "..") return name.string();
    }
    return file.string();
}

}  // namespace

std::uint64_t text_hash(std::string_view text) {
    std::uint64_t hash = 0xCBF29CE484222325u;
    for (const char c : text)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3u;
    return hash;
}

ImageText shot_text(const RenderOptions& options, const RenderJob& job,
                    const std::string& renderer) {
    LoadedPreset preset = job.preset;
    const ParamBinding bindings[] = {bind(preset.params), bind(preset.render)};
    std::string settings = settings_text(options, job);
    if (!options.shaders.empty()) settings += ", shaders " + folder_hash(options.shaders);
    std::string pictures;  // that the preset names
    for (const auto& mask : preset.params.masks)
        pictures.append(mask->paper.begin(), mask->paper.end());
    for (const auto& face : {preset.render.printed.front, preset.render.printed.back}) {
        if (face) pictures.append(face->rgba.begin(), face->rgba.end());
    }
    const std::string hashed = std::string(kVersion) + '\n' + renderer + '\n' + settings + '\n' +
                               pictures + hashed_preset(job, options.turntable != 0);
    return {{"Software", "emberleaf"},
            {"Version", kVersion},
            {"Source", source_of(preset.info.path)},
            {"Settings", settings},
            {"Seed", std::to_string(preset.params.numerics.seed)},
            {"Renderer", renderer},
            {"Hash", hash_text(text_hash(hashed))},
            {"Preset", preset_text(bindings, preset.info)}};
}

}  // namespace ember
