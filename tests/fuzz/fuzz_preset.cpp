// A preset: anything is either values within their ranges or errors at a place.
#include <algorithm>

#include "../app/temporary_folder.h"
#include "app/preset_io/preset_io.h"
#include "app/preset_io/steering.h"
#include "promise.h"
#include "render/view_params.h"
#include "sim/param_table.h"
#include "sim/scene_check.h"

namespace ember {
namespace {

void build(Params& params, const PresetInfo& info) {
    try {
        if (count_nodes(params) < 10'000) validate(make_scene(params), caliper(params.paper));
    } catch (const SceneError& e) {
        promise(!place_error(info, e).text().empty());
    }
    std::vector<Diagnostic> problems;
    static_cast<void>(script_of(params, info, problems));
}

void read(const std::uint8_t* data, std::size_t size) {
    static const TemporaryFolder folder;
    Params params;
    RenderParams render;
    const ParamBinding bindings[] = {bind(params), bind(render)};
    const PresetResult result = load_preset(
        folder.write("p.toml", std::string_view(reinterpret_cast<const char*>(data), size)),
        bindings);
    for (const Diagnostic& d : result.diagnostics) {
        promise(!d.text().empty());
        static_cast<void>(d.excerpt());
    }
    if (!result.ok()) return;
    for (const ParamBinding& binding : bindings) {
        for (const ParamInfo& row : binding.rows) {
            if (!row.is_number() || row.kind == ParamKind::Choice || row.kind == ParamKind::Set)
                continue;
            const double shown = row.shown(binding.object), room = 1e-9 * std::abs(shown);
            promise(shown >= row.hard.min - room && shown <= row.hard.max + room);
        }
    }
    static_cast<void>(preset_text(bindings, result.info));
    build(params, result.info);
}

}  // namespace
}  // namespace ember

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ember::read(data, size);
    return 0;
}
