#include "render/egl_context.h"

#include <array>
#include <dlfcn.h>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "base/error.h"
#include "render/egl_error.h"

namespace rotatebook::render {
namespace {

constexpr const char* kRemedy =
    "\nInstall Mesa's software rasteriser (Debian, Ubuntu: apt-get install libegl1 libegl-mesa0 "
    "libgl1-mesa-dri), or for a graphics card its driver's EGL library, and see that you may read "
    "/dev/dri/renderD*.";

/// One way to a display, to be tried.
struct Way {
  std::string name;
  std::function<EGLDisplay()> open;
};

struct OpenedContext {
  EGLDisplay display;
  EGLContext context;
};

// libepoxy ends the process where it finds no library, so look before it does.
void requireLibraries() {
  if (dlopen("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL) == nullptr) {
    throw MachineError(std::string("can't draw: there is no EGL on this machine: ") + dlerror() +
                       kRemedy);
  }
  if (dlopen("libOpenGL.so.0", RTLD_LAZY) == nullptr &&
      dlopen("libGL.so.1", RTLD_LAZY) == nullptr) {
    throw MachineError(std::string("can't draw: there is no OpenGL on this machine: ") + dlerror() +
                       " (Debian, Ubuntu: apt-get install libopengl0)");
  }
}

void addDevices(std::vector<Way>& ways, std::string& failures) {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    failures += "\n  EGL devices: EGL_EXT_platform_device is missing";
    return;
  }
  std::array<EGLDeviceEXT, 32> devices;
  EGLint count = 0;
  // Fails with EGL_BAD_ALLOC where a vendor's library is installed without its card.
  if (!eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
    failures += "\n  EGL devices: eglQueryDevicesEXT: " + takeEglError();
    return;
  }
  if (count == 0) failures += "\n  EGL devices: none";
  for (int i = 0; i < count; ++i) {
    EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    ways.push_back({"EGL device " + std::to_string(i), [device] {
                      return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
                    }});
  }
}

std::vector<Way> listWays(std::string& failures) {
  std::vector<Way> ways;
  addDevices(ways, failures);
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    ways.push_back({"surfaceless EGL", [] {
                      return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                      EGL_DEFAULT_DISPLAY, nullptr);
                    }});
  }
  ways.push_back({"default EGL display", [] { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }});
  return ways;
}

/// Nothing but the reason in `failure` if this display has no context for us.
EGLContext makeCurrentContext(EGLDisplay display, std::string& failure) {
  if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context") ||
      !epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) {
    failure = "EGL_KHR_no_config_context or EGL_KHR_surfaceless_context is missing";
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
    failure = "eglBindAPI: " + takeEglError();
  } else if (context =
                 eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
             context == EGL_NO_CONTEXT) {
    failure = "eglCreateContext for OpenGL 3.3 core: " + takeEglError();
  } else if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    failure = "eglMakeCurrent: " + takeEglError();
    eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
  }
  return context;
}

/// How many contexts each display has. EGL doesn't count: whoever ends a display takes the contexts
/// of all threads from it.
class DisplayUsers {
 public:
  void add(EGLDisplay display) { ++counts_[display]; }
  /// Ends the display if nobody uses it.
  void endUnused(EGLDisplay display) {
    if (counts_[display] == 0) eglTerminate(display);
  }
  void remove(EGLDisplay display) {
    --counts_[display];
    endUnused(display);
  }

  std::mutex mutex;  // Held while a display begins, gives a context and ends.

 private:
  std::map<EGLDisplay, int> counts_;
};

DisplayUsers& displayUsers() {
  static DisplayUsers users;
  return users;
}

std::optional<OpenedContext> tryWay(const Way& way, std::string& failures) {
  const std::string start = "\n  " + way.name + ": ";
  EGLDisplay display = way.open();
  if (display == EGL_NO_DISPLAY) {
    failures += start + "no display: " + takeEglError();
    return {};
  }
  if (!eglInitialize(display, nullptr, nullptr)) {
    failures += start + "eglInitialize: " + takeEglError();
    return {};
  }
  std::string failure;
  if (EGLContext context = makeCurrentContext(display, failure); context != EGL_NO_CONTEXT) {
    displayUsers().add(display);
    return OpenedContext{display, context};
  }
  failures += start + failure;
  displayUsers().endUnused(display);
  return {};
}

std::string describeRenderer(const std::string& way) {
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  const int version = epoxy_gl_version();
  return std::string(renderer != nullptr ? renderer : "unknown renderer") + ", OpenGL " +
         std::to_string(version / 10) + "." + std::to_string(version % 10) + ", " + way;
}

}  // namespace

EglContext::EglContext() {
  requireLibraries();
  const std::lock_guard lock(displayUsers().mutex);
  std::string failures;
  for (const Way& way : listWays(failures)) {
    if (const auto opened = tryWay(way, failures)) {
      display_ = opened->display;
      context_ = opened->context;
      description_ = describeRenderer(way.name);
      return;
    }
  }
  throw MachineError("can't draw: no EGL display gives an OpenGL 3.3 core context:" + failures +
                     kRemedy);
}

EglContext::~EglContext() {
  const std::lock_guard lock(displayUsers().mutex);
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  displayUsers().remove(display_);
}

}  // namespace rotatebook::render
