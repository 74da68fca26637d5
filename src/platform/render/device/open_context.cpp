#include "render/device/open_context.h"

#include <array>
#include <map>
#include <mutex>

#include <epoxy/gl.h>
#include <fmt/core.h>

#include "render/device/egl_error.h"

namespace rotatebook::render {
namespace {

/// Creates a context and makes it current. Returns EGL_NO_CONTEXT, and the reason in `failure`, if
/// that fails.
EGLContext makeCurrentContext(EGLDisplay display, CallFailure& failure) {
  for (const char* extension : {"EGL_KHR_no_config_context", "EGL_KHR_surfaceless_context"}) {
    if (epoxy_has_egl_extension(display, extension)) continue;
    failure = {extension, "missing"};
    return EGL_NO_CONTEXT;
  }
  const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                            3,
                                            EGL_CONTEXT_MINOR_VERSION,
                                            3,
                                            EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                            EGL_NONE};
  EGLContext context = EGL_NO_CONTEXT;
  if (!eglBindAPI(EGL_OPENGL_API)) {
    failure = {"eglBindAPI", takeEglError()};
  } else if (context =
                 eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
             context == EGL_NO_CONTEXT) {
    failure = {"eglCreateContext for OpenGL 3.3 core", takeEglError()};
  } else if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    failure = {"eglMakeCurrent", takeEglError()};
    eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
  }
  return context;
}

/// Counts each display's contexts. EGL doesn't: terminating a display ends the contexts of all
/// threads on it.
class DisplayUsers {
 public:
  void add(EGLDisplay display) { ++counts_[display]; }
  /// Terminates the display if it has no contexts.
  void terminateUnused(EGLDisplay display) {
    if (counts_[display] == 0) eglTerminate(display);
  }
  void remove(EGLDisplay display) {
    --counts_[display];
    terminateUnused(display);
  }

  std::mutex mutex;  // Held while a display is initialised, creates a context or is terminated.

 private:
  std::map<EGLDisplay, int> counts_;
};

DisplayUsers& displayUsers() {
  static DisplayUsers users;
  return users;
}

std::string glText(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text == nullptr ? "unknown" : text;
}

ContextInfo infoOfCurrent() {
  ContextInfo info{glText(GL_VENDOR), glText(GL_RENDERER), "", 0};
  const int version = epoxy_gl_version();
  info.version = fmt::format("{}.{}", version / 10, version % 10);
  glGetIntegerv(GL_MAX_SAMPLES, &info.samples);
  return info;
}

}  // namespace

std::unique_ptr<OpenContext> OpenContext::open(const Opener& opener, CallFailure& failure) {
  const std::lock_guard lock(displayUsers().mutex);
  EGLDisplay display = opener.open();
  if (display == EGL_NO_DISPLAY) {
    failure = {opener.call, takeEglError()};
    return nullptr;
  }
  if (!eglInitialize(display, nullptr, nullptr)) {
    failure = {"eglInitialize", takeEglError()};
    return nullptr;
  }
  EGLContext context = makeCurrentContext(display, failure);
  if (context != EGL_NO_CONTEXT) {
    displayUsers().add(display);
    return std::unique_ptr<OpenContext>(new OpenContext(display, context));
  }
  displayUsers().terminateUnused(display);
  return nullptr;
}

OpenContext::OpenContext(EGLDisplay display, EGLContext context)
    : display_(display), context_(context), info_(infoOfCurrent()) {}

OpenContext::~OpenContext() {
  const std::lock_guard lock(displayUsers().mutex);
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  displayUsers().remove(display_);
}

}  // namespace rotatebook::render
