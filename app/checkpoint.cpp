#include "app/checkpoint.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "app/checkpoint_format.h"
#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/shot_record.h"
#include "app/version.h"
#include "sim/param_table.h"

namespace ember {
namespace {

std::uint64_t parameters_hash(const LoadedPreset& preset) {
    Params params = preset.params;
    const ParamBinding bindings[] = {bind(params)};
    PresetInfo info = preset.info;
    info.title.clear(), info.description.clear();  // which change nothing
    return text_hash(preset_text(bindings, info));
}

}  // namespace

std::string checkpoint_bytes(const World& world, const LoadedPreset& preset) {
    return saved_bytes(kVersion, parameters_hash(preset), world.state());
}

void resume_from(std::string_view bytes, World& world, const LoadedPreset& preset) {
    SavedState saved = read_saved_bytes(bytes);
    if (saved.program != kVersion) {
        throw std::runtime_error("saved by emberleaf " + saved.program + "; this is " + kVersion +
                                 ", whose bits may be others");
    }
    if (saved.parameters != parameters_hash(preset))
        throw std::runtime_error("saved with other parameters");
    const std::string reason = misfit(saved.state, world.state());
    if (!reason.empty()) throw std::runtime_error("saved from another scene: " + reason);
    world.restore(std::move(saved.state));
}

void save_checkpoint(const std::filesystem::path& path, const World& world,
                     const LoadedPreset& preset) {
    write_file(path, checkpoint_bytes(world, preset));
}

void load_checkpoint(const std::filesystem::path& path, World& world, const LoadedPreset& preset) {
    std::ifstream in(path, std::ios::binary);
    const auto fail = [&path](const std::string& reason) {
        throw InputError("--resume: error: " + path.string() + ": " + reason);
    };
    if (!in) fail(std::strerror(errno));
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    try {
        resume_from(bytes, world, preset);
    } catch (const std::runtime_error& e) {
        fail(e.what());
    }
}

}  // namespace ember
