#include "render/gl/shader_program.h"

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::render {
namespace {

std::string compilerLog(GLuint shader) {
  GLint length = 0;
  glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader, length, nullptr, log.data());
  return log;
}

std::string linkerLog(GLuint program) {
  GLint length = 0;
  glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program, length, nullptr, log.data());
  return log;
}

void attach(GLuint program, GLenum type, const std::string& name, const ShaderSource& source) {
  const GLuint shader = glCreateShader(type);
  std::vector<const char*> texts;
  std::vector<GLint> lengths;
  for (const std::string_view text : source.texts) {
    texts.push_back(text.data());
    lengths.push_back(static_cast<GLint>(text.size()));
  }
  glShaderSource(shader, static_cast<GLsizei>(texts.size()), texts.data(), lengths.data());
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // It lives as long as the program.
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_FALSE) {
    throw MachineError(fmt::format("can't compile the shader {}: {}", name, compilerLog(shader)));
  }
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& name, const ShaderSource& vertexSource,
                             std::initializer_list<ShaderSource> fragmentSources) {
  attach(program_.name(), GL_VERTEX_SHADER, name + ".vert", vertexSource);
  for (const ShaderSource& source : fragmentSources) {
    attach(program_.name(), GL_FRAGMENT_SHADER, name + ".frag", source);
  }
  glLinkProgram(program_.name());
  GLint linked = 0;
  glGetProgramiv(program_.name(), GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    throw MachineError(
        fmt::format("can't link the shaders {}: {}", name, linkerLog(program_.name())));
  }
}

void ShaderProgram::set(const char* uniform, int value) const {
  glUniform1i(location(uniform), value);
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector2f& value) const {
  glUniform2fv(location(uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Vector3f& value) const {
  glUniform3fv(location(uniform), 1, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.data());
}

void ShaderProgram::set(const char* uniform, const Eigen::Matrix<float, 3, 8>& values) const {
  glUniform3fv(location(uniform), 8, values.data());
}

}  // namespace rotatebook::render
