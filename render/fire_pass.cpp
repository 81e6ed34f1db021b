#include "render/assets.h"
#include "render/passes.h"

namespace ember {
namespace {

struct FireInstance {
    float x, y, z;     // [m]
    float vx, vy, vz;  // [m/s]
    float heat;        // [1]
    float life;        // [1] share of its life that is over
    float seed;        // [0, 1)
};

std::vector<FireInstance> pack(const WorldView& world) {
    const ParticleView& p = world.particles;
    std::vector<FireInstance> out;
    out.reserve(p.x.size());
    for (std::size_t i = 0; i < p.x.size(); ++i) {
        const double life = (world.time - p.birth[i]) / (p.death[i] - p.birth[i]);
        out.push_back({static_cast<float>(p.x[i]), static_cast<float>(p.y[i]),
                       static_cast<float>(p.z[i]), static_cast<float>(p.vx[i]),
                       static_cast<float>(p.vy[i]), static_cast<float>(p.vz[i]),
                       static_cast<float>(particle_heat(world, i)), static_cast<float>(life),
                       static_cast<float>(p.id[i] >> 40) * 0x1p-24f});
    }
    return out;
}

}  // namespace

FirePass::FirePass()
    : ramp_(table_texture(flame_colour, 1.0)), sprites_(load_texture(asset("flame.png"))) {
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    constexpr std::size_t kStride = sizeof(FireInstance);
    float_attribute(0, 3, kStride, 0, 1);
    float_attribute(1, 3, kStride, 3 * sizeof(float), 1);
    float_attribute(2, 3, kStride, 6 * sizeof(float), 1);
    glBindVertexArray(0);
}

void FirePass::draw(const PassInput& in, const Texture& depth) {
    const int width = (in.width + 1) / 2, height = (in.height + 1) / 2;
    if (width != width_ || height != height_) {
        allocate(colour_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_.name(),
                               0);
        width_ = width;
        height_ = height;
    }
    const std::vector<FireInstance> instances = pack(*in.frame.world);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    glBindVertexArray(array_.name());
    upload<FireInstance>(GL_ARRAY_BUFFER, instances_, instances);
    program_.use();
    program_.set("u_view", in.camera.view);
    program_.set("u_projection", in.camera.projection);
    program_.set("u_size", static_cast<float>(in.params.look.flame_size));
    program_.set("u_brightness", static_cast<float>(in.params.look.flame_brightness));
    program_.set("u_pixels",
                 Eigen::Vector2f(static_cast<float>(width), static_cast<float>(height)));
    bind_texture(0, sprites_);
    bind_texture(1, ramp_);
    bind_texture(2, depth);
    program_.set("u_sprites", 0);
    program_.set("u_ramp", 1);
    program_.set("u_depth", 2);
    // light adds up whatever its order, so nothing has to be sorted
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(instances.size()));
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glBindVertexArray(0);
}

}  // namespace ember
