#include <array>
#include <cmath>

#include "render/passes.h"

namespace ember {
namespace {

struct SolidVertex {
    float x, y, z, nx, ny, nz;
};

// The ground: a square so large that fog hides its edge.
void append_ground(std::vector<SolidVertex>& v) {
    constexpr float kHalf = 8.0f;
    for (const auto& [x, z] : {std::pair{-1, -1}, {-1, 1}, {1, 1}, {-1, -1}, {1, 1}, {1, -1}}) {
        v.push_back({kHalf * static_cast<float>(x), 0, kHalf * static_cast<float>(z), 0, 1, 0});
    }
}

// The lighter's nozzle: an eight-sided tube that ends a little below the flame.
void append_lighter(const Vector3& at, std::vector<SolidVertex>& v) {
    constexpr int kSides = 8;
    constexpr double kRadius = 0.004, kTop = -0.006, kBottom = -0.070;  // [m]
    for (int side = 0; side < kSides; ++side) {
        std::array<SolidVertex, 2> top{}, bottom{};
        for (int end = 0; end < 2; ++end) {
            const double angle = 2.0 * 3.141592653589793 * (side + end) / kSides;
            const double nx = std::cos(angle), nz = std::sin(angle);
            const auto vertex = [&](double y) {
                return SolidVertex{static_cast<float>(at.x() + kRadius * nx),
                                   static_cast<float>(at.y() + y),
                                   static_cast<float>(at.z() + kRadius * nz),
                                   static_cast<float>(nx),
                                   0.0f,
                                   static_cast<float>(nz)};
            };
            top[static_cast<std::size_t>(end)] = vertex(kTop);
            bottom[static_cast<std::size_t>(end)] = vertex(kBottom);
        }
        for (const SolidVertex& corner :
             {top[0], bottom[0], bottom[1], top[0], bottom[1], top[1]}) {
            v.push_back(corner);
        }
    }
}

}  // namespace

void StagePass::draw(const PassInput& in) {
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_.name());
    backdrop_.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);

    std::vector<SolidVertex> vertices;
    const WorldView& world = *in.frame.world;
    if (in.params.view.ground && world.ground) append_ground(vertices);
    const std::size_t ground = vertices.size();
    if (world.lighter_lit) append_lighter(world.lighter, vertices);
    if (vertices.empty()) return;
    glBindVertexArray(shape_.name());
    upload<SolidVertex>(GL_ARRAY_BUFFER, vertices_, vertices);
    float_attribute(0, 3, sizeof(SolidVertex), 0);
    float_attribute(1, 3, sizeof(SolidVertex), 3 * sizeof(float));
    solid_.use();
    set_lighting(solid_, in);
    solid_.set("u_pixels",
               Eigen::Vector2f(static_cast<float>(in.width), static_cast<float>(in.height)));
    const auto draw_range = [&](std::size_t first, std::size_t end, float albedo, float fog) {
        if (first == end) return;
        solid_.set("u_albedo", albedo);
        solid_.set("u_fog", fog);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first), static_cast<GLsizei>(end - first));
    };
    draw_range(0, ground, 0.10f, 1.0f);
    draw_range(ground, vertices.size(), 0.25f, 0.0f);
    glBindVertexArray(0);
}

}  // namespace ember
