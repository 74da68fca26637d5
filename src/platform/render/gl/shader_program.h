// Compiles and links vertex and fragment shaders. Inside the room only.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "render/gl/gl_handles.h"

namespace rotatebook::render {

/// The source of one shader: one text, or several that are compiled as one, in this order.
struct ShaderSource {
  ShaderSource(std::string_view text) : texts{text} {}
  ShaderSource(const char* text) : texts{text} {}
  ShaderSource(std::initializer_list<std::string_view> all) : texts(all) {}

  std::vector<std::string_view> texts;
};

/// A linked GL program.
class ShaderProgram {
 public:
  /// `name` is for messages; one of the fragment shaders has main(). Throws MachineError with the
  /// compiler's or linker's log.
  ShaderProgram(const std::string& name, const ShaderSource& vertexSource,
                std::initializer_list<ShaderSource> fragmentSources);

  void use() const { glUseProgram(program_.name()); }

  /// Sets a uniform of the program in use; ignores one that the compiler optimised away.
  void set(const char* uniform, int value) const;
  void set(const char* uniform, const Eigen::Vector2f& value) const;
  void set(const char* uniform, const Eigen::Vector3f& value) const;
  void set(const char* uniform, const Eigen::Matrix4f& value) const;
  /// Sets an array of eight vec3.
  void set(const char* uniform, const Eigen::Matrix<float, 3, 8>& values) const;

 private:
  GLint location(const char* uniform) const {
    return glGetUniformLocation(program_.name(), uniform);
  }

  GlProgram program_;
};

}  // namespace rotatebook::render
