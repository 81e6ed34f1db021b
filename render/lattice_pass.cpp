#include "render/passes.h"

namespace ember {
namespace {

struct LineVertex {
    float x, y, z, r, g, b;
};

// By kind; springs between two burnt-out nodes are dimmed.
Colour colour_by_kind(const SheetView& sheet, const SpringSegment& s) {
    const auto row = [&](Index n) {
        return sheet.site[static_cast<std::size_t>(n)] / sheet.column_count;
    };
    const auto both = [&](Phase phase) {
        return sheet.phase[static_cast<std::size_t>(s.a)] == phase &&
               sheet.phase[static_cast<std::size_t>(s.b)] == phase;
    };
    if (both(Phase::Burning)) return spring_colour(SpringColour::Burning);
    Colour colour = spring_colour(SpringColour::Bending);
    if (s.kind == SpringKind::Diagonal) colour = spring_colour(SpringColour::Diagonal);
    if (s.kind == SpringKind::Structural) {
        colour = spring_colour(row(s.a) == row(s.b) ? SpringColour::Main : SpringColour::Cross);
    }
    return both(Phase::BurntOut) ? Colour(0.30f * colour) : colour;
}

Colour colour_by_stiffness(const SpringSegment& s) {
    return mass_map((s.stiffness - kSoftest) / (kStiffest - kSoftest));
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
    const bool stiffness = in.params.view.mode == ViewMode::Stiffness;
    // bending springs first, so that the structural ones that cover them are seen
    for (const SpringKind kind :
         {SpringKind::Bending, SpringKind::Diagonal, SpringKind::Structural}) {
        for (std::size_t s = 0; s < in.frame.springs.size(); ++s) {
            const SheetView& sheet = in.frame.world->sheets[s];
            for (const SpringSegment& spring : in.frame.springs[s]) {
                if (spring.kind != kind) continue;
                if (stiffness && kind != SpringKind::Structural) continue;
                const Colour c =
                    stiffness ? colour_by_stiffness(spring) : colour_by_kind(sheet, spring);
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
