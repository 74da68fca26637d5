// Names EGL's error codes. Inside the room only.
#pragma once

#include <string>

namespace rotatebook::render {

/// Returns the name of this thread's last EGL error, e.g. "EGL_NOT_INITIALIZED", and clears it.
std::string takeEglError();

}  // namespace rotatebook::render
