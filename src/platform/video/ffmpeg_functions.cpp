#include "video/ffmpeg_functions.h"

#include <array>
#include <dlfcn.h>
#include <string>

#include "base/error.h"

namespace rotatebook::video {
namespace {

constexpr std::array kLibraries{"libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR),
                                "libswscale.so." AV_STRINGIFY(LIBSWSCALE_VERSION_MAJOR),
                                "libavfilter.so." AV_STRINGIFY(LIBAVFILTER_VERSION_MAJOR)};

std::string failureText(const std::string& cause) {
  return "can't load FFmpeg: " + cause;
}

/// Returns the library; if it can't be loaded, null, and the cause is dlerror().
void* load(const char* library) {
  return dlopen(library, RTLD_LAZY | RTLD_LOCAL);
}

}  // namespace

void* ffmpegAddress(const char* name) {
  // Of a program that is linked to FFmpeg, and those that tests put in place of FFmpeg's.
  if (void* found = dlsym(RTLD_DEFAULT, name)) return found;
  std::string cause = "it lacks " + std::string(name);
  for (const char* library : kLibraries) {
    void* handle = load(library);
    if (handle == nullptr) {
      cause = dlerror();
      break;
    }
    // Its libraries are searched, too: libavcodec and libavutil.
    if (void* found = dlsym(handle, name)) return found;
  }
  throw MachineError(failureText(cause) + "; " + kInstallFfmpeg);
}

std::string ffmpegFailure() {
  if (dlsym(RTLD_DEFAULT, "avformat_open_input") != nullptr) return "";
  for (const char* library : kLibraries) {
    if (load(library) == nullptr) return failureText(dlerror());
  }
  return "";
}

}  // namespace rotatebook::video
