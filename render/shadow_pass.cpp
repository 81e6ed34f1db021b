#include "render/passes.h"

namespace ember {
namespace {

constexpr GLuint kShadowUnit = 15;  // far from the units that the passes use themselves

void attach(const Framebuffer& framebuffer, const Texture& colour) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
}

}  // namespace

void set_lighting(const Program& program, const PassInput& in) {
    program.set("u_view", in.camera.view);
    program.set("u_projection", in.camera.projection);
    program.set("u_eye", in.camera.eye);
    const Lighting& light = in.lighting;
    const auto strength = static_cast<float>(in.params.look.key_light);
    program.set("u_key_direction", light.key_direction);
    program.set("u_key", Eigen::Vector3f(strength * light.key));
    program.set("u_sky", Eigen::Vector3f(strength * light.sky));
    program.set("u_bounce", Eigen::Vector3f(strength * light.bounce));
    program.set("u_backdrop_mid", Eigen::Vector3f(strength * light.backdrop_mid));
    program.set("u_backdrop_edge", Eigen::Vector3f(strength * light.backdrop_edge));
    program.set("u_shadow_from_world", in.shadow_from_world);
    bind_texture(kShadowUnit, in.shadow);
    program.set("u_shadow", static_cast<int>(kShadowUnit));
    program.set("u_light_count", in.params.view.flames ? in.lights.count : 0);
    program.set_array("u_lights", kMostFlameLights, in.lights.light.data());
    program.set("u_flame_light", static_cast<float>(in.params.look.flame_light));
}

ShadowPass::ShadowPass() {
    allocate(none_, GL_RGBA32F, GL_RGBA, GL_FLOAT, 1, 1);
    const float nothing[4] = {};
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_FLOAT, nothing);
}

void ShadowPass::draw(const PassInput& in, const SheetPass& sheets, int size) {
    if (size != size_) {
        allocate(map_, GL_RGBA32F, GL_RGBA, GL_FLOAT, size, size);
        allocate(spare_, GL_RGBA32F, GL_RGBA, GL_FLOAT, size, size);
        glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, size, size);
        attach(spare_target_, spare_);
        attach(target_, map_);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  depth_.name());
        size_ = size;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    glViewport(0, 0, size, size);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    program_.use();
    program_.set("u_shadow_from_world", in.shadow_from_world);
    sheets.draw_triangles();

    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_.name());
    blur_.use();
    blur_.set("u_source", 0);
    const float texel = 1.6f / static_cast<float>(size);
    glBindFramebuffer(GL_FRAMEBUFFER, spare_target_.name());
    bind_texture(0, map_);
    blur_.set("u_step", Eigen::Vector2f(texel, 0));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    bind_texture(0, spare_);
    blur_.set("u_step", Eigen::Vector2f(0, texel));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glEnable(GL_DEPTH_TEST);
}

}  // namespace ember
