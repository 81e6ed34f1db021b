#include "ui/camera_text.h"

#include <cstdlib>

#include "app/preset_io/parameter_value.h"

namespace ember {

std::string camera_text(const CameraParams& camera) {
    RenderParams render;
    render.camera = camera;
    std::string text;
    for (const ParamInfo& row : render_param_rows()) {
        if (row.group() != "camera") continue;
        text += text.empty() ? "{\"" : ", \"";
        text += std::string(row.key) + "\": " + number_text(row.shown(&render));
    }
    return text + '}';
}

std::optional<CameraParams> camera_from_text(const std::string& text) {
    RenderParams render;
    for (const ParamInfo& row : render_param_rows()) {
        if (row.group() != "camera") continue;
        const std::string start = '"' + std::string(row.key) + "\":";
        const std::size_t at = text.find(start);
        if (at == std::string::npos) return std::nullopt;
        const char* begin = text.c_str() + at + start.size();
        char* end = nullptr;
        const double value = std::strtod(begin, &end);
        if (end == begin || !row.hard.contains(value)) return std::nullopt;
        row.set_shown(&render, value);
    }
    return render.camera;
}

}  // namespace ember
