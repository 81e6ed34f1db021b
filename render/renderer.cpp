#include "render/renderer.h"

#include <algorithm>
#include <utility>

#include "render/assets.h"
#include "render/passes.h"

namespace ember {
namespace {

void load_gl(GlLoader loader) {
    if (gladLoadGL(loader) == 0) throw RenderError("OpenGL entry points cannot be loaded");
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33) {
        throw RenderError("OpenGL 3.3 is needed, this is " + std::to_string(major) + "." +
                          std::to_string(minor));
    }
}

// Loads entry points before the passes create their objects.
struct LoadedGl {
    explicit LoadedGl(GlLoader loader) { load_gl(loader); }
};

}  // namespace

struct Renderer::Passes {
    LoadedGl gl;
    BackgroundPass background;
    LighterPass lighter;
    SheetPass sheets;
    ShadowPass shadow;
    LatticePass lattice;
    LegendPass legend;
    FirePass fire;
    FilmPass film;
    LayerPass layers;
    Texture read_colour;
    Framebuffer read_target;
    PassCounters counters;
    PassObserver observer;
    int samples;

    Passes(GlLoader loader, int samples_) : gl(loader), sheets(samples_), samples(samples_) {}

    // Runs a pass, counts it and tells the observer.
    template <class Pass>
    void run(std::string_view name, int& counter, const Pass& pass) {
        pass();
        ++counter;
        if (!observer) return;
        glFinish();
        observer(name);
    }
};

namespace {

constexpr double kGlows = 650.0;  // [K] from here on paper may be too bright for the film

bool anything_glows(const WorldView& world) {
    for (const SheetView& sheet : world.sheets) {
        if (std::any_of(sheet.temperature.begin(), sheet.temperature.end(),
                        [](double t) { return t > kGlows; })) {
            return true;
        }
    }
    return !world.particles.x.empty();
}

}  // namespace

Renderer::Renderer(GlLoader loader, int samples)
    : passes_(std::make_unique<Passes>(loader, samples)), loader_(loader) {}
Renderer::~Renderer() = default;

// Shadow, set and sheets, into the film's buffers.
void Renderer::draw_scene(const PassInput& in) {
    Passes& p = *passes_;
    const WorldView& world = *in.frame.world;
    const ViewParams& view = in.params.view;
    const bool preview = in.params.look.quality == Quality::Preview;
    if (&in.shadow == &p.shadow.texture()) {
        p.run("shadow", p.counters.shadow,
              [&] { p.shadow.draw(in, p.sheets, preview ? 192 : 320); });
    }
    if (!view.transparent) {
        const bool ground = view.ground && world.ground;
        int uncounted = 0;
        p.run("background", ground ? p.counters.ground : uncounted,
              [&] { p.background.draw(in, ground); });
    }
    p.film.begin(in.width, in.height, preview ? std::min(p.samples, 2) : p.samples);
    // from the front to the back, so that little is coloured twice
    if (view.mode == ViewMode::Lattice || view.mode == ViewMode::Stiffness) {
        if (p.lattice.draw(in)) p.run("lattice", p.counters.lattice, [] {});
    } else if (in.paper && sees(in.camera, in.bounds.centre, in.bounds.radius)) {
        p.run("sheets", p.counters.sheets, [&] { p.sheets.draw(in); });
    }
    const bool lit = std::any_of(world.lighters.begin(), world.lighters.end(),
                                 [](const LighterView& lighter) { return lighter.lit; });
    if (lit) p.run("lighter", p.counters.lighter, [&] { p.lighter.draw(in); });
}

void Renderer::draw(const Frame& frame, const RenderParams& params, int width, int height,
                    unsigned target) {
    Passes& p = *passes_;
    const WorldView& world = *frame.world;
    const Camera camera = make_camera(params.camera, width, height);
    const FireCells fire_cells(world);
    const FlameLights lights = gather_flame_lights(fire_cells);
    const Lighting lighting = lighting_of(params.look.lighting, params.look.light_azimuth);
    const Bounds bounds = bounds_of(world);
    const Eigen::Matrix4f to_shadow = shadow_from_world(bounds, lighting.key_direction);
    const bool beauty = params.view.mode == ViewMode::Beauty;
    const bool lattice =
        params.view.mode == ViewMode::Lattice || params.view.mode == ViewMode::Stiffness;
    const bool paper = !lattice && p.sheets.prepare(frame, params, height);
    if (p.observer) p.observer("vertices");
    const bool shadow = paper && beauty && params.look.key_light > 0;
    const PassInput in{frame,      params,    camera,
                       fire_cells, lights,    lighting,
                       bounds,     to_shadow, shadow ? p.shadow.texture() : p.shadow.none(),
                       paper,      width,     height};
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    draw_scene(in);
    const bool fire =
        params.view.flames && beauty && !world.particles.x.empty() && p.fire.prepare(in);
    int uncounted = 0;
    p.run("resolve", uncounted, [&] { p.film.resolve(fire); });
    FilmInput film;
    film.target = target;
    film.linear = p.layers.wanted();
    if (!params.view.transparent) film.background = &p.background.texture();
    if (fire) {
        p.run("fire", p.counters.fire, [&] { p.fire.draw(in, p.film.depth()); });
        film.fire = &p.fire.texture();
        film.haze = params.look.haze > 0;
        if (film.haze) p.run("haze", uncounted, [&] { p.film.haze(in, p.fire.amounts()); });
    }
    film.bloom = beauty && !film.linear && params.look.bloom > 0 && anything_glows(world);
    if (film.bloom) p.run("bloom", p.counters.bloom, [&] { p.film.bloom(in, film); });
    p.run("film", p.counters.frames, [&] { p.film.develop(in, film); });
    if (film.linear && paper) p.layers.draw_paper(in, p.sheets);
    const Legend legend = film.linear ? Legend{} : legend_of(params.view);
    if (!legend.empty())
        p.run("legend", p.counters.legend, [&] { p.legend.draw(in, legend, target); });
}

Image Renderer::draw_image(const Frame& frame, const RenderParams& params, int width, int height) {
    Passes& p = *passes_;
    allocate(p.read_colour, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, p.read_target.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           p.read_colour.name(), 0);
    draw(frame, params, width, height, p.read_target.name());
    const auto row = static_cast<std::size_t>(width) * 4;
    std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, p.read_target.name());
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
    Image image{width, height, {}};
    image.rgba.reserve(upside_down.size());
    for (int y = height - 1; y >= 0; --y) {
        const auto begin = upside_down.begin() + static_cast<std::ptrdiff_t>(row) * y;
        image.rgba.insert(image.rgba.end(), begin, begin + static_cast<std::ptrdiff_t>(row));
    }
    return image;
}

FloatImage Renderer::draw_layers(const Frame& frame, const RenderParams& params, int width,
                                 int height) {
    Passes& p = *passes_;
    p.layers.begin(width, height);
    draw(frame, params, width, height, p.layers.target());
    return p.layers.take();
}

void Renderer::observe_passes(PassObserver observer) {
    passes_->observer = std::move(observer);
}

void Renderer::reload(const std::filesystem::path& folder) {
    use_asset_folder(folder);
    auto fresh = std::make_unique<Passes>(loader_, passes_->samples);
    fresh->counters = passes_->counters;
    fresh->observer = passes_->observer;
    passes_ = std::move(fresh);
}

PassCounters Renderer::counters() const {
    PassCounters counters = passes_->counters;
    counters.uploads = passes_->sheets.uploads() + passes_->fire.uploads();
    return counters;
}

std::string Renderer::description() const {
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace ember
