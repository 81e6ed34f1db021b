#include "../ui/desk_rig.h"
#include "app/run_options.h"
#include "app/shot_record.h"
#include "golden/stage.h"
#include "sim/param_table.h"
#include "ui/imgui_painter.h"

namespace ember::golden {
namespace {

constexpr int kWidth = 1280, kHeight = 720;  // [pixels] of the window

Action action_of(const std::string& key) {
    for (const KeyBinding& binding : key_bindings()) {
        if (binding.key != 0 && binding.name == key) return binding.action;
    }
    throw std::runtime_error("key=" + key + ": expected the name of a key");
}

// Dear ImGui takes reciprocal roots by an instruction that estimates them, each maker's processors
// in their own way: a few pixels beside a line or a corner differ by a level.
std::string maker_of_processor() {
#if defined(__x86_64__)
    if (__builtin_cpu_is("intel")) return "Intel";
    if (__builtin_cpu_is("amd")) return "AMD";
#endif
    return "another maker";
}

// The window's contents, on a black ground instead of the picture, which other scenes show.
class PanelStage final : public Stage, private DeskRig {
  public:
    PanelStage(const std::filesystem::path& preset, Rasteriser rasteriser) {
        backend_ = choose_rasteriser(rasteriser);
        Params params;
        const std::vector bindings{bind(params)};
        static_cast<void>(load_preset(preset, bindings));
        parameters_ = text_hash(preset_text(bindings, {}));
        open(kWidth, kHeight, 1, preset);
        painter_ = std::make_unique<ImguiPainter>();
        bench().settings.show_info = false;
    }
    ~PanelStage() override {
        painter_.reset();
        close();
    }

    Drawn draw(const Scene& scene) override {
        while (bench().snapshot().stats.tick < scene.tick) {
            bench().act(Action::Step);
            frames(1);
        }
        if (bench().snapshot().stats.tick != scene.tick || bench().snapshot().stopped)
            throw std::runtime_error(scene.full_name() + ": the burn is not there");
        const std::vector<Action> actions = actions_of(scene);
        for (const Action action : actions) {
            bench().act(action);
            frames(2);
        }
        bench().notices.dismiss();
        frames(2);
        Drawn drawn{parameters_, bench().snapshot().hash, part(scene), {}, {}};
        drawn.environment = present_environment(
            std::string(reinterpret_cast<const char*>(glGetString(GL_RENDERER))) + ", OpenGL " +
            reinterpret_cast<const char*>(glGetString(GL_VERSION)) + ", on a processor by " +
            maker_of_processor());
        for (const Action action : actions)
            bench().act(action);  // a second time undoes it
        frames(2);
        return drawn;
    }

  private:
    void TestBody() override {}
    static std::vector<Action> actions_of(const Scene& scene) {
        std::vector<Action> actions;
        for (const std::string& word : scene.words) {
            if (word.find("key=") != 0)
                throw std::runtime_error(scene.full_name() + ": " + word + ": expected key=NAME");
            actions.push_back(action_of(word.substr(4)));
        }
        return actions;
    }
    // The scene's part of the window.
    Image part(const Scene& scene) {
        glBindFramebuffer(GL_FRAMEBUFFER, target_->name());
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        painter_->draw(*ImGui::GetDrawData(), target_->name());
        const std::vector<unsigned char> all = pixels();
        Image image{scene.width, scene.height, {}};
        for (int y = scene.top; y < scene.top + scene.height; ++y) {
            if (y >= height_ || scene.left + scene.width > width_)
                throw std::runtime_error(scene.full_name() + " leaves the window of 1280x720");
            const auto row = all.begin() + 4 * (std::ptrdiff_t{height_ - 1 - y} * width_);
            image.rgba.insert(image.rgba.end(), row + 4 * scene.left,
                              row + 4 * (scene.left + scene.width));
        }
        return image;
    }

    std::uint64_t parameters_ = 0;
    std::unique_ptr<ImguiPainter> painter_;
};

}  // namespace

std::unique_ptr<Stage> panel_stage(const std::filesystem::path& preset, Rasteriser rasteriser) {
    return std::make_unique<PanelStage>(preset, rasteriser);
}

}  // namespace ember::golden
