#include "render/passes.h"

namespace ember {
namespace {

void attach(const Framebuffer& framebuffer, const Texture& colour) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour.name(), 0);
}

void check_complete() {
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw RenderError("this OpenGL cannot draw into multisampled half-float buffers");
    }
}

}  // namespace

void FilmPass::allocate_buffers(int width, int height) {
    width_ = width;
    height_ = height;
    glBindRenderbuffer(GL_RENDERBUFFER, multi_colour_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_RGBA16F, width, height);
    glBindRenderbuffer(GL_RENDERBUFFER, multi_depth_.name());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, GL_DEPTH_COMPONENT32F, width,
                                     height);
    glBindFramebuffer(GL_FRAMEBUFFER, multi_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              multi_colour_.name());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                              multi_depth_.name());
    check_complete();
    allocate(colour_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width, height);
    allocate(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    attach(single_, colour_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
    check_complete();
    const int w = (width + 3) / 4, h = (height + 3) / 4;
    allocate(half_a_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, w, h);
    allocate(half_b_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, w, h);
    attach(blur_a_, half_a_);
    attach(blur_b_, half_b_);
    check_complete();
}

void FilmPass::begin(int width, int height) {
    if (width != width_ || height != height_) allocate_buffers(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, multi_.name());
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FilmPass::resolve() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multi_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_,
                      GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

// Light that is brighter than the film can show, at a quarter of the size, blurred both ways twice.
void FilmPass::blur(const PassInput& in, const Texture* fire) {
    const int w = (width_ + 3) / 4, h = (height_ + 3) / 4;
    glViewport(0, 0, w, h);
    glBindFramebuffer(GL_FRAMEBUFFER, blur_a_.name());
    bright_.use();
    bind_texture(0, colour_);
    bind_texture(1, fire != nullptr ? *fire : colour_);
    bright_.set("u_scene", 0);
    bright_.set("u_fire", 1);
    bright_.set("u_has_fire", fire != nullptr ? 1 : 0);
    bright_.set("u_exposure", static_cast<float>(in.params.look.exposure));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    blur_.use();
    blur_.set("u_source", 0);
    for (const float radius : {1.0f, 2.5f}) {
        glBindFramebuffer(GL_FRAMEBUFFER, blur_b_.name());
        bind_texture(0, half_a_);
        blur_.set("u_step", Eigen::Vector2f(radius / static_cast<float>(w), 0));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindFramebuffer(GL_FRAMEBUFFER, blur_a_.name());
        bind_texture(0, half_b_);
        blur_.set("u_step", Eigen::Vector2f(0, radius / static_cast<float>(h)));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

void FilmPass::develop(const PassInput& in, const Texture* fire, unsigned target) {
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_.name());
    // quantities are colours to be read, not light to be developed
    const bool plain = in.params.view.mode != ViewMode::Beauty;
    if (!plain) blur(in, fire);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glViewport(0, 0, width_, height_);
    film_.use();
    bind_texture(0, colour_);
    bind_texture(1, fire != nullptr ? *fire : colour_);
    bind_texture(2, half_a_);
    film_.set("u_scene", 0);
    film_.set("u_fire", 1);
    film_.set("u_bloom", 2);
    film_.set("u_has_fire", fire != nullptr ? 1 : 0);
    film_.set("u_exposure", static_cast<float>(in.params.look.exposure));
    film_.set("u_plain", plain ? 1 : 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace ember
