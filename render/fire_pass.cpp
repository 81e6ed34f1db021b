#include <cstddef>

#include "render/assets.h"
#include "render/passes.h"

namespace ember {
namespace {

void set_target(const Framebuffer& framebuffer, const Texture& colour, int width, int height) {
    allocate(colour, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
}

}  // namespace

FirePass::FirePass()
    : ramp_(table_texture(flame_colour, 1.0)), sprites_(load_texture(asset("flame.png"))) {
    // one level of detail is enough for what is soft, and half the work of two
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
}

bool FirePass::prepare(const PassInput& in) {
    const LookParams& look = in.params.look;
    FireSprites fire = gather_fire_sprites(
        *in.frame.world, in.fire, {look.flame_size, look.flame_share, look.smoke, look.sparks},
        in.camera);
    flames_ = static_cast<GLsizei>(fire.flames);
    sparks_ = static_cast<GLsizei>(fire.sprites.size() - fire.flames);
    if (fire.sprites.empty()) return false;
    if (upload_changed(GL_ARRAY_BUFFER, instances_, fire.sprites, packed_)) ++uploads_;
    return true;
}

void FirePass::bind_inputs(const Program& program, const PassInput& in, const Texture& depth) {
    program.use();
    program.set("u_view", in.camera.view);
    program.set("u_projection", in.camera.projection);
    program.set("u_brightness", static_cast<float>(in.params.look.flame_brightness));
    program.set("u_floor", in.frame.world->ground ? 0.0f : -1e9f);
    program.set("u_pixels",
                Eigen::Vector2f(static_cast<float>(width_), static_cast<float>(height_)));
    bind_texture(0, sprites_);
    bind_texture(1, ramp_);
    bind_texture(2, depth);
    bind_texture(3, amounts_);
    program.set("u_sprites", 0);
    program.set("u_ramp", 1);
    program.set("u_depth", 2);
    program.set("u_amounts", 3);
}

void FirePass::draw(const PassInput& in, const Texture& depth) {
    // fire is soft, so fewer pixels do
    const int part = in.params.look.quality == Quality::Full ? 2 : 4;
    const int width = (in.width + part - 1) / part, height = (in.height + part - 1) / part;
    if (width != width_ || height != height_) {
        set_target(amounts_target_, amounts_, width, height);
        set_target(target_, colour_, width, height);
        width_ = width;
        height_ = height;
    }
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, amounts_target_.name());
    glClear(GL_COLOR_BUFFER_BIT);
    // amounts add up whatever their order, so nothing has to be sorted
    glBlendFunc(GL_ONE, GL_ONE);
    if (flames_ > 0) {
        glEnable(GL_BLEND);
        bind_inputs(program_, in, depth);
        draw_sprites(0, flames_);
        glDisable(GL_BLEND);
    }

    glBindFramebuffer(GL_FRAMEBUFFER, target_.name());
    bind_inputs(light_, in, depth);
    const Lighting& l = in.lighting;
    light_.set("u_smoke_light", Eigen::Vector3f(static_cast<float>(in.params.look.key_light) *
                                                (0.22f * l.key + 0.35f * l.sky)));
    glBindVertexArray(empty_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    if (sparks_ > 0) {
        glEnable(GL_BLEND);
        bind_inputs(spark_, in, depth);
        draw_sprites(flames_, sparks_);
        glDisable(GL_BLEND);
    }
    glEnable(GL_DEPTH_TEST);
}

void FirePass::draw_sprites(GLsizei first, GLsizei count) {
    // OpenGL 3.3 cannot start in the middle of instances, so the attributes are moved instead
    glBindVertexArray(array_.name());
    glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
    constexpr std::size_t kStride = sizeof(FireSprite);
    const std::size_t from = static_cast<std::size_t>(first) * kStride;
    float_attribute(0, 3, kStride, from + offsetof(FireSprite, tail), 1);
    float_attribute(1, 3, kStride, from + offsetof(FireSprite, head), 1);
    float_attribute(2, 4, kStride, from + offsetof(FireSprite, half_width), 1);
    float_attribute(3, 4, kStride, from + offsetof(FireSprite, heat), 1);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    glBindVertexArray(0);
}

}  // namespace ember
