// OpenGL objects that free themselves.
#pragma once

#include <glad/gl.h>

#include <cstring>
#include <span>
#include <utility>
#include <vector>

namespace ember {

/// Owns one GL name; Traits create and delete it.
template <class Traits>
class GlObject {
  public:
    GlObject() : name_(Traits::create()) {}
    ~GlObject() {
        if (name_ != 0) Traits::destroy(name_);
    }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    [[nodiscard]] GLuint name() const { return name_; }

  private:
    GLuint name_;
};

#define EMBER_GL_TRAITS(Type, gen, del)                     \
    struct Type##Traits {                                   \
        static GLuint create() {                            \
            GLuint name = 0;                                \
            gen(1, &name);                                  \
            return name;                                    \
        }                                                   \
        static void destroy(GLuint name) { del(1, &name); } \
    };                                                      \
    using Type = GlObject<Type##Traits>
EMBER_GL_TRAITS(Buffer, glGenBuffers, glDeleteBuffers);
EMBER_GL_TRAITS(VertexArray, glGenVertexArrays, glDeleteVertexArrays);
EMBER_GL_TRAITS(Texture, glGenTextures, glDeleteTextures);
EMBER_GL_TRAITS(Framebuffer, glGenFramebuffers, glDeleteFramebuffers);
EMBER_GL_TRAITS(Renderbuffer, glGenRenderbuffers, glDeleteRenderbuffers);
#undef EMBER_GL_TRAITS

/// Replaces the contents of `buffer`.
template <class T>
void upload(GLenum target, const Buffer& buffer, std::span<const T> data) {
    glBindBuffer(target, buffer.name());
    glBufferData(target, static_cast<GLsizeiptr>(data.size_bytes()), data.data(), GL_STREAM_DRAW);
}

/// The same where `fresh` differs from `last`, what the buffer holds, and takes its place; returns
/// whether it did. Compares bytes: two worlds may agree in every version number.
template <class T>
bool upload_changed(GLenum target, const Buffer& buffer, std::vector<T>& fresh,
                    std::vector<T>& last) {
    static_assert(sizeof(T) % sizeof(float) == 0, "floats and nothing between them");
    if (fresh.size() == last.size() &&
        std::memcmp(fresh.data(), last.data(), fresh.size() * sizeof(T)) == 0) {
        return false;
    }
    fresh.swap(last);
    upload<T>(target, buffer, last);
    return true;
}

/// Declares attribute `index` of the bound buffer: `count` floats at byte `offset`.
void float_attribute(GLuint index, GLint count, std::size_t stride, std::size_t offset,
                     GLuint divisor = 0);

/// Binds `texture` (2-D) to unit `unit`.
void bind_texture(GLuint unit, const Texture& texture);

/// Allocates a 2-D texture without mipmaps, clamped, linearly filtered.
void allocate(const Texture& texture, GLenum internal_format, GLenum format, GLenum type, int width,
              int height);

/// 2-D texture with mipmaps, repeating; 4 bytes per pixel.
[[nodiscard]] Texture load_texture(int width, int height, const unsigned char* rgba,
                                   GLenum internal_format = GL_RGBA8);
/// The same from an embedded PNG.
[[nodiscard]] Texture load_texture(std::span<const unsigned char> png,
                                   GLenum internal_format = GL_RGBA8);

}  // namespace ember
