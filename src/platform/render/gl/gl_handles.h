// Move-only owners of OpenGL objects. Inside the room only.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace rotatebook::render {

/// Owns one GL object name; the moved-from state (name 0) is the only empty one. Construct and
/// destroy it with its context current. `Functions` has static create() and destroy(name).
template <typename Functions>
class GlHandle {
 public:
  GlHandle() : name_(Functions::create()) {}
  GlHandle(GlHandle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlHandle& operator=(GlHandle&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlHandle() {
    if (name_ != 0) Functions::destroy(name_);
  }

  GLuint name() const { return name_; }

 private:
  GLuint name_;
};

namespace gl_functions {

/// Wraps glGenX and glDeleteX for an object type X.
#define ROTATEBOOK_GL_FUNCTIONS(Type, generate, remove)    \
  struct Type {                                            \
    static GLuint create() {                               \
      GLuint name = 0;                                     \
      generate(1, &name);                                  \
      return name;                                         \
    }                                                      \
    static void destroy(GLuint name) { remove(1, &name); } \
  }
ROTATEBOOK_GL_FUNCTIONS(Buffer, glGenBuffers, glDeleteBuffers);
ROTATEBOOK_GL_FUNCTIONS(VertexArray, glGenVertexArrays, glDeleteVertexArrays);
ROTATEBOOK_GL_FUNCTIONS(Texture, glGenTextures, glDeleteTextures);
ROTATEBOOK_GL_FUNCTIONS(Framebuffer, glGenFramebuffers, glDeleteFramebuffers);
ROTATEBOOK_GL_FUNCTIONS(Renderbuffer, glGenRenderbuffers, glDeleteRenderbuffers);
#undef ROTATEBOOK_GL_FUNCTIONS

struct Program {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint name) { glDeleteProgram(name); }
};

}  // namespace gl_functions

using GlBuffer = GlHandle<gl_functions::Buffer>;
using GlVertexArray = GlHandle<gl_functions::VertexArray>;
using GlTexture = GlHandle<gl_functions::Texture>;
using GlFramebuffer = GlHandle<gl_functions::Framebuffer>;
using GlRenderbuffer = GlHandle<gl_functions::Renderbuffer>;
using GlProgram = GlHandle<gl_functions::Program>;

}  // namespace rotatebook::render
