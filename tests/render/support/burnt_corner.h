// presets/paper/corner, burnt for a while.
#pragma once

#include "app/preset_io/preset_io.h"
#include "render/view_params.h"
#include "sim/param_table.h"
#include "sim/world.h"

namespace ember::test {

class BurntCorner {
  public:
    /// Throws std::runtime_error when the preset has problems.
    BurntCorner() : world_(load()) {}

    /// Steps up to `tick`; throws std::runtime_error when the simulation stops.
    void burn_until(std::uint64_t tick) {
        while (world_.state().tick < tick) {
            const StepReport report = world_.step();
            if (!report.ok()) throw std::runtime_error("the simulation stopped: " + report.reason);
        }
    }

    [[nodiscard]] const World& world() const { return world_; }
    [[nodiscard]] const RenderParams& render() const { return render_; }

  private:
    World load() {
        Params params;
        const PresetResult preset = load_preset(EMBERLEAF_SOURCE "/presets/paper/corner.toml",
                                                std::vector{bind(params), bind(render_)});
        for (const Diagnostic& d : preset.diagnostics) {
            if (!preset.ok()) throw std::runtime_error(d.text());
        }
        return make_world(params);
    }

    RenderParams render_;
    World world_;
};

}  // namespace ember::test
