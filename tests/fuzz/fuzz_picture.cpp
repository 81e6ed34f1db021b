// A picture: its texts, and a sheet's outline from it.
#include "../app/temporary_folder.h"
#include "app/preset_io/mask_file.h"
#include "app/preset_io/png_text.h"
#include "promise.h"
#include "sim/param_table.h"

namespace ember {
namespace {

// Larger ones are read as well as smaller ones, but not as often.
bool is_small(const std::uint8_t* data, std::size_t size) {
    if (size < 24) return true;
    const auto side = [&](std::size_t at) {
        return data[at] << 24 | data[at + 1] << 16 | data[at + 2] << 8 | data[at + 3];
    };
    return side(16) >= 0 && side(16) <= 512 && side(20) >= 0 && side(20) <= 512;
}

void read(const std::uint8_t* data, std::size_t size) {
    static const TemporaryFolder folder;
    const auto path =
        folder.write("m.png", std::string_view(reinterpret_cast<const char*>(data), size));
    try {
        for (const auto& [key, text] : read_png_text(path))
            promise(key.size() + text.size() <= size);
    } catch (const std::runtime_error& e) {
        promise(std::string(e.what()).starts_with(path.string()));
    }
    if (!is_small(data, size)) return;
    Params params;
    params.sheet.mask = "m.png";
    PresetInfo info;
    info.path = path.parent_path() / "p.toml";
    const auto problems = read_masks(params, info);
    promise(problems.empty() == !params.masks.empty());
}

}  // namespace
}  // namespace ember

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ember::read(data, size);
    return 0;
}
