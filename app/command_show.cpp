// emberleaf show: what stands in a picture about how it was made.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/preset_io/png_text.h"
#include "render/exr_file.h"

namespace ember {
namespace {

ImageText text_in(const std::string& file) {
    try {
        return is_png(file) || !file.ends_with(".exr") ? read_png_text(file) : read_exr_text(file);
    } catch (const std::runtime_error& e) {
        throw InputError(e.what());
    }
}

int show(const std::string& file, bool preset_only) {
    const ImageText text = text_in(file);
    const std::string* preset = find_text(text, "Preset");
    if (preset == nullptr) throw InputError(file + ": error: not a picture of emberleaf");
    if (!preset_only) {
        for (const auto& [keyword, value] : text) {
            if (keyword != "Preset") std::printf("%-10s %s\n", keyword.c_str(), value.c_str());
        }
        std::printf("\n");
    }
    std::fputs(preset->c_str(), stdout);
    return kOk;
}

}  // namespace

void add_show_command(CLI::App& command, Task& task) {
    const auto file = std::make_shared<std::string>();
    const auto preset_only = std::make_shared<bool>(false);
    command.add_option("FILE", *file, "a PNG or EXR picture that emberleaf has drawn")->required();
    command.add_flag("--preset", *preset_only, "only the preset, as a file");
    command.callback([file, preset_only, &task] {
        task = [file, preset_only] { return show(*file, *preset_only); };
    });
}

}  // namespace ember
