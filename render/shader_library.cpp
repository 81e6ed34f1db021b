#include "render/shader_library.h"

#include <fstream>
#include <map>
#include <regex>
#include <utility>
#include <vector>

#include "render/assets.h"
#include "render/renderer.h"

namespace ember {
namespace {

// Files that stand in for embedded ones, by name.
std::map<std::string_view, std::vector<unsigned char>>& replaced_assets() {
    static std::map<std::string_view, std::vector<unsigned char>> files;
    return files;
}

std::string text_of(std::string_view file) {
    const auto bytes = asset(file);
    return {bytes.begin(), bytes.end()};
}

GLuint compile(GLenum kind, std::string_view file, std::string_view source) {
    const std::string common = "#version 330 core\n" + text_of("common.glsl") + "\n#line 1\n";
    const std::string body(source);
    const char* parts[] = {common.c_str(), body.c_str()};
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 2, parts, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE) return shader;
    std::vector<char> log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteShader(shader);
    throw RenderError(located(file, log.data()));
}

}  // namespace

std::string located(std::string_view file, const std::string& log) {
    static const std::regex place("^(ERROR: )?[0-9]+[:(]([0-9]+)\\)?(\\([0-9]+\\))? ?: *");
    std::smatch found;
    if (!std::regex_search(log, found, place)) return std::string(file) + ": " + log;
    return std::string(file) + ':' + found[2].str() + ": " + (found[1].matched ? "error: " : "") +
           found.suffix().str();
}

Program::Program(std::string_view vertex, std::string_view fragment)
    : Program(std::string(vertex) + ".vert", text_of(std::string(vertex) + ".vert"),
              std::string(fragment) + ".frag", text_of(std::string(fragment) + ".frag")) {}

Program::Program(std::string_view vertex_file, std::string_view vertex_source,
                 std::string_view fragment_file, std::string_view fragment_source) {
    const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_file, vertex_source);
    const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_file, fragment_source);
    name_ = glCreateProgram();
    glAttachShader(name_, vertex);
    glAttachShader(name_, fragment);
    glLinkProgram(name_);
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint ok = GL_FALSE;
    glGetProgramiv(name_, GL_LINK_STATUS, &ok);
    if (ok == GL_TRUE) return;
    std::vector<char> log(4096, '\0');
    glGetProgramInfoLog(name_, static_cast<GLsizei>(log.size()), nullptr, log.data());
    glDeleteProgram(name_);
    throw RenderError(std::string(vertex_file) + " + " + std::string(fragment_file) + ": " +
                      log.data());
}

Program::~Program() {
    if (name_ != 0) glDeleteProgram(name_);
}

Program::Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}

void Program::set(const char* uniform, int value) const {
    glUniform1i(find(uniform), value);
}
void Program::set(const char* uniform, float value) const {
    glUniform1f(find(uniform), value);
}
void Program::set(const char* uniform, const Eigen::Vector2f& value) const {
    glUniform2fv(find(uniform), 1, value.data());
}
void Program::set(const char* uniform, const Eigen::Vector3f& value) const {
    glUniform3fv(find(uniform), 1, value.data());
}
void Program::set(const char* uniform, const Eigen::Vector4f& value) const {
    glUniform4fv(find(uniform), 1, value.data());
}
void Program::set(const char* uniform, const Eigen::Matrix4f& value) const {
    glUniformMatrix4fv(find(uniform), 1, GL_FALSE, value.data());
}
void Program::set_array(const char* uniform, int count, const Eigen::Vector4f* values) const {
    glUniform4fv(find(uniform), count, values->data());
}

void use_asset_folder(const std::filesystem::path& folder) {
    replaced_assets().clear();
    if (folder.empty()) return;
    for (const Asset& a : assets()) {
        std::ifstream file(folder / a.name, std::ios::binary);
        if (!file) continue;
        replaced_assets()[a.name] = {std::istreambuf_iterator<char>(file), {}};
    }
    if (replaced_assets().empty()) {
        throw RenderError(folder.string() + ": no shader and no texture of this program in there");
    }
}

std::span<const unsigned char> asset(std::string_view name) {
    const auto replaced = replaced_assets().find(name);
    if (replaced != replaced_assets().end()) return replaced->second;
    for (const Asset& a : assets()) {
        if (a.name == name) return a.bytes;
    }
    throw RenderError("no embedded file " + std::string(name));
}

}  // namespace ember
