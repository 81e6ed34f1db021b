#include "render/assets.h"
#include "render/passes.h"

namespace ember {

LegendPass::LegendPass() : font_(load_texture(asset("font.png"))) {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    float_attribute(0, 2, sizeof(LegendVertex), 0);
    float_attribute(1, 2, sizeof(LegendVertex), 2 * sizeof(float));
    float_attribute(2, 3, sizeof(LegendVertex), 4 * sizeof(float));
    glBindVertexArray(0);
}

void LegendPass::draw(const PassInput& in, const Legend& legend, unsigned target) {
    const std::vector<LegendVertex> vertices = legend_triangles(legend, in.width, in.height);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, in.width, in.height);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(array_.name());
    upload<LegendVertex>(GL_ARRAY_BUFFER, vertices_, vertices);
    program_.use();
    bind_texture(0, font_);
    program_.set("u_font", 0);
    program_.set("u_pixels",
                 Eigen::Vector2f(static_cast<float>(in.width), static_cast<float>(in.height)));
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices.size()));
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(0);
}

}  // namespace ember
