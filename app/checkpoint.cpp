#include "app/checkpoint.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "app/exit_code.h"
#include "app/preset_io/atomic_file.h"
#include "app/shot_record.h"
#include "app/value_bytes.h"
#include "app/version.h"
#include "sim/param_table.h"

namespace ember {
namespace {

constexpr std::string_view kMagic("emberleaf state 1\n");

struct FieldWriter {
    std::string& bytes;

    template <class T>
    void operator()(const char*, const T& value) {
        put(bytes, value);
    }
    template <class T>
    void operator()(const char*, const std::vector<T>& array) {
        put(bytes, static_cast<std::uint64_t>(array.size()));
        bytes.append(reinterpret_cast<const char*>(array.data()), array.size() * sizeof(T));
    }
};

// Reads from `at` on; what is beyond the end is an error.
struct FieldReader {
    const std::string& bytes;
    std::size_t at;

    void take(void* to, std::uint64_t count) {
        if (count > bytes.size() - at) throw std::runtime_error("the file is not whole");
        if (count > 0) std::memcpy(to, bytes.data() + at, count);
        at += count;
    }
    template <class T>
    void operator()(const char*, T& value) {
        take(&value, sizeof value);
    }
    template <class T>
    void operator()(const char*, std::vector<T>& array) {
        std::uint64_t count = 0;
        take(&count, sizeof count);
        if (count > bytes.size() / sizeof(T)) throw std::runtime_error("the file is not whole");
        array.resize(count);
        take(array.data(), count * sizeof(T));
    }
};

// What for_each_field() leaves out where it is not needed.
struct Presence {
    std::uint8_t cracks, curvature;
};

std::uint64_t parameters_hash(const LoadedPreset& preset) {
    Params params = preset.params;
    const ParamBinding bindings[] = {bind(params)};
    PresetInfo info = preset.info;
    info.title.clear(), info.description.clear();  // which change nothing
    return text_hash(std::string(kVersion) + preset_text(bindings, info));
}

WorldState read_state(const std::string& bytes, std::uint64_t parameters) {
    if (!bytes.starts_with(kMagic)) throw std::runtime_error("not a saved simulation");
    FieldReader in{bytes, kMagic.size()};
    WorldState state;
    std::uint64_t made_with = 0, hash = 0, sheets = 0;
    std::uint8_t wind = 0;
    in("", made_with), in("", hash), in("", wind), in("", sheets);
    if (made_with != parameters)
        throw std::runtime_error("saved with other parameters or by another version");
    for (std::uint64_t s = 0; s < sheets; ++s) {
        Presence has{};
        in("", has);
        SheetState& sheet = state.sheets.emplace_back();
        if (has.cracks != 0) sheet.cracks.due.resize(1);
        if (has.curvature != 0) sheet.rest_curvature.main.resize(1);
    }
    state.energy.work_wind = wind;
    for_each_field(state, in);
    if (hash_of(state) != hash) throw std::runtime_error("damaged");
    return state;
}

}  // namespace

void save_checkpoint(const std::filesystem::path& path, const World& world,
                     const LoadedPreset& preset) {
    const WorldState& state = world.state();
    std::string bytes(kMagic);
    put(bytes, parameters_hash(preset));
    put(bytes, hash_of(state));
    put(bytes, static_cast<std::uint8_t>(state.energy.work_wind != 0));
    put(bytes, static_cast<std::uint64_t>(state.sheets.size()));
    for (const SheetState& sheet : state.sheets) {
        put(bytes, Presence{static_cast<std::uint8_t>(!sheet.cracks.due.empty()),
                            static_cast<std::uint8_t>(!sheet.rest_curvature.main.empty())});
    }
    FieldWriter out{bytes};
    for_each_field(state, out);
    write_file(path, bytes);
}

void load_checkpoint(const std::filesystem::path& path, World& world, const LoadedPreset& preset) {
    std::ifstream in(path, std::ios::binary);
    const auto fail = [&path](const std::string& reason) {
        throw InputError("--resume: error: " + path.string() + ": " + reason);
    };
    if (!in) fail(std::strerror(errno));
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    try {
        world.restore(read_state(bytes, parameters_hash(preset)));
    } catch (const std::runtime_error& e) {
        fail(e.what());
    }
}

}  // namespace ember
