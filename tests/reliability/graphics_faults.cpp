// Calls of EGL and OpenGL that tell of failures. The program finds them by dlsym().
#include <cstring>
#include <dlfcn.h>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "reliability/faults.h"

namespace {

using rotatebook::faults::fails;

using Dlsym = void*(void*, const char*);

Dlsym* systemDlsym() {
  static auto* const found =
      reinterpret_cast<Dlsym*>(dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34") != nullptr
                                   ? dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.34")
                                   : dlvsym(RTLD_NEXT, "dlsym", "GLIBC_2.2.5"));
  return found;
}

// The calls that they stand for, once they were looked up.
PFNGLGETERRORPROC nextGetError;
PFNGLCHECKFRAMEBUFFERSTATUSPROC nextFramebufferStatus;
PFNGLGETSHADERIVPROC nextGetShader;
PFNGLGETPROGRAMIVPROC nextGetProgram;
PFNEGLINITIALIZEPROC nextInitialize;
PFNEGLCREATECONTEXTPROC nextCreateContext;
PFNEGLMAKECURRENTPROC nextMakeCurrent;

GLenum getError() {
  return fails("graphics") ? GLenum{GL_OUT_OF_MEMORY} : nextGetError();
}

GLenum framebufferStatus(GLenum target) {
  return fails("graphics") ? GLenum{GL_FRAMEBUFFER_UNSUPPORTED} : nextFramebufferStatus(target);
}

void getShader(GLuint shader, GLenum name, GLint* value) {
  nextGetShader(shader, name, value);
  if (name == GL_COMPILE_STATUS && fails("graphics")) *value = GL_FALSE;
}

void getProgram(GLuint program, GLenum name, GLint* value) {
  nextGetProgram(program, name, value);
  if (name == GL_LINK_STATUS && fails("graphics")) *value = GL_FALSE;
}

EGLBoolean initialize(EGLDisplay display, EGLint* major, EGLint* minor) {
  return fails("graphics") ? EGLBoolean{EGL_FALSE} : nextInitialize(display, major, minor);
}

EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext shared,
                         const EGLint* attributes) {
  return fails("graphics") ? EGL_NO_CONTEXT
                           : nextCreateContext(display, config, shared, attributes);
}

EGLBoolean makeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  const bool ends = context == EGL_NO_CONTEXT;
  return !ends && fails("graphics") ? EGLBoolean{EGL_FALSE}
                                    : nextMakeCurrent(display, draw, read, context);
}

/// `replacement` in the place of what was found, which it keeps.
template <typename Function>
void* instead(void* found, Function*& keep, Function* replacement) {
  keep = reinterpret_cast<Function*>(found);
  return reinterpret_cast<void*>(replacement);
}

/// Returns the replacement of a function of this name, or the function itself.
void* replaced(const char* name, void* found) {
  const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
  if (is("glGetError")) return instead(found, nextGetError, getError);
  if (is("glCheckFramebufferStatus")) {
    return instead(found, nextFramebufferStatus, framebufferStatus);
  }
  if (is("glGetShaderiv")) return instead(found, nextGetShader, getShader);
  if (is("glGetProgramiv")) return instead(found, nextGetProgram, getProgram);
  if (is("eglInitialize")) return instead(found, nextInitialize, initialize);
  if (is("eglCreateContext")) return instead(found, nextCreateContext, createContext);
  if (is("eglMakeCurrent")) return instead(found, nextMakeCurrent, makeCurrent);
  return found;
}

PFNEGLGETPROCADDRESSPROC nextGetProcAddress;

__eglMustCastToProperFunctionPointerType getProcAddress(const char* name) {
  void* found = reinterpret_cast<void*>(nextGetProcAddress(name));
  return reinterpret_cast<__eglMustCastToProperFunctionPointerType>(
      found != nullptr ? replaced(name, found) : found);
}

}  // namespace

extern "C" void* dlsym(void* library, const char* name) {
  Dlsym* const system = systemDlsym();
  // RTLD_NEXT depends on who calls: this must be a jump, see CMakeLists.txt.
  if (library == RTLD_NEXT) return system(library, name);
  void* found = system(library, name);
  if (found == nullptr || !rotatebook::faults::isWanted("graphics")) return found;
  if (std::strcmp(name, "eglGetProcAddress") == 0) {
    return instead(found, nextGetProcAddress, getProcAddress);
  }
  return replaced(name, found);
}
