#include "video/ffmpeg_functions.h"

#include <dlfcn.h>
#include <string>

#include <fmt/core.h>

#include "base/error.h"

namespace rotatebook::video {

void* ffmpegAddress(const char* name) {
  // Of a program that is linked to FFmpeg, and those that tests put in place of FFmpeg's.
  if (void* found = dlsym(RTLD_DEFAULT, name)) return found;
  std::string problem = "it lacks " + std::string(name);
  for (const char* library : {"libavformat.so." AV_STRINGIFY(LIBAVFORMAT_VERSION_MAJOR),
                              "libswscale.so." AV_STRINGIFY(LIBSWSCALE_VERSION_MAJOR),
                              "libavfilter.so." AV_STRINGIFY(LIBAVFILTER_VERSION_MAJOR)}) {
    void* handle = dlopen(library, RTLD_LAZY | RTLD_LOCAL);
    if (handle == nullptr) {
      problem = dlerror();
      break;
    }
    // Its libraries are searched, too: libavcodec and libavutil.
    if (void* found = dlsym(handle, name)) return found;
  }
  throw MachineError(fmt::format(
      "can't load FFmpeg: {}; install the version that the program was built with", problem));
}

}  // namespace rotatebook::video
