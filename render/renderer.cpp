#include "render/renderer.h"

#include <algorithm>

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

constexpr int kShadowSize = 384;  // [pixels] the map is blurred anyway

// Loads entry points before the passes create their objects.
struct LoadedGl {
    explicit LoadedGl(GlLoader loader) { load_gl(loader); }
};

}  // namespace

struct Renderer::Passes {
    LoadedGl gl;
    BackdropPass backdrop;
    GroundPass ground;
    LighterPass lighter;
    SheetPass sheets;
    ShadowPass shadow;
    LatticePass lattice;
    LegendPass legend;
    FirePass fire;
    FilmPass film;
    Texture read_colour;
    Framebuffer read_target;
    PassCounters counters;

    Passes(GlLoader loader, int samples) : gl(loader), sheets(samples), film(samples) {}

    template <class Pass>
    static void run(int& counter, const Pass& pass) {
        pass();
        ++counter;
    }
};

Renderer::Renderer(GlLoader loader, int samples)
    : passes_(std::make_unique<Passes>(loader, samples)) {}
Renderer::~Renderer() = default;

void Renderer::draw(const Frame& frame, const RenderParams& params, int width, int height,
                    unsigned target) {
    Passes& p = *passes_;
    const WorldView& world = *frame.world;
    const Camera camera = make_camera(params.camera, width, height);
    const FlameLights lights = gather_flame_lights(world);
    const Lighting lighting = lighting_of(params.look.lighting);
    const Bounds bounds = bounds_of(world);
    const Eigen::Matrix4f to_shadow = shadow_from_world(bounds, lighting.key_direction);
    const bool beauty = params.view.mode == ViewMode::Beauty;
    const bool lattice =
        params.view.mode == ViewMode::Lattice || params.view.mode == ViewMode::Stiffness;
    const bool paper = !lattice && p.sheets.prepare(frame, params, height);
    const bool shadow = paper && beauty && params.look.key_light > 0;
    const PassInput in{frame,    params, camera,    lights,
                       lighting, bounds, to_shadow, shadow ? p.shadow.texture() : p.shadow.none(),
                       width,    height};
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    if (shadow) p.run(p.counters.shadow, [&] { p.shadow.draw(in, p.sheets, kShadowSize); });
    p.film.begin(width, height);
    p.backdrop.draw(in);
    if (params.view.ground && world.ground) p.run(p.counters.ground, [&] { p.ground.draw(in); });
    const bool lit = std::any_of(world.lighters.begin(), world.lighters.end(),
                                 [](const LighterView& lighter) { return lighter.lit; });
    if (lit) p.run(p.counters.lighter, [&] { p.lighter.draw(in); });
    if (lattice) p.counters.lattice += p.lattice.draw(in) ? 1 : 0;
    if (paper) p.run(p.counters.sheets, [&] { p.sheets.draw(in); });
    p.film.resolve();
    const bool fire = params.view.flames && beauty && !world.particles.x.empty();
    if (fire) p.run(p.counters.fire, [&] { p.fire.draw(in, p.film.depth()); });
    p.film.develop(in, fire ? &p.fire.texture() : nullptr, target);
    const Legend legend = legend_of(params.view);
    if (!legend.empty()) p.run(p.counters.legend, [&] { p.legend.draw(in, legend, target); });
    ++p.counters.frames;
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

PassCounters Renderer::counters() const {
    return passes_->counters;
}

std::string Renderer::description() const {
    const auto text = [](GLenum name) {
        return std::string(reinterpret_cast<const char*>(glGetString(name)));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace ember
