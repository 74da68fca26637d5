#include "render/device/egl_displays.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <dlfcn.h>
#include <string>
#include <string_view>
#include <unistd.h>

#include <fmt/core.h>

#include "render/device/egl_error.h"

namespace rotatebook::render {
namespace {

constexpr EGLint kDrmRenderNode = 0x3377;  // EGL_DRM_RENDER_NODE_FILE_EXT; libepoxy 1.5 lacks it.
constexpr const char* kNvidiaCard = "/dev/nvidia0";

/// Returns whether an extension list of EGL's, separated by spaces, contains `word`.
bool hasWord(std::string_view list, std::string_view word) {
  const auto isSpace = [&](std::size_t at) { return at >= list.size() || list[at] == ' '; };
  for (auto at = list.find(word); at != list.npos; at = list.find(word, at + 1)) {
    if ((at == 0 || isSpace(at - 1)) && isSpace(at + word.size())) return true;
  }
  return false;
}

std::string deviceString(EGLDeviceEXT device, EGLint name) {
  const char* text = eglQueryDeviceStringEXT(device, name);
  if (text == nullptr) eglGetError();
  return text == nullptr ? "" : text;
}

DisplayCandidate describeDevice(EGLDeviceEXT device, int index) {
  DisplayCandidate candidate{.index = index};
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query") &&
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_base")) {
    return candidate;
  }
  const std::string extensions = deviceString(device, EGL_EXTENSIONS);
  candidate.software = hasWord(extensions, "EGL_MESA_device_software");
  if (hasWord(extensions, "EGL_EXT_device_drm")) {
    candidate.drmNode = deviceString(device, EGL_DRM_DEVICE_FILE_EXT);
  }
  if (hasWord(extensions, "EGL_EXT_device_drm_render_node")) {
    candidate.renderNode = deviceString(device, kDrmRenderNode);
  }
  candidate.nvidia = hasWord(extensions, "EGL_NV_device_cuda");
  EGLAttrib id = 0;
  if (candidate.nvidia && eglQueryDeviceAttribEXT(device, EGL_CUDA_DEVICE_NV, &id)) {
    candidate.cudaId = static_cast<int>(id);
  }
  return candidate;
}

void addDevices(EglDisplays& candidates) {
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    candidates.list.failure = {"EGL_EXT_platform_device", "missing"};
    return;
  }
  std::array<EGLDeviceEXT, 32> devices;
  EGLint count = 0;
  // Fails with EGL_BAD_ALLOC if a vendor's library is installed without its card.
  if (!eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
    candidates.list.failure = {"eglQueryDevicesEXT", takeEglError()};
    return;
  }
  for (int i = 0; i < count; ++i) {
    EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    candidates.list.candidates.push_back(describeDevice(device, i));
    candidates.openers.push_back(
        {"eglGetPlatformDisplayEXT",
         [device] { return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr); }});
  }
}

}  // namespace

std::optional<CallFailure> missingLibrary() {
  const auto has = [](const char* name, int flags) { return dlopen(name, flags) != nullptr; };
  if (!has("libEGL.so.1", RTLD_LAZY | RTLD_GLOBAL)) return CallFailure{"dlopen", dlerror()};
  if (has("libOpenGL.so.0", RTLD_LAZY) || has("libGL.so.1", RTLD_LAZY)) return {};
  return CallFailure{"dlopen", dlerror()};
}

EglDisplays listDisplays() {
  EglDisplays candidates;
  addDevices(candidates);
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
    candidates.list.candidates.push_back({.kind = DisplayCandidate::Kind::Surfaceless});
    candidates.openers.push_back({"eglGetPlatformDisplayEXT", [] {
                                    return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                                    EGL_DEFAULT_DISPLAY, nullptr);
                                  }});
  }
  candidates.list.candidates.push_back({.kind = DisplayCandidate::Kind::Default});
  candidates.openers.push_back(
      {"eglGetDisplay", [] { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }});
  if (std::ranges::none_of(candidates.list.candidates, &DisplayCandidate::nvidia) &&
      access(kNvidiaCard, F_OK) == 0) {
    candidates.list.unlistedCard = fmt::format("NVIDIA's card ({})", kNvidiaCard);
  }
  return candidates;
}

}  // namespace rotatebook::render
