#include <array>
#include <cmath>
#include <numbers>

#include "render/passes.h"

namespace ember {
namespace {

struct SolidVertex {
    float x, y, z, nx, ny, nz;
};

// The lighter's nozzle: an eight-sided tube that ends a little below the flame.
void append_lighter(const Vector3& at, std::vector<SolidVertex>& v) {
    constexpr int kSides = 8;
    constexpr double kRadius = 0.004, kTop = -0.006, kBottom = -0.070;  // [m]
    for (int side = 0; side < kSides; ++side) {
        std::array<SolidVertex, 2> top{}, bottom{};
        for (int end = 0; end < 2; ++end) {
            const double angle = 2.0 * std::numbers::pi * (side + end) / kSides;
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

// Lines of the ground's grid: close together below the paper, far apart where fog hides all.
float grid_line(int i, int half) {
    const float t = static_cast<float>(i - half) / static_cast<float>(half);
    return 0.9f * t + 7.0f * t * t * t * t * t;
}

}  // namespace

BackgroundPass::BackgroundPass() {
    constexpr int kHalf = 24, kLines = 2 * kHalf + 1;
    std::vector<Eigen::Vector2f> vertices;
    for (int row = 0; row < kLines; ++row) {
        for (int column = 0; column < kLines; ++column)
            vertices.emplace_back(grid_line(column, kHalf), grid_line(row, kHalf));
    }
    std::vector<std::uint16_t> indices;
    for (int row = 0; row + 1 < kLines; ++row) {
        for (int column = 0; column + 1 < kLines; ++column) {
            const int n = row * kLines + column;
            for (const int corner : {n, n + kLines, n + 1, n + 1, n + kLines, n + kLines + 1})
                indices.push_back(static_cast<std::uint16_t>(corner));
        }
    }
    count_ = static_cast<GLsizei>(indices.size());
    glBindVertexArray(array_.name());
    upload<Eigen::Vector2f>(GL_ARRAY_BUFFER, vertices_, vertices);
    float_attribute(0, 2, sizeof(Eigen::Vector2f), 0);
    upload<std::uint16_t>(GL_ELEMENT_ARRAY_BUFFER, indices_, indices);
    glBindVertexArray(0);
}

void BackgroundPass::draw(const PassInput& in, bool ground) {
    const int width = (in.width + 1) / 2, height = (in.height + 1) / 2;
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    if (width != width_ || height != height_) {
        allocate(colour_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(),
                               0);
        width_ = width;
        height_ = height;
    }
    glViewport(0, 0, width, height);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_.name());
    backdrop_.use();
    set_lighting(backdrop_, in);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    // from below, the floor would be before the paper
    if (ground && in.camera.eye.y() > 0) draw_ground(in);
    glBindVertexArray(0);
    glEnable(GL_DEPTH_TEST);
}

void BackgroundPass::draw_ground(const PassInput& in) {
    std::array<Eigen::Vector4f, kMostOccluders> places{}, normals{};
    const std::vector<Occluder> occluders = gather_occluders(*in.frame.world);
    for (std::size_t i = 0; i < occluders.size(); ++i) {
        places[i] = occluders[i].place;
        normals[i] = occluders[i].normal;
    }
    ground_.use();
    set_lighting(ground_, in);
    ground_.set("u_occluder_count", static_cast<int>(occluders.size()));
    ground_.set_array("u_occluders", kMostOccluders, places.data());
    ground_.set_array("u_occluder_normals", kMostOccluders, normals.data());
    ground_.set("u_albedo", in.lighting.ground);
    ground_.set("u_pixels",
                Eigen::Vector2f(static_cast<float>(width_), static_cast<float>(height_)));
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_SHORT, nullptr);
}

void LighterPass::draw(const PassInput& in) {
    std::vector<Vector3> places;
    for (const LighterView& lighter : in.frame.world->lighters) {
        if (lighter.lit) places.push_back(lighter.position);
    }
    glBindVertexArray(array_.name());
    if (places != uploaded_) {
        std::vector<SolidVertex> vertices;
        for (const Vector3& place : places)
            append_lighter(place, vertices);
        upload<SolidVertex>(GL_ARRAY_BUFFER, vertices_, vertices);
        float_attribute(0, 3, sizeof(SolidVertex), 0);
        float_attribute(1, 3, sizeof(SolidVertex), 3 * sizeof(float));
        uploaded_ = places;
        count_ = static_cast<GLsizei>(vertices.size());
    }
    program_.use();
    set_lighting(program_, in);
    program_.set("u_albedo", 0.25f);
    glDrawArrays(GL_TRIANGLES, 0, count_);
    glBindVertexArray(0);
}

}  // namespace ember
