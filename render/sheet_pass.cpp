#include <algorithm>
#include <cstddef>

#include "render/assets.h"
#include "render/passes.h"
#include "render/quantity.h"

namespace ember {
namespace {

// [pixels/m] From here on a step of 1/255 between pixels, which is all that filters make of 8 bits,
// would show in the relief as dots.
constexpr double kNear = 3000;
constexpr double kRagged = 0.24;  // [cells] how far torn edges wander

void take_nearest(const Texture& texture) {
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

Texture table_texture(Colour (*function)(double), double end) {
    const ColourTable table = tabulate(function, end);
    Texture texture;
    allocate(texture, GL_RGB32F, GL_RGB, GL_FLOAT, kTableSize, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableSize, 1, GL_RGB, GL_FLOAT, table.data());
    return texture;
}

SheetPass::Noise::Noise(GLenum internal_format)
    : fibre(load_texture(asset("fibre.png"), internal_format)),
      crackle(load_texture(asset("crackle.png"), internal_format)) {
    for (const Texture* noise : {&fibre, &crackle}) {
        glBindTexture(GL_TEXTURE_2D, noise->name());  // one level of detail is enough for noise
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    }
}

SheetPass::SheetPass(int samples)
    : samples_(samples),
      scorch_(table_texture(scorched_albedo, kScorchEnd)),
      ember_(table_texture(ember_light, kEmberEnd)),
      heat_(table_texture(heat_map, 1.0)),
      mass_(table_texture(mass_map, 1.0)),
      stress_(table_texture(stress_map, 1.0)) {
    for (const Texture* table : {&scorch_, &ember_})
        take_nearest(*table);  // their steps are finer than the noise
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    constexpr std::size_t kVertex = sizeof(SheetVertex), kPoint = sizeof(SheetPoint);
    float_attribute(0, 3, kVertex, offsetof(SheetVertex, x));
    float_attribute(1, 3, kVertex, offsetof(SheetVertex, nx));
    float_attribute(2, 4, kVertex, offsetof(SheetVertex, charred));
    float_attribute(3, 1, kVertex, offsetof(SheetVertex, quantity));
    glBindBuffer(GL_ARRAY_BUFFER, points_.name());
    float_attribute(4, 4, kPoint, offsetof(SheetPoint, u));
    float_attribute(5, 4, kPoint, offsetof(SheetPoint, along));
    float_attribute(6, 2, kPoint, offsetof(SheetPoint, grain));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBindVertexArray(0);
}

void SheetPass::upload_topology(const WorldView& world, double pixels_per_metre, double ragged) {
    std::vector<std::uint64_t> topology;
    std::size_t quads = 0;
    double largest = 0;  // quad [m]
    for (const SheetView& sheet : world.sheets) {
        // node and quad counts tell apart worlds whose versions happen to agree
        for (const std::uint64_t v : {sheet.topology_version, std::uint64_t{sheet.x.size()},
                                      std::uint64_t{sheet.quads.size()}}) {
            topology.push_back(v);
        }
        quads += sheet.quads.size();
        largest = std::max(largest, sheet.height / (sheet.column_count - 1));
    }
    const int level = patch_level(quads, largest * pixels_per_metre);
    if (topology == uploaded_ && level == level_ && ragged == ragged_) return;
    uploaded_ = topology;
    ragged_ = ragged;
    level_ = level;
    std::vector<SheetPoint> points;
    for (std::size_t s = 0; s < world.sheets.size(); ++s)
        append_points(world.sheets[s], s, level_, points, ragged_);
    std::vector<std::uint32_t> triangles;
    append_triangles(quads, level_, 0, triangles);
    index_count_ = static_cast<GLsizei>(triangles.size());
    ++uploads_;
    upload<SheetPoint>(GL_ARRAY_BUFFER, points_, points);
    upload<std::uint32_t>(GL_ELEMENT_ARRAY_BUFFER, indices_, triangles);
}

bool SheetPass::prepare(const Frame& frame, const RenderParams& params, int height) {
    const WorldView& world = *frame.world;
    const double pixels = height / metres_high(params.camera);  // in a metre
    // views of the lattice show its own cells
    const bool beauty = params.view.mode == ViewMode::Beauty && !params.view.wireframe;
    const double ragged = beauty ? kRagged : 0.0;
    glBindVertexArray(array_.name());
    upload_topology(world, pixels, ragged);
    near_ = pixels > kNear;
    if (near_ && !near_noise_) near_noise_ = std::make_unique<const Noise>(GL_RGBA16F);
    shells_ = shell_count(world.caliper * pixels);
    caliper_ = shells_ > 1 ? static_cast<float>(world.caliper) : 0.0f;
    fresh_.clear();
    for (std::size_t s = 0; s < world.sheets.size(); ++s) {
        const SheetView& sheet = world.sheets[s];
        std::span<const SpringSegment> springs;
        if (s < frame.springs.size()) springs = frame.springs[s];
        append_vertices(sheet, world, level_, node_quantity(params.view.mode, sheet, springs),
                        fresh_, ragged_);
    }
    if (upload_changed(GL_ARRAY_BUFFER, vertices_, fresh_, packed_)) ++uploads_;
    glBindVertexArray(0);
    return index_count_ > 0;
}

void SheetPass::draw_triangles() const {
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void SheetPass::bind_paper(const PassInput& in, PaperLayer layer) {
    front_.show(in.params.printed.front);
    back_.show(in.params.printed.back);
    paper_.use();
    set_lighting(paper_, in);
    const char* samplers[] = {"u_scorch", "u_ember", "u_fibre", "u_crackle", "u_front", "u_back"};
    const Noise& noise = near_ ? *near_noise_ : noise_;
    const Texture* textures[] = {&scorch_,       &ember_,     &noise.fibre,
                                 &noise.crackle, &front_.ink, &back_.ink};
    for (int unit = 0; unit < 6; ++unit) {
        bind_texture(static_cast<GLuint>(unit), *textures[unit]);
        paper_.set(samplers[unit], unit);
    }
    paper_.set("u_char", char_albedo());
    paper_.set("u_ash_dark", ash_albedo(0));
    paper_.set("u_ash_pale", ash_albedo(1));
    paper_.set("u_layer", static_cast<int>(layer));
    paper_.set("u_samples", layer == PaperLayer::Picture ? samples_ : 1);
    paper_.set("u_wireframe", in.params.view.wireframe ? 1 : 0);
}

// As many shells as make the paper thick: torn edges, which are cut out of each in the same way,
// show those below as a wall. The faces come first, because they hide nearly all of the others.
void SheetPass::draw_thick() {
    const auto last = static_cast<float>(std::max(shells_ - 1, 1));
    for (int k = 0; k < shells_; ++k) {
        const int shell = k == 0 ? 0 : k == 1 ? shells_ - 1 : k - 1;
        paper_.set("u_lift", caliper_ * (static_cast<float>(shell) / last - 0.5f));
        paper_.set("u_inside", k > 1 ? 1 : 0);
        draw_triangles();
    }
}

void SheetPass::draw_layer(const PassInput& in, PaperLayer layer) {
    bind_paper(in, layer);
    draw_thick();
}

void SheetPass::draw_paper(const PassInput& in) {
    bind_paper(in, PaperLayer::Picture);
    // torn edges are covered in part; what is covered counts as opaque
    glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    draw_thick();
    glDisable(GL_SAMPLE_ALPHA_TO_ONE);
    glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void SheetPass::draw_quantity(const PassInput& in) {
    struct Scale {
        const Texture& map;
        float low, high;
    };
    const auto stress = static_cast<float>(1e-3 * in.params.view.stress_range);
    const ViewMode mode = in.params.view.mode;
    const Scale scale = mode == ViewMode::Mass     ? Scale{mass_, 0.0f, 1.0f}
                        : mode == ViewMode::Stress ? Scale{stress_, -stress, stress}
                                                   : Scale{heat_, 0.0f, float{kHottest}};
    quantity_.use();
    set_lighting(quantity_, in);
    bind_texture(0, scale.map);
    quantity_.set("u_map", 0);
    quantity_.set("u_range", Eigen::Vector2f(scale.low, scale.high));
    quantity_.set("u_phases", mode == ViewMode::State ? 1 : 0);
    quantity_.set("u_wireframe", in.params.view.wireframe ? 1 : 0);
    for (const Phase phase : {Phase::Unburnt, Phase::Burning, Phase::BurntOut}) {
        const char* names[] = {"u_unburnt", "u_burning", "u_burnt_out"};
        quantity_.set(names[static_cast<int>(phase)], phase_colour(phase));
    }
    draw_triangles();
}

void SheetPass::Print::show(const std::shared_ptr<const PictureFile>& wanted) {
    if (wanted == picture && picture) return;
    picture = wanted;
    if (picture) {
        ink = load_texture(picture->width, picture->height, picture->rgba.data());
        return;
    }
    const unsigned char white[4] = {255, 255, 255, 255};
    ink = load_texture(1, 1, white);
    take_nearest(ink);
}

void SheetPass::draw(const PassInput& in) {
    if (in.params.view.mode == ViewMode::Beauty) {
        draw_paper(in);
    } else {
        draw_quantity(in);
    }
}

}  // namespace ember
