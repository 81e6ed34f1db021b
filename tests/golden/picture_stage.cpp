#include <glad/gl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "app/run_options.h"
#include "app/shot_record.h"
#include "golden/stage.h"
#include "render/renderer.h"
#include "sim/param_table.h"

namespace ember::golden {
namespace {

// Of ARB_pipeline_statistics_query, which is younger than OpenGL 3.3.
constexpr GLenum kFragmentShaderInvocations = 0x82F4;

// Counts how often fragment shaders run while it lives, where the driver can tell.
class FragmentCount {
  public:
    FragmentCount() {
        GLint count = 0;
        glGetIntegerv(GL_NUM_EXTENSIONS, &count);
        for (GLint i = 0; i < count && query_ == 0; ++i) {
            const auto* name =
                reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
            if (std::strcmp(name, "GL_ARB_pipeline_statistics_query") == 0)
                glGenQueries(1, &query_);
        }
        if (query_ != 0) glBeginQuery(kFragmentShaderInvocations, query_);
    }
    ~FragmentCount() {
        if (query_ != 0) glDeleteQueries(1, &query_);
    }
    FragmentCount(const FragmentCount&) = delete;
    FragmentCount& operator=(const FragmentCount&) = delete;
    [[nodiscard]] std::int64_t end() const {
        GLuint64 count = 0;
        if (query_ == 0) return 0;
        glEndQuery(kFragmentShaderInvocations);
        glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &count);
        return static_cast<std::int64_t>(count);
    }

  private:
    GLuint query_ = 0;
};

std::int64_t passes_of(const PassCounters& c) {
    return c.frames + c.shadow + c.ground + c.lighter + c.sheets + c.lattice + c.fire + c.bloom +
           c.legend;
}

void add(StepCounters& sum, const StepCounters& tick) {
    std::vector<std::int64_t> counts;
    for_each_counter(tick, [&](const char*, std::int64_t count) { counts.push_back(count); });
    auto next = counts.begin();
    for_each_counter(sum, [&](const char*, std::int64_t& count) { count += *next++; });
}

class PictureStage final : public Stage {
  public:
    PictureStage(const std::filesystem::path& preset, Rasteriser rasteriser)
        : preset_(load_preset_file(preset)), world_(build_world(preset_, 1)) {
        context_ = OffscreenContext::create(choose_rasteriser(rasteriser));
        renderer_ = std::make_unique<Renderer>(context_->loader());
        std::vector bindings{bind(preset_.params)};
        parameters_ = text_hash(preset_text(bindings, {}));
    }

    Drawn draw(const Scene& scene) override {
        burn_until(scene.tick);
        RenderParams look = preset_.render;
        const std::vector bindings{bind(look)};
        for (const std::string& word : scene.words) {
            for (const Diagnostic& d : apply_override(word, bindings, scene.full_name()))
                throw std::runtime_error(d.text());
        }
        const WorldView view = world_.view();
        Frame frame{&view, {}};
        std::vector<std::vector<SpringSegment>> springs;
        for (std::size_t s = 0; s < view.sheets.size() && needs_springs(look.view.mode); ++s)
            springs.push_back(world_.springs(s));
        frame.springs = springs;

        const PassCounters before = renderer_->counters();
        const FragmentCount fragments;
        Drawn drawn{parameters_, world_.hash(), {}, {}, sim_work()};
        drawn.image = renderer_->draw_image(frame, look, scene.width, scene.height);
        drawn.work.emplace_back("render.fragments", fragments.end());
        const PassCounters after = renderer_->counters();
        drawn.work.emplace_back("render.passes", passes_of(after) - passes_of(before));
        // not uploads: they depend on what was drawn before
        drawn.environment = present_environment(renderer_->description());
        if (const GLenum error = glGetError(); error != GL_NO_ERROR)
            throw std::runtime_error("OpenGL error " + std::to_string(error) + " in a frame");
        return drawn;
    }

  private:
    static LoadedPreset load_preset_file(const std::filesystem::path& file) {
        RunOptions options;
        options.preset = file.string();
        return load_run(options);
    }
    void burn_until(std::uint64_t tick) {
        while (world_.state().tick < tick) {
            const StepReport report = world_.step();
            if (!report.ok()) throw std::runtime_error(divergence_text(report));
            add(counters_, report.counters);
        }
        if (world_.state().tick != tick)
            throw std::runtime_error("tick " + std::to_string(tick) + " is past");
    }
    [[nodiscard]] Work sim_work() const {
        Work work{{"ticks", static_cast<std::int64_t>(world_.state().tick)}};
        for_each_counter(counters_, [&](const char* name, std::int64_t count) {
            if (count > 0) work.emplace_back(name, count);
        });
        return work;
    }

    LoadedPreset preset_;
    World world_;
    StepCounters counters_;
    std::uint64_t parameters_ = 0;
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
};

}  // namespace

std::unique_ptr<Stage> picture_stage(const std::filesystem::path& preset, Rasteriser rasteriser) {
    return std::make_unique<PictureStage>(preset, rasteriser);
}

GlBackend choose_rasteriser(Rasteriser rasteriser) {
    if (rasteriser == Rasteriser::Pinned) {
        pin_software_rasteriser();
        return GlBackend::OsMesa;
    }
    ::unsetenv("GALLIUM_OVERRIDE_CPU_CAPS");
    return rasteriser == Rasteriser::AsItIs ? GlBackend::OsMesa : GlBackend::Egl;
}

Environment present_environment(const std::string& renderer) {
    const char* caps = std::getenv("GALLIUM_OVERRIDE_CPU_CAPS");
    return {renderer, caps == nullptr ? "all" : caps};
}

}  // namespace ember::golden
