#include "burnt_scenes.h"

#include <stdexcept>

#include "app/preset_io/mask_file.h"
#include "app/preset_io/preset_io.h"
#include "sim/param_table.h"

namespace ember::test {
namespace {

void expect_none(const std::vector<Diagnostic>& problems) {
    if (!problems.empty()) throw std::runtime_error(problems.front().text());
}

// A preset that burns.
class Burn {
  public:
    explicit Burn(const std::string& preset) : world_(load(preset)) {}

    [[nodiscard]] std::shared_ptr<const World> at(std::uint64_t tick) {
        while (world_.state().tick < tick) {
            const StepReport report = world_.step();
            if (!report.ok()) throw std::runtime_error(cause_text(report));
        }
        const auto copy = std::make_shared<World>(make_world(world_.params()));
        copy->restore(world_.snapshot());
        return copy;
    }
    [[nodiscard]] const RenderParams& render() const { return render_; }

  private:
    World load(const std::string& preset) {
        Params params;
        const PresetResult result = load_preset(EMBERLEAF_SOURCE "/presets/" + preset + ".toml",
                                                std::vector{bind(params), bind(render_)});
        if (!result.ok()) expect_none(result.diagnostics);
        expect_none(read_masks(params, result.info));
        expect_none(read_prints(render_, result.info));
        return make_world(params);
    }

    RenderParams render_;
    World world_;
};

// Looks at `place` from near.
void look_close(const Vector3& place, double closer, CameraParams& camera) {
    camera.target_x = place.x();
    camera.target_y = place.y();
    camera.target_z = place.z();
    zoom(camera, closer);
}

// A node in the middle of those that burn.
Vector3 burning_place(const World& world) {
    const SheetState& sheet = world.state().sheets[0];
    std::vector<std::size_t> burning;
    for (std::size_t n = 0; n < sheet.phase.size(); ++n) {
        if (sheet.phase[n] == Phase::Burning) burning.push_back(n);
    }
    if (burning.empty()) throw std::runtime_error("nothing burns in the scene");
    return sheet.position.at(burning[burning.size() / 2]);
}

void add_views(BurntScene scene, std::vector<BurntScene>& scenes) {
    const std::pair<const char*, ViewMode> modes[] = {{"temperature", ViewMode::Temperature},
                                                      {"mass", ViewMode::Mass},
                                                      {"state", ViewMode::State},
                                                      {"stress", ViewMode::Stress},
                                                      {"lattice", ViewMode::Lattice},
                                                      {"stiffness", ViewMode::Stiffness}};
    for (const auto& [name, mode] : modes) {
        scene.name = name;
        scene.params.view.mode = mode;
        if (needs_springs(mode)) scene.springs = {scene.world->springs(0)};
        scenes.push_back(scene);
    }
}

}  // namespace

std::vector<BurntScene> burnt_scenes() {
    Burn letter("paper/letter"), sheets("scenes/letter");
    const auto early = letter.at(60), middle = letter.at(240);
    std::vector<BurntScene> scenes{{"letter", middle, {}, letter.render()},
                                   {"lighter", early, {}, letter.render()},
                                   {"night", letter.at(360), {}, letter.render()},
                                   {"back", middle, {}, letter.render()},
                                   {"transparent", middle, {}, letter.render()},
                                   {"two sheets", sheets.at(150), {}, sheets.render()},
                                   {"close", middle, {}, letter.render()},
                                   {"from below", early, {}, letter.render()},
                                   {"border", middle, {}, letter.render()}};
    scenes[2].params.look.lighting = LightingPreset::Night;
    scenes[2].params.look.exposure = 1.4;
    scenes[3].params.camera.azimuth += 3.141592653589793;
    for (const std::size_t many : {2u, 3u})
        scenes[many].params.look.sparks = 20.0;  // few as they are, none may be seen otherwise
    scenes[4].params.view.transparent = true;
    look_close(early->lighters_at(early->state().time)[0].position, 6.0, scenes[1].params.camera);
    look_close(burning_place(*middle), 20.0, scenes[6].params.camera);
    // the lighter mirrors the lamp
    scenes[7].params.camera = scenes[1].params.camera;
    scenes[7].params.camera.elevation = -0.7;
    scenes[5].params.look.haze = 3.0;
    // the upper left corner, so near that the paper is some pixels thick
    look_close(middle->state().sheets[0].position.at(0), 8.0, scenes[8].params.camera);
    scenes[8].params.camera.field_of_view = 0.0175;
    scenes[8].params.camera.azimuth = -1.0;
    add_views(scenes[0], scenes);
    return scenes;
}

}  // namespace ember::test
