#include "render/passes.h"

namespace ember {
namespace {

constexpr double kHaze = 1.5e-5;  // [m^2] shift by how fast gas thickens across the picture [1/m]
constexpr int kBloomPart = 4;     // bloom has this fraction of the picture's width and height

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
    const int w = (width + kBloomPart - 1) / kBloomPart, h = (height + kBloomPart - 1) / kBloomPart;
    allocate(bloom_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, w, h);
    allocate(spare_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, w, h);
    attach(bloom_target_, bloom_);
    attach(spare_target_, spare_);
    check_complete();
}

void FilmPass::begin(int width, int height, int samples) {
    if (width != width_ || height != height_ || samples != samples_) {
        samples_ = samples;
        allocate_buffers(width, height);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, multi_.name());
    glViewport(0, 0, width, height);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FilmPass::resolve(bool depth) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, multi_.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, single_.name());
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_,
                      GL_COLOR_BUFFER_BIT | (depth ? GL_DEPTH_BUFFER_BIT : 0u), GL_NEAREST);
}

void FilmPass::bind_inputs(const Program& program, const PassInput& in, const FilmInput& film) {
    program.use();
    bind_texture(0, film.haze ? hazy_ : colour_);
    bind_texture(1, film.fire != nullptr ? *film.fire : colour_);
    bind_texture(2, bloom_);
    bind_texture(3, film.background != nullptr ? *film.background : colour_);
    program.set("u_scene", 0);
    program.set("u_fire", 1);
    program.set("u_bloom", 2);
    program.set("u_background", 3);
    program.set("u_has_fire", film.fire != nullptr ? 1 : 0);
    program.set("u_exposure", static_cast<float>(in.params.look.exposure));
    const bool blooms = film.bloom && in.params.look.bloom > 0;
    program.set("u_bloom_share", blooms ? static_cast<float>(in.params.look.bloom) : 0.0f);
}

void FilmPass::haze(const PassInput& in, const Texture& gas) {
    if (hazy_width_ != width_ || hazy_height_ != height_) {
        hazy_width_ = width_;
        hazy_height_ = height_;
        allocate(hazy_, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, width_, height_);
        attach(hazy_target_, hazy_);
        check_complete();
    }
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, hazy_target_.name());
    glViewport(0, 0, width_, height_);
    haze_.use();
    bind_texture(0, colour_);
    bind_texture(1, gas);
    haze_.set("u_scene", 0);
    haze_.set("u_gas", 1);
    haze_.set("u_pixels", Eigen::Vector2f(static_cast<float>(width_), static_cast<float>(height_)));
    const double pixels = height_ / metres_high(in.params.camera);  // in a metre
    haze_.set("u_haze", static_cast<float>(kHaze * in.params.look.haze * pixels * pixels));
    glBindVertexArray(empty_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void FilmPass::bloom(const PassInput& in, const FilmInput& film) {
    const int w = (width_ + kBloomPart - 1) / kBloomPart;
    const int h = (height_ + kBloomPart - 1) / kBloomPart;
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_.name());
    glViewport(0, 0, w, h);
    glBindFramebuffer(GL_FRAMEBUFFER, bloom_target_.name());
    bind_inputs(bright_, in, film);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    blur_.use();
    blur_.set("u_source", 0);
    for (const float radius : {1.0f, 2.7f}) {
        glBindFramebuffer(GL_FRAMEBUFFER, spare_target_.name());
        bind_texture(0, bloom_);
        blur_.set("u_step", Eigen::Vector2f(radius / static_cast<float>(w), 0));
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glBindFramebuffer(GL_FRAMEBUFFER, bloom_target_.name());
        bind_texture(0, spare_);
        blur_.set("u_step", Eigen::Vector2f(0, radius / static_cast<float>(h)));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
    glBindVertexArray(0);
}

void FilmPass::develop(const PassInput& in, const FilmInput& film) {
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, film.target);
    glViewport(0, 0, width_, height_);
    bind_inputs(film_, in, film);
    // quantities are colours to be read, not light to be developed
    film_.set("u_plain", film.linear ? 2 : in.params.view.mode != ViewMode::Beauty ? 1 : 0);
    film_.set("u_transparent", in.params.view.transparent ? 1 : 0);
    glBindVertexArray(empty_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

}  // namespace ember
