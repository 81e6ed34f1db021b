#include <cstddef>

#include "render/assets.h"
#include "render/passes.h"

namespace ember {

Texture table_texture(Colour (*function)(double), double end) {
    const ColourTable table = tabulate(function, end);
    Texture texture;
    allocate(texture, GL_RGB32F, GL_RGB, GL_FLOAT, kTableSize, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kTableSize, 1, GL_RGB, GL_FLOAT, table.data());
    return texture;
}

SheetPass::SheetPass()
    : albedo_(table_texture(paper_albedo, kBurnProgressEnd)),
      glow_(table_texture(paper_glow, kBurnProgressEnd)),
      heat_(table_texture(heat_map, 1.0)),
      mass_(table_texture(mass_map, 1.0)),
      fibre_(load_texture(asset("fibre.png"))) {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    constexpr std::size_t kStride = sizeof(SheetVertex);
    float_attribute(0, 3, kStride, offsetof(SheetVertex, x));
    float_attribute(1, 3, kStride, offsetof(SheetVertex, nx));
    float_attribute(2, 2, kStride, offsetof(SheetVertex, u));
    float_attribute(3, 4, kStride, offsetof(SheetVertex, progress));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    glBindVertexArray(0);
}

bool SheetPass::prepare(const WorldView& world) {
    glBindVertexArray(array_.name());
    packed_.clear();
    std::vector<std::uint64_t> topology;
    for (const SheetView& sheet : world.sheets) {
        // node and quad counts tell apart worlds whose versions happen to agree
        for (const std::uint64_t v : {sheet.topology_version, std::uint64_t{sheet.x.size()},
                                      std::uint64_t{sheet.quads.size()}}) {
            topology.push_back(v);
        }
        append_vertices(sheet, world, packed_);
    }
    upload<SheetVertex>(GL_ARRAY_BUFFER, vertices_, packed_);
    if (topology == uploaded_) return !triangles_.empty();
    triangles_.clear();
    std::uint32_t first = 0;
    for (const SheetView& sheet : world.sheets) {
        append_triangles(sheet, first, triangles_);
        first += static_cast<std::uint32_t>(sheet.x.size());
    }
    upload<std::uint32_t>(GL_ELEMENT_ARRAY_BUFFER, indices_, triangles_);
    uploaded_ = topology;
    return !triangles_.empty();
}

void SheetPass::draw_triangles() const {
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(triangles_.size()), GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

void SheetPass::draw(const PassInput& in) {
    program_.use();
    set_lighting(program_, in);
    program_.set("u_mode", static_cast<int>(in.params.view.mode));
    const char* samplers[] = {"u_albedo", "u_glow", "u_heat", "u_mass", "u_fibre"};
    const Texture* textures[] = {&albedo_, &glow_, &heat_, &mass_, &fibre_};
    for (int unit = 0; unit < 5; ++unit) {
        bind_texture(static_cast<GLuint>(unit), *textures[unit]);
        program_.set(samplers[unit], unit);
    }
    program_.set("u_hottest", 1100.0f);
    for (const Phase phase : {Phase::Unburnt, Phase::Burning, Phase::BurntOut}) {
        const char* names[] = {"u_unburnt", "u_burning", "u_burnt_out"};
        program_.set(names[static_cast<int>(phase)], Eigen::Vector3f(phase_colour(phase)));
    }
    draw_triangles();
}

}  // namespace ember
