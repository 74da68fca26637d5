#include "render/device/egl_error.h"

#include <array>

#include <epoxy/egl.h>
#include <fmt/core.h>

namespace rotatebook::render {
namespace {

struct NamedError {
  EGLint code;
  const char* name;
};

constexpr std::array kErrors = {
    NamedError{EGL_SUCCESS, "EGL_SUCCESS"},
    NamedError{EGL_NOT_INITIALIZED, "EGL_NOT_INITIALIZED"},
    NamedError{EGL_BAD_ACCESS, "EGL_BAD_ACCESS"},
    NamedError{EGL_BAD_ALLOC, "EGL_BAD_ALLOC"},
    NamedError{EGL_BAD_ATTRIBUTE, "EGL_BAD_ATTRIBUTE"},
    NamedError{EGL_BAD_CONFIG, "EGL_BAD_CONFIG"},
    NamedError{EGL_BAD_CONTEXT, "EGL_BAD_CONTEXT"},
    NamedError{EGL_BAD_CURRENT_SURFACE, "EGL_BAD_CURRENT_SURFACE"},
    NamedError{EGL_BAD_DISPLAY, "EGL_BAD_DISPLAY"},
    NamedError{EGL_BAD_MATCH, "EGL_BAD_MATCH"},
    NamedError{EGL_BAD_NATIVE_PIXMAP, "EGL_BAD_NATIVE_PIXMAP"},
    NamedError{EGL_BAD_NATIVE_WINDOW, "EGL_BAD_NATIVE_WINDOW"},
    NamedError{EGL_BAD_PARAMETER, "EGL_BAD_PARAMETER"},
    NamedError{EGL_BAD_SURFACE, "EGL_BAD_SURFACE"},
    NamedError{EGL_CONTEXT_LOST, "EGL_CONTEXT_LOST"},
    NamedError{EGL_BAD_DEVICE_EXT, "EGL_BAD_DEVICE_EXT"},
};

}  // namespace

std::string takeEglError() {
  const EGLint code = eglGetError();
  for (const NamedError& error : kErrors) {
    if (error.code == code) return error.name;
  }
  return fmt::format("EGL error {}", code);
}

}  // namespace rotatebook::render
