#include "render/passes.h"

namespace ember {
namespace {

struct LineVertex {
    float x, y, z, r, g, b;
};

// The paper's colours: structural springs blue and pink, diagonals yellow, bending springs dark;
// springs between two burnt-out nodes are dimmed.
Colour spring_colour(const SheetView& sheet, const SpringSegment& s) {
    const auto row = [&](Index n) {
        return sheet.site[static_cast<std::size_t>(n)] / sheet.column_count;
    };
    Colour colour(0.35f, 0.36f, 0.40f);
    if (s.kind == SpringKind::Diagonal) colour = Colour(0.75f, 0.60f, 0.06f);
    if (s.kind == SpringKind::Structural) {
        colour = row(s.a) == row(s.b) ? Colour(0.08f, 0.30f, 0.95f) : Colour(0.95f, 0.20f, 0.45f);
    }
    const auto burnt = [&](Index n) {
        return sheet.phase[static_cast<std::size_t>(n)] == Phase::BurntOut;
    };
    const auto burning = [&](Index n) {
        return sheet.phase[static_cast<std::size_t>(n)] == Phase::Burning;
    };
    if (burning(s.a) && burning(s.b)) return Colour(2.2f, 0.75f, 0.08f);
    return burnt(s.a) && burnt(s.b) ? Colour(0.30f * colour) : colour;
}

}  // namespace

LatticePass::LatticePass() {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    float_attribute(0, 3, sizeof(LineVertex), 0);
    float_attribute(1, 3, sizeof(LineVertex), 3 * sizeof(float));
    glBindVertexArray(0);
}

bool LatticePass::draw(const PassInput& in) {
    std::vector<LineVertex> lines;
    // bending springs first, so that the structural ones that cover them are seen
    for (const SpringKind kind :
         {SpringKind::Bending, SpringKind::Diagonal, SpringKind::Structural}) {
        for (std::size_t s = 0; s < in.frame.springs.size(); ++s) {
            const SheetView& sheet = in.frame.world->sheets[s];
            for (const SpringSegment& spring : in.frame.springs[s]) {
                if (spring.kind != kind) continue;
                const Colour c = spring_colour(sheet, spring);
                for (const Index node : {spring.a, spring.b}) {
                    const auto n = static_cast<std::size_t>(node);
                    lines.push_back({static_cast<float>(sheet.x[n]), static_cast<float>(sheet.y[n]),
                                     static_cast<float>(sheet.z[n]), c.x(), c.y(), c.z()});
                }
            }
        }
    }
    if (lines.empty()) return false;
    glBindVertexArray(array_.name());
    upload<LineVertex>(GL_ARRAY_BUFFER, vertices_, lines);
    program_.use();
    program_.set("u_view", in.camera.view);
    program_.set("u_projection", in.camera.projection);
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(lines.size()));
    glDepthFunc(GL_LESS);
    glBindVertexArray(0);
    return true;
}

}  // namespace ember
