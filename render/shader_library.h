// GLSL programs from the files of shaders/.
#pragma once

#include <glad/gl.h>

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace ember {

/// A linked program. Uniforms that the shader does not use are silently ignored, as in GL.
class Program {
  public:
    /// Compiles `name`.vert and `name`.frag, each after common.glsl. Throws RenderError with the
    /// file and line of the first error.
    explicit Program(std::string_view name) : Program(name, name) {}
    Program(std::string_view vertex, std::string_view fragment);
    /// The same from given sources, under the file names that errors should show.
    Program(std::string_view vertex_file, std::string_view vertex_source,
            std::string_view fragment_file, std::string_view fragment_source);
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&&) = delete;

    void use() const { glUseProgram(name_); }
    void set(const char* uniform, int value) const;
    void set(const char* uniform, float value) const;
    void set(const char* uniform, const Eigen::Vector2f& value) const;
    void set(const char* uniform, const Eigen::Vector3f& value) const;
    void set(const char* uniform, const Eigen::Vector4f& value) const;
    void set(const char* uniform, const Eigen::Matrix4f& value) const;
    void set_array(const char* uniform, int count, const Eigen::Vector4f* values) const;

  private:
    [[nodiscard]] GLint find(const char* uniform) const {
        return glGetUniformLocation(name_, uniform);
    }
    GLuint name_ = 0;
};

/// A compiler's log with `file` in front, and the line that its first message has: "sheet.frag:12:
/// error: ...". Drivers write places in three ways ("0:12(5): ", "0(12) : ", "ERROR: 0:12: "); a
/// log that begins otherwise stays as it is.
[[nodiscard]] std::string located(std::string_view file, const std::string& log);

}  // namespace ember
